// Commands are found by their words and run.
#include "ui/panels/command_palette.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/shown_window.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {
namespace command_palette_test {

struct CommandPaletteTest : ShownWindow {
  CommandPalette* open() {
    window.actions()[ActionId::kPalette]->trigger();
    return window.findChild<CommandPalette*>();
  }
};

TEST_F(CommandPaletteTest, ListsEveryVisibleCommand) {
  CommandPalette* palette = open();
  ASSERT_TRUE(palette);
  int visible = 0;
  for (const auto& entry : window.actions().all()) visible += entry.action->isVisible();
  EXPECT_EQ(palette->list()->count(), visible);
}

TEST_F(CommandPaletteTest, FindsByAllWordsAndRunsWithEnter) {
  CommandPalette* palette = open();
  ASSERT_TRUE(palette);
  palette->field()->setText(QStringLiteral("camera TOP"));
  ASSERT_GE(palette->list()->count(), 1);
  EXPECT_TRUE(palette->list()->currentItem()->text().contains(QLatin1String("Top")));
  palette->field()->setText(QStringLiteral("floor"));
  ASSERT_GE(palette->list()->count(), 1);
  QAction* floor = window.actions()[ActionId::kFloor];
  const bool before = floor->isChecked();
  const QPointer<CommandPalette> alive = palette;
  QTest::keyClick(palette->field(), Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor([&] { return floor->isChecked() != before && !alive; }, kWaitMs));
}

TEST_F(CommandPaletteTest, ArrowKeysMoveInList) {
  CommandPalette* palette = open();
  ASSERT_TRUE(palette);
  palette->field()->setText(QStringLiteral("camera"));
  ASSERT_GE(palette->list()->count(), 3);
  const int first = palette->list()->currentRow();
  QTest::keyClick(palette->field(), Qt::Key_Down);
  EXPECT_EQ(palette->list()->currentRow(), first + 1);
}

TEST_F(CommandPaletteTest, DisabledCommandIsNotRun) {
  window.setSession(nullptr);
  QAction* play = window.actions()[ActionId::kPlay];
  ASSERT_FALSE(play->isEnabled());
  const QSignalSpy triggered(play, &QAction::triggered);
  CommandPalette* palette = open();
  ASSERT_TRUE(palette);
  palette->field()->setText(play->statusTip());
  EXPECT_GE(palette->list()->count(), 1);
  QTest::keyClick(palette->field(), Qt::Key_Return);
  QCoreApplication::processEvents();
  EXPECT_EQ(triggered.size(), 0);
  palette->field()->setText(QStringLiteral("no command has these words"));
  EXPECT_EQ(palette->list()->count(), 0);
  QTest::keyClick(palette->field(), Qt::Key_Return);
}

}  // namespace command_palette_test
}  // namespace abstand::ui
