#include "app/studio/studio.hpp"
#include "app/depth/open_session.hpp"

#include <QApplication>
#include <QMetaObject>

#include "app/run/scene_notes.hpp"
#include "app/studio/opening_progress.hpp"
#include "core/base/error.hpp"
#include "ui/panels/status_panel.hpp"

namespace abstand::studio {

struct Studio::Loaded {
  int request{0};
  QString scene;
  std::unique_ptr<loop::LiveSession> live;
  std::vector<scene::SceneNote> notes;
  std::optional<analysis::AnalysisRequest> analysis;
  QString problem;
};

Studio::Studio(ui::MainWindow& window, robot_file::PackagePaths packages)
    : window_(window), packages_(std::move(packages)) {
  connect(&window, &ui::MainWindow::openSceneRequested, this,
          [this](const QString& path) { openScene(path, QString(), 0.0); });
  connect(&window, &ui::MainWindow::openRecordingRequested, this, &Studio::openRecording);
}

Studio::~Studio() {
  window_.setSession(nullptr);
  stopLoading();
}

void Studio::stopLoading() {
  cancelled_ = true;
  if (loading_.valid()) loading_.wait();
  cancelled_ = false;
}

void Studio::openScene(const QString& scene, const QString& recording, double t) {
  stopLoading();
  QApplication::setOverrideCursor(Qt::BusyCursor);
  const int request = ++request_;
  window_.showOpening({});
  loading_ = std::async(std::launch::async, [this, scene, recording, t, request] {
    auto loaded = std::make_shared<Loaded>();
    loaded->request = request;
    loaded->scene = scene;
    try {
      session::SessionOptions options;
      options.recording = recording.toStdString();
      OpeningProgress progress([this, request](const ui::Opening& opening) {
        QMetaObject::invokeMethod(
            this,
            [this, request, opening] {
              if (request == request_) window_.showOpening(opening);
            },
            Qt::QueuedConnection);
      });
      options.planned = [&progress](std::size_t structures) { progress.plan(structures); };
      options.monitor.progress = [&progress](double fraction, std::string_view name) {
        progress.hear(fraction, name);
      };
      options.monitor.cancelled = [this] { return cancelled_.load(); };
      auto session = depth::openSession(scene_file::loadScene(scene.toStdString(), packages_), options);
      loaded->notes = run::notesOf(*session);
      loaded->analysis = analysis::requestFor(*session, options.recording);
      loaded->live = std::make_unique<loop::LiveSession>(std::move(session), t);
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
  window_.hideOpening();
  if (!loaded->live) {
    window_.showProblem(tr("Cannot open"), loaded->problem);
    Q_EMIT failed(loaded->problem);
    return;
  }
  window_.setSession(nullptr);
  analyses_.stop();
  std::unique_ptr<FeedPort> feed;
  if (loaded->analysis) feed = std::make_unique<FeedPort>(analyses_.start(std::move(*loaded->analysis)));
  port_ = std::make_unique<LivePort>(std::move(loaded->live), std::move(loaded->notes), std::move(feed));
  scene_ = loaded->scene;
  window_.setSession(port_.get());
  Q_EMIT ready();
}

}  // namespace abstand::studio
