// Several files that are opened together.
#pragma once

#include <QMetaType>
#include <QStringList>

namespace abstand::ui {

/// What is to be shown together. Paths as the user gave them.
struct FileBatch {
  QString scene;             ///< a scene or robot file; empty: what is shown already, or none
  QStringList added;         ///< robots and meshes that are added to it
  QString recording;         ///< empty: none of its own
  bool fresh{false};         ///< replaces what is shown instead of being added to it
  QStringList recordings{};  ///< `recording` and others to choose from; empty: no choice

  bool empty() const { return scene.isEmpty() && added.isEmpty() && recording.isEmpty(); }
};

/// The files of a batch by their kinds, and a sentence, with the name of the file, for each that is left out.
struct SortedFiles {
  QString project, moments;  ///< each is opened by itself, before or instead of the batch
  FileBatch batch;
  QString margins;  ///< a set that is for what is shown afterwards
  QStringList problems;

  bool empty() const { return project.isEmpty() && moments.isEmpty() && batch.empty() && margins.isEmpty(); }
};

/// One project, one scene and one set of margins can be shown at a time; the first of each counts. Of several
/// recordings the first is shown, and the others can be chosen. The first robot is the scene where the files
/// have none and `has_scene` is false; other robots, and meshes, are added.
/// @param has_scene  a scene is shown that the files may be added to
SortedFiles sortedFiles(const QStringList& files, bool has_scene);

/// Why a file cannot be opened, with its name; empty: its name speaks for it.
QString whyNotOpened(const QString& file);

}  // namespace abstand::ui

Q_DECLARE_METATYPE(abstand::ui::FileBatch)
