// The tree of groups and objects.
#pragma once

#include <QTreeView>

namespace abstand::ui {

class SceneTreeModel;
class Selection;

/// Selection follows the shared one, and leads it. GUI thread only.
class SceneTreePanel : public QTreeView {
  Q_OBJECT

 public:
  SceneTreePanel(SceneTreeModel& model, Selection& selection, QWidget* parent = nullptr);

 private:
  void choose();
  void followSelection();

  SceneTreeModel& tree_;
  Selection& selection_;
  bool choosing_{false};
};

}  // namespace abstand::ui
