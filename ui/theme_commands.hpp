// Light, dark, or as the system has it.
#pragma once

#include <QObject>

#include "ui/style/theme.hpp"

namespace abstand::ui {

class Actions;
class SceneTreeModel;

/// Applies what the settings have at once, and what the user chooses later; keeps the choice. GUI thread
/// only.
class ThemeCommands : public QObject {
  Q_OBJECT

 public:
  /// Both outlive it. The theme of the application is that of the system as yet.
  ThemeCommands(const Actions& actions, SceneTreeModel& tree, QObject* parent);

 private:
  void follow(bool system);
  void apply(Theme theme);

  const Actions& actions_;
  SceneTreeModel& tree_;
  Theme system_;  ///< when the program was started
};

}  // namespace abstand::ui
