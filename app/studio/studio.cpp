#include "app/studio/studio.hpp"

#include <QApplication>
#include <QMetaObject>

#include "core/base/error.hpp"

namespace abstand {

struct Studio::Loaded {
  int request{0};
  QString scene;
  double t{0.0};
  std::unique_ptr<Session> session;
  QString problem;
};

Studio::Studio(ui::MainWindow& window) : window_(window) {
  connect(&window, &ui::MainWindow::openSceneRequested, this,
          [this](const QString& path) { openScene(path, QString(), 0.0); });
  connect(&window, &ui::MainWindow::openRecordingRequested, this, &Studio::openRecording);
}

Studio::~Studio() {
  window_.setSession(nullptr);
  if (loading_.valid()) loading_.wait();
}

void Studio::openScene(const QString& scene, const QString& recording, double t) {
  if (loading_.valid()) loading_.wait();
  QApplication::setOverrideCursor(Qt::BusyCursor);
  const int request = ++request_;
  loading_ = std::async(std::launch::async, [this, scene, recording, t, request] {
    auto loaded = std::make_shared<Loaded>();
    loaded->request = request;
    loaded->scene = scene;
    loaded->t = t;
    try {
      SessionOptions options;
      options.recording = recording.toStdString();
      loaded->session = std::make_unique<Session>(loadScene(scene.toStdString()), options);
    } catch (const std::exception& e) {
      loaded->problem = QString::fromUtf8(e.what());
    }
    QMetaObject::invokeMethod(
        this, [this, loaded] { take(loaded); }, Qt::QueuedConnection);
  });
}

void Studio::openRecording(const QString& recording) {
  if (scene_.isEmpty()) {
    window_.showProblem(tr("No scene"), tr("Open a scene first: a recording moves the person of a scene."));
    return;
  }
  openScene(scene_, recording, 0.0);
}

void Studio::take(std::shared_ptr<Loaded> loaded) {
  QApplication::restoreOverrideCursor();
  if (loaded->request != request_) return;
  if (!loaded->session) {
    window_.showProblem(tr("Cannot open"), loaded->problem);
    Q_EMIT failed(loaded->problem);
    return;
  }
  window_.setSession(nullptr);
  port_ = std::make_unique<LivePort>(std::make_unique<LiveSession>(std::move(loaded->session), loaded->t));
  scene_ = loaded->scene;
  window_.setSession(port_.get());
  Q_EMIT ready();
}

}  // namespace abstand
