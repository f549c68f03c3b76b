// Opens scenes and recordings in the window.
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <functional>
#include <future>
#include <memory>

#include "app/analysis/analysis_runner.hpp"
#include "app/studio/live_port.hpp"
#include "core/robot_file/mesh_reference.hpp"
#include "ui/main_window.hpp"

namespace abstand::studio {

/// Owns the session that the window shows. Loading runs on a thread of its own, so that the window stays
/// alive and shows how far it is; a file that cannot be read leaves what was there before. A newer request,
/// and the end of the program, end the building of structures for an older one.
class Studio : public QObject {
  Q_OBJECT

 public:
  /// `packages`: where the robots of all scenes have their meshes.
  explicit Studio(ui::MainWindow& window, robot_file::PackagePaths packages = {});
  ~Studio() override;

  /// Begins to load; ready() or failed() follows. An empty recording: as the scene says.
  void openScene(const QString& scene, const QString& recording, double t);
  /// Replaces the recording of the people in the present scene.
  void openRecording(const QString& recording);

 Q_SIGNALS:
  void ready();
  void failed(const QString& problem);

 private:
  struct Loaded;
  void stopLoading();
  void take(std::shared_ptr<Loaded> loaded);

  ui::MainWindow& window_;
  const robot_file::PackagePaths packages_;
  std::unique_ptr<LivePort> port_;
  QString scene_;
  analysis::AnalysisRunner analyses_;
  std::future<void> loading_;
  std::atomic<bool> cancelled_{false};
  int request_{0};  ///< number of the newest request; answers to older ones are dropped
};

}  // namespace abstand::studio
