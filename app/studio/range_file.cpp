// A stretch of a recording as a recording of its own.
#include "app/studio/range_file.hpp"

#include <QFile>
#include <QMetaObject>
#include <algorithm>
#include <filesystem>

#include "app/studio/scene_of_file.hpp"
#include "app/studio/scene_of_work.hpp"
#include "core/base/error.hpp"
#include "tracking/compact/compact_recording.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::studio {

void writeRange(const ui::Work& work, const robot_file::PackagePaths& packages, const std::string& person,
                const ui::TimeRange& range, const QString& file) {
  scene_file::SceneDescription scene = sceneOf(work, packages);
  applyWork(work, scene);
  const auto human = std::find_if(scene.humans.begin(), scene.humans.end(),
                                  [&](const auto& each) { return each.name == person; });
  if (human == scene.humans.end()) throw UsageError("the scene has no person '" + person + "'");
  const std::filesystem::path from =
      work.recording.isEmpty() ? human->recording.file
                               : std::filesystem::path(QFile::encodeName(work.recording).toStdString());
  if (from.empty()) throw UsageError("no recording moves '" + person + "'");
  if (std::filesystem::is_directory(from))
    throw UsageError(from.string() +
                     ": found a folder of depth images, expected a file of joints or markers");
  tracking::Recording recording = tracking::openRecording(from, human->recording.options);
  // A recording that plays faster does so from its first frame on.
  const double speed = human->recording.speed * work.reading.speed;
  const double first = recording.frames.empty() ? 0.0 : recording.frames.front().t;
  std::erase_if(recording.frames, [&](const humanmodel::SkeletonFrame& frame) {
    return !range.contains(first + (frame.t - first) / speed);
  });
  if (recording.frames.empty()) throw UsageError(from.string() + ": found no frame between IN and OUT");
  tracking::writeCompact(std::filesystem::path(QFile::encodeName(file).toStdString()), recording);
}

RangeJob::~RangeJob() = default;

void RangeJob::start(const ui::Work& work, const robot_file::PackagePaths& packages,
                     const std::string& person, const ui::TimeRange& range, const QString& file) {
  thread_ = std::jthread([=, this] {
    QString problem;
    try {
      writeRange(work, packages, person, range, file);
    } catch (const std::exception& e) {
      problem = QString::fromUtf8(e.what());
    }
    const auto tell = [this, file, problem] {
      problem.isEmpty() ? Q_EMIT done(file) : Q_EMIT failed(problem);
    };
    QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
  });
}

}  // namespace abstand::studio
