// What a dropped or chosen file is, by its name; what is in it the readers find out.
#pragma once

#include <QString>

namespace abstand::ui {

enum class FileKind { kScene, kRecording, kUnknown };

/// A folder counts as a (depth) recording.
FileKind kindOf(const QString& path);
/// Filters for the file dialogues, translated.
QString sceneFilter();
QString recordingFilter();

}  // namespace abstand::ui
