// Opens recordings of any known format.
#pragma once

#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

/// Valid names of RecordingOptions::format besides "auto".
std::vector<std::string> recordingFormats();

/// Reads a recording of any known format, detected by content; docs/recordings.md lists them. All frames are
/// kept (including a T-pose at the start). Throws ParseError for the file and UsageError for the options.
Recording openRecording(const std::filesystem::path& file, const RecordingOptions& options = {});

}  // namespace abstand::tracking
