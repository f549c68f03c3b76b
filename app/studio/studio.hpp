// Opens projects, scenes and recordings in the window.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "app/analysis/analysis_runner.hpp"
#include "app/studio/calibration_job.hpp"
#include "app/studio/coverage_job.hpp"
#include "app/studio/file_watch.hpp"
#include "app/studio/live_camera.hpp"
#include "app/studio/live_opening.hpp"
#include "app/studio/live_port.hpp"
#include "app/studio/loader.hpp"
#include "app/studio/range_file.hpp"
#include "app/studio/recording_analysis.hpp"
#include "app/studio/report_job.hpp"
#include "app/studio/speed_job.hpp"
#include "app/studio/verification_job.hpp"
#include "core/robot_file/mesh_reference.hpp"
#include "ui/main_window.hpp"
#include "ui/model/file_batch.hpp"

namespace abstand::studio {

/// Owns the session that the window shows, and keeps it in step with the scene and the recording of the
/// window's document. Loading runs on a thread of its own; a file that cannot be read leaves what was there
/// before.
class Studio : public QObject {
  Q_OBJECT

 public:
  /// `packages`: search paths for the meshes of the robots.
  explicit Studio(ui::MainWindow& window, const robot_file::PackagePaths& packages = {});
  ~Studio() override;

  /// Begins to load; ready() or failed() follows. An empty recording: as the scene says. The scene of the
  /// present document is loaded anew, and the document stays; any other begins a new document.
  void openScene(const QString& scene, const QString& recording, double t);
  /// Replaces the recordings of the people in the present scene, as an edit of the document. Without a scene
  /// the person of the recording is shown alone, and beside a robot in front of it (defaultPlacement()).
  void openRecording(const QString& recording);
  /// Shows files together. A batch with a scene begins a new document if it is fresh; what else it has is an
  /// edit of the document. A file of it that cannot be read is left out, with leftOut().
  void openBatch(const ui::FileBatch& batch);
  /// Begins with a document that was read.
  void openProject(const ui::Project& project, const QString& file, bool modified);
  /// Shows what a running server computes, in the window's scene; an empty `scene`: the file that it states.
  /// ready() or failed() follows.
  void connectTo(const QString& address, const QString& scene);
  /// Shows recorded moments of a server; `scene` likewise.
  void openMoments(const QString& file, const QString& scene);
  /// Builds one person of the present scene anew, as an edit of the document. Camera, margins, selection and
  /// the clock stay. The options that change nothing are those of the scene.
  void changePerson(const QString& name, const ui::PersonOptions& options);
  /// Reads scene and recording again; the document and the moment stay. So it does by itself when one of
  /// their files was written anew; where that cannot be read, what is shown stays.
  void reload();
  /// Ends the load that is under way; what is shown stays.
  void cancel();
  /// Begins with nothing.
  void close();

 Q_SIGNALS:
  void ready();
  void failed(const QString& problem);
  /// The others are shown: ready() follows.
  void leftOut(const QStringList& sentences);

 private:
  struct Request;
  void load(Request request);
  void take(Loaded& loaded);
  void editDocument(const Request& request);
  void giveUp(const Request& request);
  void followWork(const ui::Work& before, const ui::Work& after);
  ui::Work tunedWork() const;
  void makeReport(const ui::ReportRequest& request);
  void proposeSpeeds(const ui::SpeedRequest& request);
  void connectVerification();
  void connectExchange();
  void connectCoverage();
  void connectCalibration();
  void openPairs(const QString& robot, const QString& file);
  void savePairs(const QString& robot, const QString& file);
  void connectLive();
  void connectLiveCamera();
  void openLive(std::shared_ptr<LiveSource> source, const QString& scene);
  void disconnectLive();
  void fail(const QString& problem);
  std::unique_ptr<ui::SessionPort> portOf(Loaded& loaded, const Request& request);
  static void takeRecording(const QString& recording, ui::Work& work);
  void readAgain(const QStringList& changed);
  void sayOpened(const Request& request, const Loaded& loaded);
  void sayUnread(const Request& request, const QString& problem);

  ui::MainWindow& window_;
  robot_file::PackagePaths packages_;
  Loader loader_;
  std::unique_ptr<ui::SessionPort> port_;
  SceneBodies bodies_;  // of the scene that port_ shows
  RecordingAnalysis analysis_;
  std::unique_ptr<Request> request_;  // of the load that is under way
  ui::Work shown_;                    // what port_ was loaded from
  std::unique_ptr<ReportJob> report_;
  std::unique_ptr<SpeedJob> speeds_;
  VerificationJob verification_;
  std::unique_ptr<CalibrationJob> calibration_;
  RangeJob range_;
  CoverageDesk coverage_;
  LiveCamera camera_;
  LiveOpening opening_;
  std::shared_ptr<viewer::LiveRecord> record_;  // of port_, where it shows a server
  MomentSaving saving_;
  FileWatch watch_;  // of what is shown
};

}  // namespace abstand::studio
