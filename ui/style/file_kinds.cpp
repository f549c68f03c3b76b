// What a dropped or chosen file is.
#include "ui/style/file_kinds.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QStringList>

namespace abstand::ui {

namespace {

const QStringList& projectSuffixes() {
  static const QStringList suffixes{"abstand"};
  return suffixes;
}

const QStringList& sceneSuffixes() {
  static const QStringList suffixes{"yaml", "yml"};
  return suffixes;
}

const QStringList& robotSuffixes() {
  static const QStringList suffixes{"urdf", "mech"};
  return suffixes;
}

/// Those that core/mesh_file reads by itself.
const QStringList& meshSuffixes() {
  static const QStringList suffixes{"stl", "obj", "ply", "off", "dae"};
  return suffixes;
}

const QStringList& recordingSuffixes() {
  static const QStringList suffixes{"bvh",    "c3d", "csv", "txt", "trc", "json", "jsonl",
                                    "ndjson", "amc", "asf", "mat", "rec", "h5",   "skeleton"};
  return suffixes;
}

QString patterns(const QStringList& suffixes) {
  QStringList globs;
  for (const QString& suffix : suffixes) globs << QStringLiteral("*.") + suffix;
  return globs.join(QLatin1Char(' '));
}

QString endings(const QStringList& suffixes) {
  QStringList words;
  for (const QString& suffix : suffixes) words << QLatin1Char('.') + suffix;
  return words.join(QStringLiteral(", "));
}

QString withAll(const QString& title, const QStringList& suffixes) {
  return QStringLiteral("%1 (%2);;%3 (*)")
      .arg(title, patterns(suffixes), QCoreApplication::translate("file_kinds", "All files"));
}

/// Looks for the key at the beginning of a line.
bool isMarginSet(const QString& path) {
  constexpr qint64 kLookedAt = 1 << 16;  // bytes
  QFile file(path);
  if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly)) return false;
  const QByteArray text = '\n' + file.read(kLookedAt);
  return text.contains("\nabstand_margins:");
}

}  // namespace

FileKind kindOf(const QString& path) {
  const QFileInfo info(path);
  if (info.isDir()) return FileKind::kRecording;
  const QString suffix = info.suffix().toLower();
  if (projectSuffixes().contains(suffix)) return FileKind::kProject;
  if (sceneSuffixes().contains(suffix)) return isMarginSet(path) ? FileKind::kMargins : FileKind::kScene;
  if (robotSuffixes().contains(suffix)) return FileKind::kRobot;
  if (meshSuffixes().contains(suffix)) return FileKind::kMesh;
  if (recordingSuffixes().contains(suffix)) return FileKind::kRecording;
  if (suffix == QLatin1String("moments")) return FileKind::kMoments;
  return FileKind::kUnknown;
}

QString openFilter() {
  return withAll(QCoreApplication::translate("file_kinds", "Projects, scenes, robots, meshes and recordings"),
                 projectSuffixes() + sceneSuffixes() + robotSuffixes() + meshSuffixes() +
                     recordingSuffixes() + QStringList{"moments"});
}
QString projectFilter() {
  return withAll(QCoreApplication::translate("file_kinds", "Projects"), projectSuffixes());
}
QString recordingEndings() { return endings(recordingSuffixes()); }
QString meshEndings() { return endings(meshSuffixes()); }
QString recordingFilter() {
  return withAll(QCoreApplication::translate("file_kinds", "Recordings"), recordingSuffixes());
}

}  // namespace abstand::ui
