#include "app/studio/coverage_job.hpp"

#include <QFile>
#include <QFileInfo>
#include <QMetaObject>

#include "app/coverage/summary.hpp"
#include "app/depth/open_session.hpp"
#include "app/studio/scene_of_file.hpp"
#include "app/studio/scene_of_work.hpp"
#include "core/base/background_thread.hpp"
#include "ui/panels/lens_kind.hpp"

namespace abstand::studio {

namespace {

constexpr int kTellEvery = 8;  // sampled times between two reports of progress

static_assert(ui::kHiddenByCount == coverage::kCauses);
static_assert(static_cast<int>(ui::HiddenBy::kOtherPerson) ==
              static_cast<int>(coverage::Cause::kOtherPerson));

ui::SensorLens lensOf(const coverage::Sensor& sensor, const QString& name) {
  const tracking::DepthCamera& camera = sensor.camera;
  return {name,      camera.width, camera.height,  camera.fx,      camera.fy,
          camera.cx, camera.cy,    sensor.nearest, sensor.farthest};
}

}  // namespace

std::vector<ui::SensorKind> sensorKinds() {
  std::vector<ui::SensorKind> kinds;
  for (const std::string& name : coverage::sensorNames()) {
    const QString title = name == "kinect" ? QStringLiteral("Kinect v1") : QStringLiteral("Kinect v2");
    kinds.push_back(ui::kindOf(lensOf(coverage::sensorNamed(name), title), QString::fromStdString(name)));
  }
  return kinds;
}

FileCamera cameraOfFile(const QString& file) {
  const coverage::Sensor sensor = coverage::sensorOfFile(QFile::encodeName(file).toStdString());
  FileCamera camera{lensOf(sensor, QFileInfo(file).fileName()), std::nullopt};
  // A camera file without a pose has its camera at the origin.
  if (!sensor.camera.X_WC.isApprox(Transform::Identity())) camera.X_W = sensor.camera.X_WC;
  return camera;
}

coverage::Sensor sensorOf(const ui::SensorPlan& plan) {
  coverage::Sensor sensor;
  if (plan.sensor == ui::kFileSensor && plan.lens) {
    const ui::SensorLens& lens = *plan.lens;
    sensor.camera.width = lens.width;
    sensor.camera.height = lens.height;
    sensor.camera.fx = lens.fx;
    sensor.camera.fy = lens.fy;
    sensor.camera.cx = lens.cx;
    sensor.camera.cy = lens.cy;
    sensor.nearest = lens.nearest;
    sensor.farthest = lens.farthest;
  } else {
    sensor = coverage::sensorNamed(plan.sensor.toStdString());
  }
  sensor.camera.X_WC = plan.X_W();
  return sensor;
}

ui::CoverageReport reportOf(const coverage::Coverage& coverage) {
  ui::CoverageReport report;
  report.columns = coverage.columns;
  report.rows = coverage.rows;
  if (!coverage.times.empty()) {
    report.from = coverage.times.front();
    report.to = coverage.times.back();
  }
  for (const coverage::PartCoverage& each : coverage.parts) {
    const coverage::PartSummary summary = coverage::summarize(coverage.times, each.shares);
    ui::CoveragePart part;
    part.name = QString::fromStdString(each.name);
    for (std::size_t k = 0; k < coverage::kCauses; ++k) {
      part.times[k] = static_cast<double>(summary.times[k]);
      part.surface[k] = static_cast<double>(summary.surface[k]);
    }
    for (const coverage::HiddenSpan& span : summary.spans)
      part.spans.push_back({span.t0, span.t1, static_cast<ui::HiddenBy>(span.cause)});
    if (const coverage::HiddenSpan* longest = summary.longest())
      part.longest = static_cast<int>(longest - summary.spans.data());
    report.parts.push_back(std::move(part));
  }
  return report;
}

CoverageJob::CoverageJob(const ui::Work& work, robot_file::PackagePaths packages, Made made, QObject* parent)
    : QObject(parent), work_(work), packages_(std::move(packages)), made_(std::move(made)), thread_([this] {
        run();
      }) {}

CoverageJob::~CoverageJob() { stop(); }

void CoverageJob::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_all();
}

