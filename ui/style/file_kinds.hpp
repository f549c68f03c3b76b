// What a dropped or chosen file is, by its name; what is in it the readers find out, but of margins.
#pragma once

#include <QString>

namespace abstand::ui {

/// Moments are the recording of a server. A file of margins is told from a scene by its first key.
enum class FileKind { kProject, kScene, kRobot, kMesh, kRecording, kMargins, kMoments, kUnknown };

/// A folder counts as a (depth) recording.
FileKind kindOf(const QString& path);
/// Filters for the file dialogues, translated.
QString openFilter();
QString projectFilter();
QString recordingFilter();
/// ".bvh, .c3d ..."
QString recordingEndings();
/// ".stl, .obj ..."
QString meshEndings();

}  // namespace abstand::ui
