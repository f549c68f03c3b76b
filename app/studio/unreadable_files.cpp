#include "app/studio/unreadable_files.hpp"

#include <QFile>
#include <filesystem>
#include <functional>

#include "app/depth/open_session.hpp"
#include "app/studio/scene_of_file.hpp"
#include "app/studio/scene_of_work.hpp"
#include "core/mesh_file/mesh_file.hpp"

namespace abstand::studio {

namespace {

/// The reason, with the file's name; empty: `read` reads it.
QString whyUnreadable(const QString& file, const std::function<void()>& read) {
  try {
    read();
    return {};
  } catch (const std::exception& e) {
    const QString reason = QString::fromUtf8(e.what()).section(QLatin1Char('\n'), 0, 0);
    return reason.contains(file) ? reason : file + QStringLiteral(": ") + reason;
  }
}

void readScene(const ui::Work& work, const robot_file::PackagePaths& packages) {
  const scene_file::SceneDescription scene = sceneOf(work, packages);
  for (const auto& mechanism : scene.mechanisms)
    for (const auto& link : mechanism.links)
      if (!link.mesh.empty()) mesh_file::loadMesh(link.mesh);
}

void readRecording(const ui::Work& work, const robot_file::PackagePaths& packages) {
  scene_file::SceneDescription scene = sceneOf(work, packages);
  applyWork(work, scene);
  session::SessionOptions options;
  options.recording = QFile::encodeName(work.recording).toStdString();
  depth::openSession(std::move(scene), options);
}

}  // namespace

QStringList leaveOutUnreadable(ui::Work& work, const robot_file::PackagePaths& packages) {
  QStringList sentences;
  ui::Work one;
  if (!work.scene.isEmpty()) {
    one.scene = work.scene;
    const QString why = whyUnreadable(work.scene, [&] { readScene(one, packages); });
    if (!why.isEmpty()) {
      sentences << why;
      work.scene.clear();
    }
  }
  QStringList added;
  for (const QString& file : work.added_files) {
    one = {};
    one.added_files << file;
    const QString why = whyUnreadable(file, [&] { readScene(one, packages); });
    if (why.isEmpty())
      added << file;
    else
      sentences << why;
  }
  work.added_files = added;
  // The next one to choose from takes its place.
  while (!work.recording.isEmpty()) {
    one = {};
    one.recording = work.recording;
    one.reading = work.reading;
    const QString why = whyUnreadable(work.recording, [&] { readRecording(one, packages); });
    if (why.isEmpty()) break;
    sentences << why;
    work.recordings.removeAll(work.recording);
    work.recording = work.recordings.value(0);
  }
  if (work.recordings.size() < 2) work.recordings.clear();
  return sentences;
}

}  // namespace abstand::studio
