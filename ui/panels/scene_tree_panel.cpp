// The tree of groups and objects.
#include "ui/panels/scene_tree_panel.hpp"

#include <QHeaderView>
#include <QScopedValueRollback>

#include "ui/model/scene_tree_model.hpp"
#include "ui/model/selection.hpp"

namespace abstand::ui {

namespace {
constexpr int kTreeStateSpace = 16;  // px, about the text of a state
}

SceneTreePanel::SceneTreePanel(SceneTreeModel& model, Selection& selection, QWidget* parent)
    : QTreeView(parent), tree_{model}, selection_{selection} {
  setModel(&model);
  setAccessibleName(tr("Scene tree"));
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setUniformRowHeights(true);
  setDragEnabled(true);
  setAllColumnsShowFocus(true);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setSectionResizeMode(1, QHeaderView::Fixed);
  header()->resizeSection(1, fontMetrics().horizontalAdvance(tr("⚠ inside margin")) + kTreeStateSpace);
  connect(&model, &SceneTreeModel::modelReset, this, &QTreeView::expandAll);
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &SceneTreePanel::choose);
  connect(&selection_, &Selection::changed, this, &SceneTreePanel::followSelection);
}

void SceneTreePanel::choose() {
  if (choosing_) return;
  std::vector<int> objects;
  for (const QModelIndex& index : selectionModel()->selectedRows()) {
    const std::vector<int> more = tree_.objectsOf(index);
    objects.insert(objects.end(), more.begin(), more.end());
  }
  std::sort(objects.begin(), objects.end());
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  const QScopedValueRollback guard(choosing_, true);
  selection_.setObjects(std::move(objects));
}

void SceneTreePanel::followSelection() {
  if (choosing_) return;
  const QScopedValueRollback guard(choosing_, true);
  QItemSelection rows;
  for (const int object : selection_.objects()) {
    const QModelIndex index = tree_.indexOf(object);
    rows.select(index, index.siblingAtColumn(1));
  }
  selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
  if (!selection_.objects().empty()) scrollTo(tree_.indexOf(selection_.objects().front()));
}

}  // namespace abstand::ui
