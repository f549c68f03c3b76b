// Reads recordings for the import dialog.
#include "app/studio/import_reader.hpp"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <algorithm>

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "tracking/recording/joint_map_writer.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::studio {

namespace {

constexpr std::size_t kGhostFrames = 400;

QString text(const std::string& s) { return QString::fromStdString(s); }

/// A name as a joint map has it.
std::string nameInMap(const QString& name) {
  return name.contains(QLatin1Char('|')) ? '"' + name.toStdString() + '"' : name.toStdString();
}

std::string mapOf(const QStringList& joints) {
  std::string map = "name: own\n";
  for (int j = 0; j < joints.size(); ++j)
    if (!joints[j].isEmpty())
      map += std::string(humanmodel::jointName(static_cast<humanmodel::Joint>(j))) + ": " +
             nameInMap(joints[j]) + "\n";
  return map;
}

ui::ImportFound describe(const tracking::Recording& recording) {
  const tracking::RecordingReport& report = recording.report;
  ui::ImportFound found;
  found.format = text(report.format);
  found.units = text(report.units.name);
  found.units_guessed = report.units.guessed;
  found.up = text(report.up.axis);
  found.up_guessed = report.up.guessed;
  found.sides = text(report.sides.found);
  found.joint_map = text(report.joint_map);
  found.map_guessed = report.map_use.is_guess;
  found.reason = text(report.map_use.reason);
  found.stature = report.stature;
  found.duration = report.duration;
  found.frame_count = recording.frames.size();
  for (const std::string& name : report.joints) found.names << text(name);
  for (const std::string& part : report.missing_parts) found.missing_parts << text(part);
  for (const std::string& warning : report.warnings) found.warnings << text(warning);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    found.canonical << QString::fromLatin1(humanmodel::jointName(static_cast<humanmodel::Joint>(j)).data());
    QStringList names;
    for (const std::string& name : report.map_use.names[j]) names << text(name);
    found.used << names.join(QStringLiteral(" + "));
  }
  const std::size_t step = std::max<std::size_t>(1, recording.frames.size() / kGhostFrames);
  for (std::size_t i = 0; i < recording.frames.size(); i += step) {
    const humanmodel::SkeletonFrame& frame = recording.frames[i];
    found.frames.push_back({frame.t, {frame.p.begin(), frame.p.end()}});
  }
  return found;
}

}  // namespace

ui::ImportFound readForImport(const QString& file, const ui::ImportWish& wish) {
  ui::ImportFound found;
  try {
    if (QFileInfo(file).isDir())
      throw UsageError(file.toStdString() +
                       ": a folder of depth images has no joints; open it as a recording");
    tracking::RecordingOptions options;
    if (!wish.units.isEmpty()) options.units = wish.units.toStdString();
    if (!wish.up.isEmpty()) options.up = wish.up.toStdString();
    if (!wish.mirror.isEmpty()) options.mirror = wish.mirror.toStdString();
    const QTemporaryDir folder;
    if (!wish.joints.isEmpty()) {
      options.joint_map = QFile::encodeName(folder.filePath(QStringLiteral("own.map"))).toStdString();
      writeFile(options.joint_map, mapOf(wish.joints));
    }
    const tracking::Recording recording =
        tracking::openRecording(QFile::encodeName(file).toStdString(), options);
    found = describe(recording);
    try {
      found.map_text = text(tracking::jointMapText(recording.report));
    } catch (const UsageError&) {
      // Markers that were solved have no map.
    }
  } catch (const std::exception& e) {
    found.problem = QString::fromUtf8(e.what());
  }
  return found;
}

}  // namespace abstand::studio
