// The joints of one robot, to be posed by hand.
#pragma once

#include <QVector>
#include <QWidget>
#include <vector>

#include "core/view/snapshot.hpp"

class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace abstand::ui {

class JointRow;

/// A row for each joint; without an edit they follow the robot. GUI thread only.
class JointEditor : public QWidget {
  Q_OBJECT

 public:
  explicit JointEditor(QWidget* parent = nullptr);

  /// `robot`: index into SceneOutline::robots; -1: none.
  void open(const view::SceneOutline& outline, int robot);
  /// What the document says (rad, m): shown instead of the moment's values. Empty: the robot follows its
  /// motion.
  void setPosed(const QVector<double>& posed);
  void refresh(const view::SceneSnapshot& snapshot);
  JointRow* row(int joint) const { return rows_[static_cast<std::size_t>(joint)]; }
  QPushButton* followButton() const { return follow_; }
  /// Its menu copies what is shown.
  QToolButton* copyButton() const { return copy_; }

 Q_SIGNALS:
  /// By the user; `joint` counts from the robot's first.
  void edited(int robot, int joint, double value);
  /// The user has let go of a slider.
  void released();
  void followWanted(int robot);

 private:
  void showState();

  int robot_{-1}, first_joint_{0};
  QString name_;
  QVector<double> posed_;
  QLabel* state_;
  QPushButton* follow_;
  QToolButton* copy_;
  QStringList names_;
  QVector<double> shown_;  ///< rad, m
  QVBoxLayout* layout_;
  std::vector<JointRow*> rows_;
};

}  // namespace abstand::ui
