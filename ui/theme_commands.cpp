// Light, dark, or as the system has it.
#include "ui/theme_commands.hpp"

#include <QApplication>
#include <QSettings>

#include "ui/model/scene_tree_model.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {

namespace {

constexpr char kKey[] = "window/dark";
/// The palette of the application is one of ours after the first window.
constexpr char kSystem[] = "abstand_system_dark";

Theme themeOfSystem() {
  const QVariant known = qApp->property(kSystem);
  if (known.isValid()) return known.toBool() ? Theme::kDark : Theme::kLight;
  const Theme theme = themeOf(QApplication::palette());
  qApp->setProperty(kSystem, theme == Theme::kDark);
  return theme;
}

}  // namespace

ThemeCommands::ThemeCommands(const Actions& actions, SceneTreeModel& tree, QObject* parent)
    : QObject(parent), actions_{actions}, tree_{tree}, system_{themeOfSystem()} {
  const QVariant dark = QSettings().value(kKey);
  apply(dark.isValid() ? dark.toBool() ? Theme::kDark : Theme::kLight : system_);
  actions[ActionId::kSystemTheme]->setChecked(!dark.isValid());
  connect(actions[ActionId::kDarkTheme], &QAction::toggled, this, [this](bool on) {
    actions_[ActionId::kSystemTheme]->setChecked(false);
    apply(on ? Theme::kDark : Theme::kLight);
    QSettings().setValue(kKey, on);
  });
  connect(actions[ActionId::kSystemTheme], &QAction::toggled, this, &ThemeCommands::follow);
}

void ThemeCommands::follow(bool system) {
  if (system) apply(system_);
  if (system)
    QSettings().remove(kKey);
  else
    QSettings().setValue(kKey, actions_[ActionId::kDarkTheme]->isChecked());
}

void ThemeCommands::apply(Theme theme) {
  QAction* dark = actions_[ActionId::kDarkTheme];
  const QSignalBlocker quiet(dark);
  dark->setChecked(theme == Theme::kDark);
  applyTheme(*qApp, theme);
  tree_.setTheme(theme);
}

}  // namespace abstand::ui