void CoverageJob::start(const ui::SensorPlan& plan) {
  {
    const std::lock_guard lock(mutex_);
    ++asked_;
    next_ = plan;
  }
  changed_.notify_all();
}

void CoverageJob::cancel() {
  const std::lock_guard lock(mutex_);
  ++asked_;
  next_.reset();
}

template <class Call>
void CoverageJob::post(long question, Call call) {
  QMetaObject::invokeMethod(
      this,
      [this, question, call] {
        if (!isOld(question)) call();
      },
      Qt::QueuedConnection);
}

void CoverageJob::run() {
  beBackgroundThread("coverage");
  for (;;) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopped_ || next_; });
    if (stopped_) break;
    const ui::SensorPlan plan = *std::exchange(next_, std::nullopt);
    const long question = asked_;
    lock.unlock();
    answer(plan, question);
  }
  QMetaObject::invokeMethod(this, &CoverageJob::ended, Qt::QueuedConnection);
}

void CoverageJob::answer(const ui::SensorPlan& plan, long question) {
  try {
    if (!session_) {
      post(question, [this] { Q_EMIT progressed(0, 0); });
      scene_file::SceneDescription scene = sceneOf(work_, packages_);
      applyWork(work_, scene);
      placeThings(work_, scene);
      session::SessionOptions options;
      options.recording = QFile::encodeName(work_.recording).toStdString();
      options.person_speed = work_.reading.speed;
      if (work_.reading.cut_things) options.cut_things = true;
      options.threads = 1;
      options.made = made_;
      // What was read stays for the next question.
      options.monitor.cancelled = [this] { return stopped_.load(); };
      session_ = depth::openSession(std::move(scene), options);
    }
    coverage::CoverageOptions options;
    options.sensor = sensorOf(plan);
    options.interrupted = [this, question] { return isOld(question); };
    options.progress = [this, question](std::size_t done, std::size_t all) {
      if (done % kTellEvery != 0) return;
      post(question, [this, done, all] { Q_EMIT progressed(static_cast<int>(done), static_cast<int>(all)); });
    };
    const coverage::Coverage coverage = coverage::evaluateCoverage(*session_, options);
    if (!coverage.interrupted) post(question, [this, report = reportOf(coverage)] { Q_EMIT done(report); });
  } catch (const std::exception& e) {
    post(question, [this, problem = QString::fromUtf8(e.what())] { Q_EMIT failed(problem); });
  }
}

void CoverageDesk::open(const view::SceneOutline& outline, const Structures& structures) {
  close();
  for (std::size_t i = 0; i < structures.size() && i < outline.objects.size(); ++i)
    made_[outline.objects[i].name] = structures[i];
}

void CoverageDesk::close() {
  made_.clear();
  retire();
}

void CoverageDesk::retire() {
  if (!job_) return;
  job_->disconnect(this);
  CoverageJob* ending = job_.release();
  ending->setParent(this);
  connect(ending, &CoverageJob::ended, ending, &QObject::deleteLater);
  ending->stop();
}

void CoverageDesk::start(const ui::Work& work, const robot_file::PackagePaths& packages,
                         const ui::SensorPlan& plan) {
  if (job_ && !(job_->work() == work)) retire();
  if (!job_) {
    job_ = std::make_unique<CoverageJob>(work, packages, made_);
    connect(job_.get(), &CoverageJob::progressed, this, &CoverageDesk::progressed);
    connect(job_.get(), &CoverageJob::done, this, &CoverageDesk::done);
    connect(job_.get(), &CoverageJob::failed, this, &CoverageDesk::failed);
  }
  job_->start(plan);
}

void CoverageDesk::cancel() {
  if (job_) job_->cancel();
}

}  // namespace abstand::studio
