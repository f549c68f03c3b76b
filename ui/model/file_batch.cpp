#include "ui/model/file_batch.hpp"

#include <QFileInfo>

#include "ui/style/file_kinds.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

/// Takes a file where only one can be shown.
void takeOne(QString& place, const QString& file, const QString& what, QStringList& problems) {
  if (place.isEmpty())
    place = file;
  else
    problems << tr("%1 was not opened: %2 at a time, and %3 is there.")
                    .arg(file, what, QFileInfo(place).fileName());
}

void sortInto(SortedFiles& sorted, const QString& file) {
  switch (kindOf(file)) {
    case FileKind::kProject:
      return takeOne(sorted.project, file, tr("one project is shown"), sorted.problems);
    case FileKind::kScene:
      return takeOne(sorted.batch.scene, file, tr("one scene is shown"), sorted.problems);
    case FileKind::kRobot:
    case FileKind::kMesh:
      sorted.batch.added << file;
      return;
    case FileKind::kRecording:
      if (!sorted.batch.recordings.contains(file)) sorted.batch.recordings << file;
      return;
    case FileKind::kMargins:
      return takeOne(sorted.margins, file, tr("one set of margins holds"), sorted.problems);
    case FileKind::kMoments:
      return takeOne(sorted.moments, file, tr("one recording of a server is shown"), sorted.problems);
    case FileKind::kUnknown:
      break;
  }
}

}  // namespace

QString whyNotOpened(const QString& file) {
  if (kindOf(file) != FileKind::kUnknown)
    return QFileInfo::exists(file) ? QString() : tr("%1 was not found.").arg(file);
  return tr("%1 is no file that this program opens: it opens projects (.abstand), scenes and margins "
            "(.yaml), robots (.urdf, .mech), meshes (%2) and recordings, which are folders of depth images "
            "and the files %3.")
      .arg(file, meshEndings(), recordingEndings());
}

SortedFiles sortedFiles(const QStringList& files, bool has_scene) {
  SortedFiles sorted;
  for (const QString& file : files) {
    if (file.isEmpty()) continue;
    const QString why = whyNotOpened(file);
    if (why.isEmpty())
      sortInto(sorted, file);
    else
      sorted.problems << why;
  }
  FileBatch& batch = sorted.batch;
  batch.recording = batch.recordings.value(0);
  if (batch.recordings.size() < 2) batch.recordings.clear();
  if (!sorted.project.isEmpty() && !batch.scene.isEmpty()) {
    sorted.problems << tr("%1 was not opened: the project %2 has a scene.")
                           .arg(batch.scene, QFileInfo(sorted.project).fileName());
    batch.scene.clear();
  }
  if (!sorted.moments.isEmpty() && (!batch.empty() || !sorted.project.isEmpty())) {
    sorted.problems
        << tr("%1 was not opened: the recording of a server is opened by itself.").arg(sorted.moments);
    sorted.moments.clear();
  }
  batch.fresh = !batch.scene.isEmpty();
  if (batch.scene.isEmpty() && sorted.project.isEmpty() && !has_scene)
    for (int i = 0; i < batch.added.size(); ++i)
      if (kindOf(batch.added[i]) == FileKind::kRobot) {
        batch.scene = batch.added.takeAt(i);
        break;
      }
  return sorted;
}

}  // namespace abstand::ui
