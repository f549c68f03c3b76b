#include "app/studio/file_watch.hpp"

#include <QDir>
#include <QFileInfo>
#include <utility>

namespace abstand::studio {

namespace {

/// A folder of depth images is described by these two files; the images are many, and are not edited.
QStringList filesIn(const QStringList& paths) {
  QStringList files;
  for (const QString& path : paths) {
    if (!QFileInfo(path).isDir())
      files << path;
    else
      files << QDir(path).filePath(QStringLiteral("camera.yaml"))
            << QDir(path).filePath(QStringLiteral("depth.txt"));
  }
  return files;
}

}  // namespace

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
  timer_.setSingleShot(true);
  timer_.setInterval(kSettleMs);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, [this](const QString& file) {
    waits_[file] = stampOf(file);
    timer_.start();
  });
  connect(&timer_, &QTimer::timeout, this, &FileWatch::settle);
}

FileWatch::Stamp FileWatch::stampOf(const QString& file) {
  const QFileInfo info(file);
  return {info.lastModified(), info.exists() ? info.size() : -1};
}

void FileWatch::add(const QString& file) {
  if (!QFileInfo(file).isFile()) return;
  watcher_.addPath(file);
  known_[file] = stampOf(file);
}

void FileWatch::watch(const QStringList& paths) {
  const QStringList files = filesIn(paths);
  // What changed while it was read is still to be told.
  const QMap<QString, Stamp> before = std::exchange(known_, {});
  for (const QString& file : waits_.keys())
    if (!files.contains(file)) waits_.remove(file);
  if (!watcher_.files().isEmpty()) watcher_.removePaths(watcher_.files());
  for (const QString& file : files) add(file);
  for (const QString& file : waits_.keys()) known_[file] = before.value(file);
}

/// A file that is away, or was written meanwhile, waits on.
void FileWatch::settle() {
  QStringList done;
  for (const QString& file : waits_.keys()) {
    const Stamp now = stampOf(file);
    const bool rests = now == waits_[file] && now.second >= 0;
    waits_[file] = now;
    if (!rests) continue;
    waits_.remove(file);
    if (now != known_.value(file)) done << file;
    add(file);  // one that was replaced is watched no longer
  }
  if (!waits_.isEmpty()) timer_.start();
  if (!done.isEmpty()) Q_EMIT changed(done);
}

}  // namespace abstand::studio
