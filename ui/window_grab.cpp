// A picture of the whole window, with the 3D view in it.
#include "ui/window_grab.hpp"

#include <QPainter>

#include "ui/main_window.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

QImage grabWindow(MainWindow& window) {
  window.pull();
  // The OpenGL child is drawn apart: what a widget grab holds of it differs from driver to driver.
  Viewport& viewport = window.viewport();
  const QImage view = viewport.picture();
  QImage image = window.grab().toImage().convertToFormat(QImage::Format_RGB32);
  QPainter painter(&image);
  painter.drawImage(viewport.mapTo(&window, QPoint()), view);
  return image;
}

}  // namespace abstand::ui
