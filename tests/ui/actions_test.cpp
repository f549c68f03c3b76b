// Every command has a text, a tip and a key of its own.
#include "ui/style/actions.hpp"

#include <gtest/gtest.h>

#include <QMenu>
#include <QMenuBar>
#include <map>
#include <set>

#include "ui/main_window.hpp"
#include "ui/panels/help_dialogs.hpp"

namespace abstand::ui {
namespace actions_test {

/// Actions in menus, without separators and the menus themselves.
void collect(const QMenu* menu, std::set<QAction*>& found) {
  for (QAction* action : menu->actions()) {
    if (action->menu())
      collect(action->menu(), found);
    else if (!action->isSeparator())
      found.insert(action);
  }
}

TEST(ActionTable, EveryActionHasTextTipAndUniqueKey) {
  MainWindow window;
  std::map<QString, QString> owner;
  for (const auto& entry : window.actions().all()) {
    SCOPED_TRACE(entry.action->text().toStdString());
    EXPECT_FALSE(entry.action->text().isEmpty());
    EXPECT_FALSE(entry.action->statusTip().isEmpty());
    EXPECT_FALSE(entry.action->toolTip().isEmpty());
    ASSERT_FALSE(entry.action->shortcuts().isEmpty());
    for (const QKeySequence& key : entry.action->shortcuts()) {
      EXPECT_FALSE(key.isEmpty());
      const auto [at, is_new] = owner.emplace(key.toString(), entry.action->text());
      EXPECT_TRUE(is_new) << key.toString().toStdString() << " is also that of " << at->second.toStdString();
    }
  }
}

TEST(ActionTable, EveryActionIsInAMenuAndEveryMenuEntryIsInTheTable) {
  MainWindow window;
  std::set<QAction*> in_menus, in_table;
  for (QAction* top : window.menuBar()->actions()) collect(top->menu(), in_menus);
  for (const auto& entry : window.actions().all()) in_table.insert(entry.action);
  EXPECT_EQ(in_menus.size(), in_table.size());
  EXPECT_EQ(in_menus, in_table);
}

TEST(ActionTable, ShortcutPageListsEveryKey) {
  MainWindow window;
  const QString page = shortcutPage(window.actions());
  for (const auto& entry : window.actions().all()) {
    if (!entry.action->isVisible()) continue;
    EXPECT_TRUE(page.contains(entry.action->shortcut().toString(QKeySequence::NativeText).toHtmlEscaped()))
        << entry.action->text().toStdString();
  }
}

TEST(Accessibility, FocusableWidgetsHaveNames) {
  MainWindow window;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().startsWith("qt_") ||
        !widget->isEnabled())
      continue;
    // The inner parts of compound widgets are named by their owners.
    const char* inner[] = {"QLineEdit",
                           "QComboBoxPrivateContainer",
                           "QComboBoxListView",
                           "QTableCornerButton",
                           "QAbstractScrollAreaScrollBarContainer",
                           "QHeaderView",
                           "QToolBarExtension",
                           "QMenuBar"};
    bool is_inner = false;
    for (const char* name : inner) is_inner |= widget->inherits(name) && widget->parentWidget() != nullptr;
    if (is_inner || widget->inherits("QMenu") || widget->inherits("QDockWidget")) continue;
    EXPECT_FALSE(widget->accessibleName().isEmpty() && widget->property("text").toString().isEmpty() &&
                 widget->toolTip().isEmpty())
        << widget->metaObject()->className() << " in "
        << (widget->parentWidget() ? widget->parentWidget()->metaObject()->className() : "");
  }
}

}  // namespace actions_test
}  // namespace abstand::ui
