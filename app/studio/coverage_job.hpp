// What a planned depth camera would not see, computed beside the window.
#pragma once

#include <QObject>
#include <atomic>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "app/coverage/coverage.hpp"
#include "app/studio/live_port.hpp"
#include "core/robot_file/mesh_reference.hpp"
#include "ui/document/work.hpp"
#include "ui/model/coverage_report.hpp"

namespace abstand::studio {

/// The sensors that a plan may choose from.
std::vector<ui::SensorKind> sensorKinds();
/// A camera for a plan, as `abstand coverage --camera`.
struct FileCamera {
  ui::SensorLens lens;
  std::optional<Transform> X_W;  ///< optical frame in the world; nullopt: the file has none
};
/// Throws ParseError.
FileCamera cameraOfFile(const QString& file);
/// Throws UsageError for an unknown sensor.
coverage::Sensor sensorOf(const ui::SensorPlan& plan);
ui::CoverageReport reportOf(const coverage::Coverage& coverage);

/// Examines the recording of a document on a thread of its own with low priority, which keeps its session for
/// the next question. GUI thread only.
class CoverageJob : public QObject {
  Q_OBJECT

 public:
  using Made = std::map<std::string, std::shared_ptr<const structure::HapticStructure>>;

  /// `work`: as it is shown, with the things where they are now. `made`: structures by object, shared with
  /// the session that is shown.
  CoverageJob(const ui::Work& work, robot_file::PackagePaths packages, Made made, QObject* parent = nullptr);
  /// Waits, at most for the reading of a file or one moment; not after ended().
  ~CoverageJob() override;

  /// progressed(), and then done() or failed(), follow, unless another start() or cancel() comes first.
  void start(const ui::SensorPlan& plan);
  void cancel();
  /// Nothing follows but ended(), soon.
  void stop();
  const ui::Work& work() const { return work_; }

 Q_SIGNALS:
  /// `all` 0: files are being read.
  void progressed(int done, int all);
  void done(const abstand::ui::CoverageReport& report);
  void failed(const QString& problem);
  /// After stop().
  void ended();

 private:
  void run();
  void answer(const ui::SensorPlan& plan, long question);
  bool isOld(long question) const { return stopped_ || question != asked_; }
  template <class Call>
  void post(long question, Call call);

  const ui::Work work_;
  const robot_file::PackagePaths packages_;
  Made made_;
  std::unique_ptr<session::Session> session_;  // of the thread
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<ui::SensorPlan> next_;  // guarded by mutex_
  std::atomic<long> asked_{0};          // number of the newest question
  std::atomic<bool> stopped_{false};
  std::jthread thread_;
};

/// The job of what is shown; a new one where the work has changed. Only the destructor waits for one that is
/// no longer needed. GUI thread only.
class CoverageDesk : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Another session is shown. `outline`, `structures`: of it.
  void open(const view::SceneOutline& outline, const Structures& structures);
  void close();
  void start(const ui::Work& work, const robot_file::PackagePaths& packages, const ui::SensorPlan& plan);
  void cancel();

 Q_SIGNALS:
  void progressed(int done, int all);
  void done(const abstand::ui::CoverageReport& report);
  void failed(const QString& problem);

 private:
  void retire();

  CoverageJob::Made made_;
  std::unique_ptr<CoverageJob> job_;
};

}  // namespace abstand::studio
