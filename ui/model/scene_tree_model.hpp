// Groups and their objects, with visibility and the present state of each.
#pragma once

#include <QAbstractItemModel>
#include <functional>
#include <vector>

#include "ui/model/body_state.hpp"
#include "ui/model/groups.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

/// Two levels: groups, objects. Column 0: name with check box (shown in the viewport) and colour; column 1:
/// "touching", "inside margin" or the distance to the nearest other object. GUI thread only.
class SceneTreeModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  explicit SceneTreeModel(QObject* parent = nullptr);

  void open(const view::SceneOutline& outline);
  /// Takes over states and distances; tells the views only about what changed.
  void refresh(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot);
  /// SceneSnapshot::step of the last refresh.
  long shownStep() const { return shown_step_; }
  void setTheme(Theme theme);
  /// What the tool tip says of a body; asked for while the pointer rests over it.
  void setSentence(std::function<QString(int object)> sentence) { sentence_ = std::move(sentence); }
  void setVisible(int object, bool visible);

  const std::vector<Group>& groups() const { return groups_; }
  /// Objects of an index: one, or all of a group.
  std::vector<int> objectsOf(const QModelIndex& index) const;
  QModelIndex indexOf(int object) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Bodies, for the plots.
  QMimeData* mimeData(const QModelIndexList& indexes) const override;

 Q_SIGNALS:
  void visibilityChanged(int object, bool visible);
  /// The user has ticked these, all at once.
  void visibilityEdited(const std::vector<int>& objects, bool visible);

 private:
  struct Row {
    QString name, full_name;
    int group{0}, row{0};
    bool visible{true};
    PairLevel level{PairLevel::kApart};  // touching, inside a margin, or neither
    bool hollow{false};                  // the pose is stale or was rejected
    double distance{kNaN};               // m, to the nearest other object
  };

  QVariant groupData(const QModelIndex& index, int role) const;
  QVariant objectData(int object, int column, int role) const;
  QColor colour(const Group& group) const;

  std::vector<Group> groups_;
  std::vector<Row> rows_;  // by object
  std::vector<double> nearest_;
  std::vector<BodyState> states_;
  std::function<QString(int)> sentence_;
  bool of_people_{false};  // the scene has pairs of people and robots
  long shown_step_{-1};
  Theme theme_{Theme::kLight};
};

}  // namespace abstand::ui
