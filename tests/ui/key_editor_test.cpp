// Commands get other keys, which are kept.
#include "ui/panels/key_editor.hpp"

#include <gtest/gtest.h>

#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTreeWidget>
#include <set>

#include "ui/main_window.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/kept_keys.hpp"

namespace abstand::ui {
namespace key_editor_test {

const QKeySequence kFree(QStringLiteral("Ctrl+Alt+F12"));

struct KeyEditorTest : ::testing::Test {
  KeyEditorTest() { QSettings().clear(); }
  ~KeyEditorTest() override { QSettings().clear(); }
};

struct Editor {
  explicit Editor(const Actions& actions) : dialog(new KeyEditor(actions, nullptr)) {}
  ~Editor() { delete dialog; }
  template <class Widget>
  Widget* the() const {
    return dialog->findChild<Widget*>();
  }
  QPushButton* button(const char* word) const {
    for (auto* button : dialog->findChildren<QPushButton*>())
      if (button->text().remove('&').startsWith(QLatin1String(word))) return button;
    return nullptr;
  }
  /// The command whose tip is this one.
  void choose(const QAction* action) const {
    dialog->findChild<QLineEdit*>()->setText(action->statusTip());
    auto* list = the<QTreeWidget>();
    for (int row = 0; row < list->topLevelItemCount(); ++row)
      if (list->topLevelItem(row)->toolTip(0) == action->statusTip())
        return list->setCurrentItem(list->topLevelItem(row));
    ADD_FAILURE() << "not listed: " << action->statusTip().toStdString();
  }
  QString said() const {
    for (auto* label : dialog->findChildren<QLabel*>())
      if (label->wordWrap()) return label->text();
    return {};
  }
  KeyEditor* dialog;
};

TEST_F(KeyEditorTest, CommandNamesAreUniqueInAllLanguages) {
  MainWindow window;
  std::set<QString> names;
  for (const auto& entry : window.actions().all()) {
    const QString name = entry.action->objectName();
    EXPECT_TRUE(names.insert(name).second) << name.toStdString();
    for (const QChar c : name) EXPECT_TRUE(c.unicode() < 128 && c != ' ' && c != '&') << name.toStdString();
  }
  EXPECT_EQ(window.actions()[ActionId::kSaveAs]->objectName(), "save_project_as");
}

TEST_F(KeyEditorTest, AssignsAndKeepsKey) {
  {
    MainWindow window;
    const Actions& actions = window.actions();
    const Editor editor(actions);
    editor.choose(actions[ActionId::kFit]);
    EXPECT_FALSE(editor.button("Default")->isEnabled());
    editor.the<QKeySequenceEdit>()->setKeySequence(kFree);
    EXPECT_EQ(editor.said(), QString());
    editor.button("Assign")->click();
    EXPECT_EQ(actions[ActionId::kFit]->shortcuts(), QList<QKeySequence>{kFree});
    EXPECT_TRUE(actions[ActionId::kFit]->toolTip().contains(kFree.toString(QKeySequence::NativeText)));
    EXPECT_EQ(editor.the<QTreeWidget>()->currentItem()->text(1), kFree.toString(QKeySequence::NativeText));
  }
  MainWindow next;
  EXPECT_EQ(next.actions()[ActionId::kFit]->shortcuts(), QList<QKeySequence>{kFree});
}

TEST_F(KeyEditorTest, ReassignsKeyOfOtherCommand) {
  MainWindow window;
  const Actions& actions = window.actions();
  const QAction* play = actions[ActionId::kPlay];
  const QAction* fit = actions[ActionId::kFit];
  const QList<QKeySequence> keys_of_play = play->shortcuts(), keys_of_fit = fit->shortcuts();
  const Editor editor(actions);
  editor.choose(fit);
  editor.the<QKeySequenceEdit>()->setKeySequence(keys_of_play.first());
  EXPECT_TRUE(editor.said().contains(play->text().remove('&')));
  EXPECT_EQ(play->shortcuts(), keys_of_play) << "nothing is taken before it is assigned";
  editor.button("Assign")->click();
  EXPECT_FALSE(play->shortcuts().contains(keys_of_play.first()));
  EXPECT_EQ(fit->shortcut(), keys_of_play.first());
  editor.choose(play);
  editor.button("Default")->click();
  EXPECT_EQ(play->shortcuts(), keys_of_play);
  EXPECT_TRUE(fit->shortcuts().isEmpty()) << "a key has one command";
  EXPECT_EQ(fit->toolTip(), fit->statusTip());
  editor.button("All default")->click();
  EXPECT_EQ(fit->shortcuts(), keys_of_fit);
  QSettings settings;
  settings.beginGroup("keys");
  EXPECT_TRUE(settings.allKeys().isEmpty());
}

TEST_F(KeyEditorTest, PrefixOfKeySequenceIsTaken) {
  MainWindow window;
  const Actions& actions = window.actions();
  const QAction* propose = actions[ActionId::kProposeMargins];
  ASSERT_EQ(propose->shortcut().count(), 2) << "two strokes";
  EXPECT_NE(actions.ownerOf(QKeySequence(propose->shortcut()[0]), nullptr), nullptr);
  EXPECT_EQ(actions.ownerOf(kFree, nullptr), nullptr);
}

TEST_F(KeyEditorTest, CommandMayHaveNoKey) {
  {
    MainWindow window;
    Actions::setKeys(window.actions()[ActionId::kFit], {});
    saveKeys(window.actions());
  }
  MainWindow next;
  EXPECT_TRUE(next.actions()[ActionId::kFit]->shortcuts().isEmpty());
}

TEST_F(KeyEditorTest, KeysMayBeSwapped) {
  {
    MainWindow window;
    const Actions& actions = window.actions();
    const auto front = actions[ActionId::kFront]->shortcuts(), side = actions[ActionId::kSide]->shortcuts();
    Actions::setKeys(actions[ActionId::kFront], side);
    Actions::setKeys(actions[ActionId::kSide], front);
    saveKeys(actions);
  }
  MainWindow window;
  for (const auto& entry : window.actions().all()) {
    const bool changed = entry.action == window.actions()[ActionId::kFront] ||
                         entry.action == window.actions()[ActionId::kSide];
    EXPECT_EQ(entry.action->shortcuts() != entry.default_keys, changed)
        << entry.action->objectName().toStdString();
  }
}

TEST_F(KeyEditorTest, InvalidSettingsChangeNothing) {
  const std::pair<const char*, QVariant> wrong[] = {{"keys/play", "no such key"},
                                                    {"keys/play", QStringList{"Ctrl+Q"}},
                                                    {"keys/play", 12.5},
                                                    {"keys/no_such_command", "Ctrl+Alt+F12"}};
  for (const auto& [name, value] : wrong) {
    QSettings().clear();
    QSettings().setValue(name, value);
    MainWindow window;
    for (const auto& entry : window.actions().all())
      EXPECT_EQ(entry.action->shortcuts(), entry.default_keys)
          << name << " " << value.toString().toStdString();
  }
}

}  // namespace key_editor_test
}  // namespace abstand::ui
