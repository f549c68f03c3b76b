// Laws of the robots that react, and their numbers, while they run.
#pragma once

#include <QMap>
#include <QWidget>
#include <vector>

#include "core/control/reaction_change.hpp"
#include "core/view/snapshot.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace abstand::ui {

class LawRow;
class ResponseRow;

/// Shows one robot at a time. What does not fit the robot is refused with a sentence below its field, and is
/// no edit. GUI thread only.
class ReactionPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ReactionPanel(QWidget* parent = nullptr);

  /// The outline must outlive its stay here.
  void open(const view::SceneOutline& outline);
  /// By robot, as the document has them; without a signal.
  void setReactions(const QMap<QString, control::ReactionChange>& reactions);
  /// Of SceneOutline::reacting.
  void showRobot(int robot);
  const std::vector<LawRow*>& rows() const { return rows_; }

 Q_SIGNALS:
  /// By the user. `what`: for the name of the edit; edits with the same `merge_key` belong together.
  void edited(const QString& robot, const abstand::control::ReactionChange& change, const QString& what,
              const QString& merge_key);
  /// The user has left a field: the next edit is another one.
  void released();

 private:
  struct Law {
    std::string name;
    QCheckBox* box{nullptr};  ///< null: always active
    QWidget* numbers{nullptr};
  };
  void build();
  void addLaw(const control::LawState& law, int joints);
  void refresh();
  void take(LawRow& row, const config::JointNumbers& numbers);
  void switchLaw(const std::string& name, bool on);
  void choose(safety::StopReason reason, safety::StopResponse response);
  std::string problemOfSwitching(const control::LawState& law) const;
  QString robot() const;
  int joints() const;
  const control::ReactionDescription* scene() const;
  control::ReactionChange change() const { return reactions_.value(robot()); }

  const view::SceneOutline* outline_;
  QMap<QString, control::ReactionChange> reactions_;
  QComboBox* robots_;
  QLabel* head_;
  QPushButton* back_;
  QVBoxLayout* list_;
  std::vector<Law> laws_;
  std::vector<LawRow*> rows_;
  std::vector<ResponseRow*> responses_;
};

}  // namespace abstand::ui
