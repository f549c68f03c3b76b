// Menus and toolbar from the table of actions.
#pragma once

class QMainWindow;
class QSlider;

namespace abstand::ui {

class Actions;

/// Fills menu bar and toolbar, and lets all shortcuts work in the whole window. Returns the slider for the
/// opacity of people (percent).
QSlider* buildMenus(QMainWindow& window, const Actions& actions);

}  // namespace abstand::ui
