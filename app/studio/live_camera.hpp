// A live depth camera for the window: tracker and server as programs beside it.
#pragma once

#include <QObject>
#include <QProcess>
#include <memory>

#include "app/studio/still_robots.hpp"
#include "core/robot_file/mesh_reference.hpp"
#include "ui/model/live_camera_request.hpp"

namespace abstand::studio {

/// Runs `abstand serve` for a scene, and `abstand track live:kinect`, with one or two cameras, which sends it
/// the skeletons of a person. Both end with stop(), with this object, and with the program. GUI thread only.
class LiveCamera : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  ~LiveCamera() override;

  /// `program`: path of `abstand`; empty: it was not found. sees() or failed() follows, unless stop() comes
  /// first. Stops what is running.
  void start(const QString& program, const ui::LiveCameraRequest& request,
             const robot_file::PackagePaths& packages);
  void stop();
  /// After sees(). `joints`: rad or m, of all mechanisms where their motion begins; sent to the server where
  /// the request says that robots stand still.
  void takeJoints(const std::vector<double>& joints);
  /// This object speaks for the robots of the server, and may thus reset their stops.
  bool canReset() const { return still_ != nullptr; }
  void resetStops();
  /// Of the server, "127.0.0.1:40123"; empty: none is running.
  QString address() const { return address_; }

 Q_SIGNALS:
  void progressed(const QString& sentence);
  /// The camera sends images, and the server of `scene` listens.
  void sees(const QString& address, const QString& scene);
  /// Before sees(). `problem`: the error line of the program.
  void failed(const QString& problem);
  /// After sees(): one of two cameras has no usable images any more. `sentence`: the warning of the program.
  void lessSeen(const QString& sentence);
  /// After sees(): whether the robots and objects of the scene are removed from the images has changed.
  void remarked(const QString& sentence);
  /// After sees(), e.g. the camera was unplugged; the server goes on.
  void ended(const QString& problem);

 private:
  void readServer();
  void readTracker();
  void track();
  void readWarnings();
  void end(QProcess& process, const QString& said);

  QString program_;
  ui::LiveCameraRequest request_;
  QStringList packages_;  ///< options
  std::unique_ptr<QProcess> server_, tracker_;
  QString address_, server_said_, tracker_said_;
  int lines_read_{0};  ///< of tracker_said_
  std::unique_ptr<StillRobots> still_;
  bool sees_{false};
};

}  // namespace abstand::studio
