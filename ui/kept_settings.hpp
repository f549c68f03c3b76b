// What of the window outlives the program: its place, its layout, the user's taste.
#pragma once

class QMainWindow;
class QSlider;

namespace abstand::ui {

class Actions;

/// `opacity`: the slider of people's opacity. Both use the settings of the program.
/// True where a layout was kept.
bool restoreSettings(QMainWindow& window, const Actions& actions, QSlider& opacity);
void saveSettings(const QMainWindow& window, const Actions& actions, const QSlider& opacity);

}  // namespace abstand::ui
