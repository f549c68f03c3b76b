// Opens scenes and recordings for the window.
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <functional>
#include <future>
#include <memory>

#include "app/studio/live_port.hpp"
#include "core/robot_file/mesh_reference.hpp"
#include "ui/main_window.hpp"

namespace abstand::studio {

/// Owns the session shown in the window. Loading runs on a separate thread, so that the window stays
/// responsive and shows progress; after an error the previous session stays. A newer request, and the end of
/// the program, cancel the building of structures for an older one.
class Studio : public QObject {
  Q_OBJECT

 public:
  /// `packages`: search paths for the meshes of the robots.
  explicit Studio(ui::MainWindow& window, robot_file::PackagePaths packages = {});
  ~Studio() override;

  /// Starts loading; ready() or failed() follows. Empty `recording`: that of the scene.
  void openScene(const QString& scene, const QString& recording, double t);
  /// Replaces the recording of the people in the current scene.
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
  std::future<void> loading_;
  std::atomic<bool> cancelled_{false};
  int request_{0};  ///< number of the newest request; results of older ones are dropped
};

}  // namespace abstand::studio
