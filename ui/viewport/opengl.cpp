// What must happen before the first window, and what kind of OpenGL there is.
#include "ui/viewport/opengl.hpp"

#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <QThread>
#include <algorithm>

namespace abstand::ui {

void prepareOpenGl(bool exact_pixels) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") &&
      (qEnvironmentVariable("XDG_SESSION_TYPE") == QLatin1String("wayland") ||
       !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")))
    qputenv("QT_QPA_PLATFORM", "xcb");
  // Mesa would draw with as many threads as there are cores, and wait for each of them: where the loop and
  // others want a core too, half as many are quicker.
  if (qEnvironmentVariableIsEmpty("LP_NUM_THREADS"))
    qputenv("LP_NUM_THREADS", QByteArray::number(std::max(1, QThread::idealThreadCount() / 2)));
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
  QCoreApplication::setAttribute(exact_pixels ? Qt::AA_DisableHighDpiScaling : Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QGuiApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
}

const OpenGlInfo& openGlInfo() {
  static const OpenGlInfo info = [] {
    OpenGlInfo found;
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    if (!context.create() || !surface.isValid() || !context.makeCurrent(&surface)) return found;
    const GLubyte* renderer = context.functions()->glGetString(GL_RENDERER);
    found.renderer = QString::fromLatin1(reinterpret_cast<const char*>(renderer));
    // VTK draws with OpenGL 3.2 core.
    found.available = context.format().version() >= qMakePair(3, 2);
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SwiftShader", "Software"})
      found.software |= found.renderer.contains(QLatin1String(name), Qt::CaseInsensitive);
    context.doneCurrent();
    return found;
  }();
  return info;
}

}  // namespace abstand::ui
