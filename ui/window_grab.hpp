// A picture of the whole window, with the 3D view in it.
#pragma once

#include <QImage>

namespace abstand::ui {

class MainWindow;

/// Draws the window's widgets and the 3D view into one picture at the screen's resolution. Takes over the
/// newest snapshot first. The window must be shown.
QImage grabWindow(MainWindow& window);

}  // namespace abstand::ui
