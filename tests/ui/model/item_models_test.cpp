// Scene tree and pair table as models, and what selection does to them.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>

#include "tests/ui/fake_session.hpp"
#include "ui/model/nearest_classes.hpp"
#include "ui/model/pair_table_model.hpp"
#include "ui/model/scene_tree_model.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/scene_tree_panel.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {
namespace item_models_test {

using Mode = QAbstractItemModelTester::FailureReportingMode;

/// A failure of Qt's model tester is a failure here.
class Checked {
 public:
  explicit Checked(QAbstractItemModel* model) : tester_{model, Mode::Warning} {
    warnings = 0;
    previous_ =
        qInstallMessageHandler([](QtMsgType type, const QMessageLogContext& context, const QString& text) {
          if (type == QtWarningMsg && QByteArray(context.category) == "qt.modeltest") {
            ++warnings;
            ADD_FAILURE() << text.toStdString();
          }
        });
  }
  ~Checked() { qInstallMessageHandler(previous_); }

 private:
  static inline int warnings = 0;
  QAbstractItemModelTester tester_;
  QtMessageHandler previous_{nullptr};
};

view::SceneSnapshot snapshotAt(FakeSession& session, double t) {
  session.seek(t);
  view::SceneSnapshot snapshot;
  session.takeSnapshot(snapshot);
  return snapshot;
}

TEST(NearestClasses, PeopleComeFirstWithoutSelfPairs) {
  view::SceneOutline outline;
  outline.objects = {{"arm/1", "arm", false, true},      {"arm/2", "arm", false, true},
                     {"p/head", "p", true, true},        {"p/torso", "p", true, true},
                     {"table", "objects", false, false}, {"lamp", "objects", false, false}};
  outline.pairs = {{0, 1}, {0, 2}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {0, 4}};
  view::SceneSnapshot snapshot;
  snapshot.objects.resize(outline.objects.size());
  snapshot.pairs.resize(outline.pairs.size());
  const double distances[] = {0.3, 0.5, 0.4, -0.05, 0.2, -0.1, kInfinity};
  for (std::size_t i = 0; i < snapshot.pairs.size(); ++i) {
    snapshot.pairs[i].result.distance = distances[i];
    snapshot.pairs[i].result.bound = 0.001;
  }
  snapshot.nearest_pair = 5;
  const auto found = nearestOfClasses(outline, snapshot);
  ASSERT_EQ(found.size(), 3u) << "robot and thing: no distance is known";
  EXPECT_EQ(found[0].pair, 2);
  EXPECT_EQ(found[0].of, PairClass::kPersonRobot);
  EXPECT_EQ(found[1].pair, 4);
  EXPECT_EQ(found[2].pair, 0);
  EXPECT_TRUE(nearestText(outline, snapshot).startsWith("Person – robot: arm/2 – p/head, "));
  EXPECT_EQ(nearestLines(outline, snapshot).count('\n'), 2);
  // 0.5 m known within 0.2 m may be nearer than 0.4 m.
  snapshot.objects[0].pose_uncertainty = 0.2;
  EXPECT_EQ(nearestOfClasses(outline, snapshot)[0].pair, 1);
  EXPECT_TRUE(nearestText(outline, snapshot).startsWith("Person – robot: arm/1 – p/head, 500 mm ± 200 mm"));
  outline.pairs = {{4, 5}};
  snapshot.pairs.resize(1);
  snapshot.nearest_pair = 0;
  EXPECT_TRUE(nearestText(outline, snapshot).startsWith("Nearest: table – lamp"));
  EXPECT_TRUE(nearestText({}, {}).isEmpty());
}

TEST(SceneTree, IsConsistentModelWithOrderedGroups) {
  FakeSession session;
  SceneTreeModel model;
  const Checked checked(&model);
  model.open(session.outline());
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(model.index(0, 0).data().toString(), "arm");
  EXPECT_EQ(model.index(1, 0).data().toString(), "operator");
  EXPECT_EQ(model.index(2, 0).data().toString(), "objects");
  EXPECT_EQ(model.rowCount(model.index(1, 0)), 14);
  for (const double t : {0.0, 0.4, 3.0}) model.refresh(session.outline(), snapshotAt(session, t));
  const int hand = session.indexOf("operator/hand_left");
  EXPECT_EQ(model.indexOf(hand).data().toString(), "hand_left");
  EXPECT_EQ(model.objectsOf(model.indexOf(hand)), std::vector<int>{hand});
  model.open({});
  EXPECT_EQ(model.rowCount(), 0);
}

TEST(SceneTree, GroupHasASquareOfItsColourAtEverySize) {
  FakeSession session;
  SceneTreeModel model;
  model.open(session.outline());
  const auto icon = model.index(1, 0).data(Qt::DecorationRole).value<QIcon>();
  for (const int size : {16, 33}) {
    const QImage square = icon.pixmap(size).toImage();
    ASSERT_EQ(square.size(), QSize(size, size));
    for (const int at : {0, size - 1})
      EXPECT_EQ(square.pixelColor(at, at), sceneColours(Theme::kLight).human);
  }
}

TEST(SceneTree, GroupCheckBoxShowsAndHidesObjects) {
  FakeSession session;
  SceneTreeModel model;
  const Checked checked(&model);
  model.open(session.outline());
  QSignalSpy changes(&model, &SceneTreeModel::visibilityChanged);
  const QModelIndex arm = model.index(0, 0);
  EXPECT_TRUE(model.setData(model.index(1, 0, arm), Qt::Unchecked, Qt::CheckStateRole));
  EXPECT_EQ(arm.data(Qt::CheckStateRole).toInt(), Qt::PartiallyChecked);
  EXPECT_TRUE(model.setData(arm, Qt::Unchecked, Qt::CheckStateRole));
  EXPECT_EQ(arm.data(Qt::CheckStateRole).toInt(), Qt::Unchecked);
  EXPECT_EQ(changes.size(), 5);
}

TEST(SceneTree, MarksContactAndSignalsOnlyChanges) {
  FakeSession session;
  SceneTreeModel model;
  model.open(session.outline());
  const view::SceneSnapshot snapshot = snapshotAt(session, 0.4);
  model.refresh(session.outline(), snapshot);
  const int link = session.indexOf("arm/link4");
  ASSERT_TRUE(snapshot.objects[static_cast<std::size_t>(link)].colliding);
  EXPECT_TRUE(model.indexOf(link).siblingAtColumn(1).data().toString().contains(QStringLiteral("⚠")));
  QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
  model.refresh(session.outline(), snapshot);
  EXPECT_EQ(changes.size(), 0);
}

TEST(PairTable, IsConsistentModelSortedByDistance) {
  FakeSession session;
  PairTableModel model;
  PairFilter filter;
  filter.setSourceModel(&model);
  filter.sort(PairTableModel::kDistance);
  const Checked checked(&model);
  const Checked filter_checked(&filter);
  model.open(session.outline());
  for (const double t : {0.0, 0.4, 2.5, 6.0}) {
    model.refresh(snapshotAt(session, t));
    filter.sortAgain();
    for (int row = 1; row < filter.rowCount(); ++row)
      ASSERT_LE(filter.index(row - 1, PairTableModel::kDistance).data(PairTableModel::kSortRole).toDouble(),
                filter.index(row, PairTableModel::kDistance).data(PairTableModel::kSortRole).toDouble());
  }
  filter.setText("HAND_left");
  EXPECT_EQ(filter.rowCount(), 7);  // five links and two objects
  filter.setObjects({session.indexOf("table")});
  EXPECT_EQ(filter.rowCount(), 1);
}

TEST(PairTable, ShowsStateAndSortsUnknownDistancesLast) {
  FakeSession session;
  PairTableModel model;
  model.open(session.outline());
  view::SceneSnapshot snapshot = snapshotAt(session, 0.4);
  snapshot.pairs[0].result = {};
  model.refresh(snapshot);
  EXPECT_EQ(model.index(0, PairTableModel::kDistance).data().toString(), QStringLiteral("–"));
  EXPECT_EQ(model.index(0, PairTableModel::kDistance).data(PairTableModel::kSortRole).toDouble(), kInfinity);
  view::SceneSnapshot lost = snapshotAt(session, 5.5);
  lost.objects[static_cast<std::size_t>(session.indexOf("table"))].pose_state = scene::PoseState::kStale;
  model.refresh(lost);
  for (int row = 0; row < model.rowCount(); ++row)
    EXPECT_EQ(model.nameOf(model.objectsOf(row).second) == "table" ||
                  model.nameOf(model.objectsOf(row).first) == "table",
              model.index(row, PairTableModel::kState).data().toString() == QStringLiteral("? pose lost"));
  model.refresh(snapshot);
  const auto nearest = snapshot.nearest_pair;
  EXPECT_EQ(model.index(nearest, PairTableModel::kState).data().toString(), QStringLiteral("⚠ touching"));
  EXPECT_TRUE(model.index(nearest, 0).data(Qt::BackgroundRole).isValid());
}

TEST(PairStates, BrokenMarginIsNotContact) {
  FakeSession session;
  PairTableModel table;
  SceneTreeModel tree;
  table.open(session.outline());
  tree.open(session.outline());
  view::SceneSnapshot snapshot = snapshotAt(session, 0.4);
  const auto nearest = static_cast<std::size_t>(snapshot.nearest_pair);
  const int body = session.outline().pairs[nearest].first;
  const auto inTree = [&] {
    tree.refresh(session.outline(), snapshot);
    for (int g = 0; g < tree.rowCount(); ++g)
      for (int r = 0; r < tree.rowCount(tree.index(g, 0)); ++r)
        if (tree.objectsOf(tree.index(r, 0, tree.index(g, 0))) == std::vector<int>{body})
          return tree.index(r, 1, tree.index(g, 0)).data().toString();
    return QString();
  };
  const auto inTable = [&] {
    table.refresh(snapshot);
    return table.index(static_cast<int>(nearest), PairTableModel::kState).data().toString();
  };
  for (view::PairSnapshot& pair : snapshot.pairs) pair.result = {};
  view::PairSnapshot& pair = snapshot.pairs[nearest];
  pair.margin = 0.05;
  pair.result.contacts = 3;
  pair.result.bound = 1e-5;
  snapshot.objects[static_cast<std::size_t>(body)].colliding = true;
  for (const double apart : {0.03, 2e-5}) {
    pair.result.distance = apart;
    EXPECT_EQ(inTable(), QStringLiteral("⚠ inside margin"));
    EXPECT_EQ(inTree(), QStringLiteral("⚠ inside margin"));
  }
  for (const double inside : {1e-5, 0.0, -0.01}) {
    pair.result.distance = inside;
    EXPECT_EQ(inTable(), QStringLiteral("⚠ touching"));
    EXPECT_EQ(inTree(), QStringLiteral("⚠ touching"));
  }
}

TEST(PairTable, MarksPairsThatCheckWouldNotPassAsInside) {
  FakeSession session;
  PairTableModel model;
  model.open(session.outline());
  view::SceneSnapshot snapshot = snapshotAt(session, 0.4);
  snapshot.pairs[0].margin = 0.05;
  const auto stateAt = [&](double distance, double bound, double uncertainty) {
    snapshot.pairs[0].result = {};
    snapshot.pairs[0].result.distance = distance;
    snapshot.pairs[0].result.bound = bound;
    snapshot.objects[static_cast<std::size_t>(model.objectsOf(0).first)].pose_uncertainty = uncertainty;
    model.refresh(snapshot);
    return model.index(0, PairTableModel::kState).data().toString();
  };
  EXPECT_EQ(stateAt(0.5, 0.0, 0.0), QStringLiteral("clear"));
  EXPECT_EQ(stateAt(0.09, 0.0, 0.0), QStringLiteral("▲ near"));
  EXPECT_EQ(stateAt(0.049, 0.0, 0.0), QStringLiteral("⚠ inside margin"));
  EXPECT_EQ(stateAt(0.09, 0.05, 0.0), QStringLiteral("⚠ inside margin")) << "not proven";
  EXPECT_EQ(stateAt(0.09, 0.0, 0.05), QStringLiteral("⚠ inside margin")) << "uncertain pose";
  const auto uncertainty = [&] { return model.index(0, PairTableModel::kUncertainty).data().toString(); };
  EXPECT_EQ(uncertainty(), QStringLiteral("50.0"));
  EXPECT_EQ(stateAt(0.5, 0.002, 0.05), QStringLiteral("clear"));
  EXPECT_EQ(uncertainty(), QStringLiteral("52.0")) << "of the geometry and of the poses";
  EXPECT_EQ(stateAt(0.5, 0.0, kInfinity), QStringLiteral("⚠ inside margin"));
  EXPECT_EQ(uncertainty(), QStringLiteral("pose unknown"));
}

TEST(PairPanelTest, KeepsSelectionAndScrollWhileValuesChange) {
  FakeSession session;
  Selection selection;
  PairPanel panel(selection);
  panel.resize(700, 240);
  panel.open(session.outline());
  panel.refresh(snapshotAt(session, 0.0));
  panel.show();
  panel.table()->selectRow(30);
  const int chosen = selection.pair();
  ASSERT_GE(chosen, 0);
  panel.table()->verticalScrollBar()->setValue(12);
  for (double t = 0.1; t < 6.0; t += 0.3) {
    panel.refresh(snapshotAt(session, t));
    panel.sortAgain();
  }
  EXPECT_EQ(selection.pair(), chosen);
  EXPECT_EQ(panel.table()->verticalScrollBar()->value(), 12);
  const QModelIndexList rows = panel.table()->selectionModel()->selectedRows(PairTableModel::kA);
  ASSERT_EQ(rows.size(), 1);
  const int a = session.outline().pairs[static_cast<std::size_t>(chosen)].first;
  EXPECT_EQ(rows.front().data().toString().toStdString(),
            session.outline().objects[static_cast<std::size_t>(a)].name);
}

TEST(SelectionSync, TreeAndTableShareSelection) {
  FakeSession session;
  Selection selection;
  SceneTreeModel model;
  SceneTreePanel tree(model, selection);
  PairPanel panel(selection);
  model.open(session.outline());
  panel.open(session.outline());
  const int hand = session.indexOf("operator/hand_left");
  tree.selectionModel()->select(model.indexOf(hand),
                                QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  EXPECT_EQ(selection.objects(), std::vector<int>{hand});
  EXPECT_EQ(panel.table()->model()->rowCount(), 7);

  panel.table()->selectRow(2);
  EXPECT_EQ(selection.objects().size(), 2u);
  EXPECT_EQ(tree.selectionModel()->selectedRows().size(), 2);
  EXPECT_EQ(panel.table()->model()->rowCount(), 7) << "a choice in the table does not hide its other rows";

  selection.clear();
  EXPECT_TRUE(tree.selectionModel()->selectedRows().isEmpty());
  panel.classBox()->setCurrentIndex(0);
  Q_EMIT panel.classBox()->activated(0);
  EXPECT_EQ(panel.table()->model()->rowCount(), static_cast<int>(session.outline().pairs.size()));
}

TEST(PairPanelTest, ListsPeopleAndRobotsByDefault) {
  FakeSession session;
  Selection selection;
  PairPanel panel(selection);
  panel.open(session.outline());
  const auto& outline = session.outline();
  const auto of_class = [&](PairClass wanted) {
    return static_cast<int>(std::count_if(outline.pairs.begin(), outline.pairs.end(), [&](const auto& pair) {
      return pairClassOf(outline, pair) == wanted;
    }));
  };
  const auto rows = [&] { return panel.table()->model()->rowCount(); };
  const auto choose = [&](const QString& name) {
    const int index = panel.classBox()->findText(name);
    ASSERT_GE(index, 0) << name.toStdString();
    panel.classBox()->setCurrentIndex(index);
    Q_EMIT panel.classBox()->activated(index);
  };
  EXPECT_EQ(panel.classBox()->currentText(), QStringLiteral("Person – robot"));
  EXPECT_EQ(rows(), of_class(PairClass::kPersonRobot));
  EXPECT_GT(rows(), 0);
  choose(QStringLiteral("Person – thing"));
  EXPECT_EQ(rows(), of_class(PairClass::kPersonThing));
  panel.open(outline);
  EXPECT_EQ(rows(), of_class(PairClass::kPersonThing)) << "the choice outlives the scene";
  choose(QStringLiteral("All pairs"));
  EXPECT_EQ(rows(), static_cast<int>(outline.pairs.size()));
  panel.open({});
  EXPECT_EQ(rows(), 0);
  EXPECT_EQ(panel.classBox()->count(), 1);
}

TEST(SceneTreeModelTest, NearestOfRobotIsPerson) {
  FakeSession session;
  SceneTreeModel model;
  view::SceneSnapshot snapshot;
  ASSERT_TRUE(session.takeSnapshot(snapshot));
  const auto& outline = session.outline();
  model.open(outline);
  model.refresh(outline, snapshot);
  int looked_at = 0;
  for (std::size_t object = 0; object < outline.objects.size(); ++object) {
    double nearest = kInfinity;
    for (std::size_t p = 0; p < outline.pairs.size(); ++p) {
      const auto [a, b] = outline.pairs[p];
      const PairClass of = pairClassOf(outline, outline.pairs[p]);
      if (of != PairClass::kPersonRobot && of != PairClass::kPersonThing) continue;
      if (a != static_cast<int>(object) && b != static_cast<int>(object)) continue;
      nearest = std::min(nearest, snapshot.pairs[p].result.distance);
    }
    const QString text = model.indexOf(static_cast<int>(object)).siblingAtColumn(1).data().toString();
    if (nearest > 0.01 && nearest < kInfinity) {  // touching is a word
      ++looked_at;
      EXPECT_TRUE(text.contains(QString::number(1e3 * nearest, 'f', 1))) << outline.objects[object].name;
    }
  }
  EXPECT_GT(looked_at, 3);
}

}  // namespace item_models_test
}  // namespace abstand::ui
