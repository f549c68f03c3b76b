// The matrix of pairs: what is checked, why not, and ticks that change it.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QTableView>

#include "tests/ui/shown_window.hpp"
#include "ui/document/document.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/pair_matrix.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {
namespace pair_matrix_test {

struct PairMatrixTest : ShownWindow {
  void SetUp() override {
    ShownWindow::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    matrix = window.panels().matrix;
    QApplication::setActiveWindow(&window);
    QTest::keyClick(&window, Qt::Key_6, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !matrix->visibleRegion().isEmpty(); }, kWaitMs));
    session.log.clear();
  }
  /// The cell of two bodies.
  QModelIndex cell(const char* row, const char* column) const {
    const PairMatrixModel* model = matrix->model();
    for (int r = 0; r < model->rowCount(); ++r)
      for (int c = 0; c < model->columnCount(); ++c)
        if (model->bodyOfRow(r) == session.indexOf(row) && model->bodyOfColumn(c) == session.indexOf(column))
          return model->index(r, c);
    return {};
  }
  static Qt::CheckState tick(const QModelIndex& index) {
    return static_cast<Qt::CheckState>(index.data(Qt::CheckStateRole).toInt());
  }
  void setTick(const QModelIndex& index, Qt::CheckState state) {
    matrix->model()->setData(index, state, Qt::CheckStateRole);
    window.pull();
  }
  const Work& work() const { return window.document().work(); }

  PairMatrix* matrix{nullptr};
};

TEST_F(PairMatrixTest, RowsArePartsAndColumnsAreLinks) {
  const PairMatrixModel* model = matrix->model();
  EXPECT_EQ(model->rowCount(), 14);
  EXPECT_EQ(model->columnCount(), 5);
  EXPECT_EQ(model->headerData(1, Qt::Horizontal, Qt::DisplayRole).toString(), "arm\nlink1");
  EXPECT_EQ(model->headerData(0, Qt::Vertical, Qt::DisplayRole).toString(), "torso");
  session.seek(1.9);
  window.pull();
  for (int r = 0; r < model->rowCount(); ++r)
    for (int c = 0; c < model->columnCount(); ++c) {
      const QModelIndex index = model->index(r, c);
      const auto pair = static_cast<std::size_t>(model->pairAt(index));
      ASSERT_LT(pair, session.outline().pairs.size());
      const auto [a, b] = session.outline().pairs[pair];
      EXPECT_EQ(std::minmax(model->bodyOfRow(r), model->bodyOfColumn(c)), std::minmax(a, b));
      EXPECT_EQ(index.data().toString(), lengthNumber(window.moment().pairs[pair].result.distance, 0));
      EXPECT_EQ(tick(index), Qt::Checked);
    }
  const QAbstractItemModelTester tester(matrix->model(),
                                        QAbstractItemModelTester::FailureReportingMode::Fatal);
  matrix->bodies()->setCurrentIndex(1);
  EXPECT_EQ(model->rowCount(), static_cast<int>(session.outline().objects.size()));
  window.pull();
}

TEST_F(PairMatrixTest, UncheckedPairsShowReason) {
  matrix->bodies()->setCurrentIndex(1);
  matrix->refresh(window.moment());
  EXPECT_EQ(tick(cell("arm/link1", "arm/link2")), Qt::Unchecked);
  EXPECT_TRUE(
      cell("arm/link2", "arm/link1").data(Qt::ToolTipRole).toString().endsWith("never checked, adjacent"));
  EXPECT_TRUE(cell("operator/head", "operator/torso")
                  .data(Qt::ToolTipRole)
                  .toString()
                  .endsWith("never checked, within the person"));
  EXPECT_EQ(matrix->model()->flags(cell("table", "table")), Qt::NoItemFlags);
  const std::size_t pairs = session.outline().pairs.size(), n = session.outline().objects.size();
  EXPECT_EQ(matrix->counts()->text(),
            QStringLiteral("%1 checked, %2 not").arg(pairs).arg(n * (n - 1) / 2 - pairs));
  session.setGroup(0, view::PairGroupState::kPaused);
  window.pull();
  const QModelIndex paused = cell("operator/head", "arm/link3");
  EXPECT_EQ(tick(paused), Qt::Unchecked);
  EXPECT_TRUE(paused.data().toString().isEmpty()) << "no distance that is old";
  EXPECT_TRUE(paused.data(Qt::ToolTipRole).toString().contains("not checked now"));
}

TEST_F(PairMatrixTest, TickRemovesAndRestoresPair) {
  const QModelIndex index = cell("operator/hand_left", "arm/link4");
  const QPair<QString, QString> names("arm/link4", "operator/hand_left");
  setTick(index, Qt::Unchecked);
  ASSERT_TRUE(work().moved.contains(names));
  EXPECT_TRUE(work().moved.value(names).isEmpty());
  const int pair = matrix->model()->pairAt(index);
  EXPECT_EQ(session.log, std::vector<std::string>{"remove " + std::to_string(pair)});
  EXPECT_EQ(tick(index), Qt::Unchecked);
  EXPECT_TRUE(window.moment().pairs[static_cast<std::size_t>(pair)].paused);
  setTick(index, Qt::Checked);
  EXPECT_TRUE(work().moved.isEmpty());
  EXPECT_EQ(tick(index), Qt::Checked);
  window.actions()[ActionId::kUndo]->trigger();
  window.pull();
  EXPECT_EQ(tick(index), Qt::Unchecked);
}

TEST_F(PairMatrixTest, AddsPairThatSceneExcludes) {
  matrix->bodies()->setCurrentIndex(1);
  matrix->refresh(window.moment());
  setTick(cell("operator/head", "operator/foot_left"), Qt::Checked);
  EXPECT_EQ(work().added, (QSet<QPair<QString, QString>>{{"operator/head", "operator/foot_left"}}));
  EXPECT_TRUE(session.log.empty()) << "the session cannot: the scene is opened anew";
  window.actions()[ActionId::kUndo]->trigger();
  EXPECT_TRUE(work().added.isEmpty());
}

TEST_F(PairMatrixTest, TickDoesNotStartPausedGroup) {
  session.setGroup(0, view::PairGroupState::kPaused);
  window.pull();
  const int steps = window.document().steps().count();
  setTick(cell("operator/head", "arm/link3"), Qt::Checked);
  EXPECT_EQ(window.document().steps().count(), steps);
}

TEST_F(PairMatrixTest, ClickSelectsPair) {
  const QModelIndex index = cell("operator/head", "arm/link3");
  QTest::mouseClick(matrix->table()->viewport(), Qt::LeftButton, {},
                    matrix->table()->visualRect(index).center());
  EXPECT_EQ(window.selection().pair(), matrix->model()->pairAt(index));
}

}  // namespace pair_matrix_test
}  // namespace abstand::ui
