// The window with a made-up session: to look at, and for pictures.
// ui_demo [--screenshot FILE.png] [--at SECONDS] [--size WxH] [--dark] [--velocities] [--select NAME]
// [--stale NAME] [--camera KEY] [--empty]
#include <QAction>
#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QTimer>
#include <cstdio>

#include "tests/ui/fake_session.hpp"
#include "ui/main_window.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/selection.hpp"
#include "ui/style/actions.hpp"
#include "ui/viewport/opengl.hpp"
#include "ui/viewport/viewport.hpp"
#include "ui/window_grab.hpp"

using namespace abstand::ui;

namespace {

void spin(int ms) {
  QElapsedTimer timer;
  timer.start();
  while (timer.elapsed() < ms) QApplication::processEvents(QEventLoop::AllEvents, 10);
}

}  // namespace

int main(int argc, char** argv) {
  prepareOpenGl(true);
  QApplication app(argc, argv);
  QCoreApplication::setOrganizationName(QStringLiteral("AbstandDemo"));
  QCoreApplication::setApplicationName(QStringLiteral("Demo"));
  QCommandLineParser options;
  options.addOptions({{"screenshot", "Save a picture and end.", "file"},
                      {"at", "Time to play up to.", "seconds", "4.0"},
                      {"size", "Size of the window.", "WxH", "1440x900"},
                      {"dark", "Dark theme."},
                      {"velocities", "Show velocities."},
                      {"stale", "Lose the pose of an object.", "name"},
                      {"camera", "1, 3, 5 or 7, as the keys.", "key", "5"},
                      {"empty", "No session."},
                      {"select", "Choose an object.", "name"}});
  options.process(app);

  FakeSession session;
  MainWindow window;
  const QStringList size = options.value("size").split('x');
  window.resize(size.value(0).toInt(), size.value(1).toInt());
  window.actions()[ActionId::kDarkTheme]->setChecked(options.isSet("dark"));
  window.actions()[ActionId::kVelocities]->setChecked(options.isSet("velocities"));
  if (!options.isSet("empty")) window.setSession(&session);
  window.show();
  if (!options.isSet("screenshot")) {
    QTimer clock;
    QObject::connect(&clock, &QTimer::timeout, &clock, [&session] { session.advance(0.02); });
    clock.start(20);
    return QApplication::exec();
  }

  // Play up to the time, drawing on the way.
  session.play(true);
  QElapsedTimer wall;
  wall.start();
  while (session.time() < options.value("at").toDouble() && session.playing()) {
    session.advance(0.02);
    QApplication::processEvents();
  }
  window.playback().setPlaying(false);
  if (options.isSet("select"))
    window.selection().setObjects({session.indexOf(options.value("select").toStdString())});
  if (options.isSet("stale"))
    session.setPoseState(session.indexOf(options.value("stale").toStdString()),
                         abstand::scene::PoseState::kStale);
  for (const ActionId id : {ActionId::kFront, ActionId::kSide, ActionId::kTop, ActionId::kIso})
    if (window.actions()[id]->shortcut().toString() == options.value("camera"))
      window.actions()[id]->trigger();
  spin(400);
  std::printf("%ld frames, %s, last %lld ms\n", window.viewport().framesDrawn(),
              qPrintable(openGlInfo().renderer), static_cast<long long>(wall.elapsed()));
  return grabWindow(window).save(options.value("screenshot")) ? 0 : 1;
}
