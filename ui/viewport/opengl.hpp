// What must happen before the first window, and what kind of OpenGL there is.
#pragma once

#include <QString>

namespace abstand::ui {

/// Sets the default surface format, context sharing, scaling, and XCB where the session is Wayland (this VTK
/// only knows GLX). Call it before QApplication is made. `exact_pixels`: no scaling by the screen's
/// resolution, so that a window of 800x600 gives a picture of 800x600.
void prepareOpenGl(bool exact_pixels = false);

struct OpenGlInfo {
  bool available{false};
  bool software{false};  ///< drawn by the processor: keep the frames cheap
  QString renderer;
};

/// Asked once, by a context of its own; needs a QApplication.
const OpenGlInfo& openGlInfo();

}  // namespace abstand::ui
