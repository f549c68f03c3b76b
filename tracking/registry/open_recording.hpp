// Opens a recording of any known format.
#pragma once

#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

/// The names that RecordingOptions::format may have beside "auto".
std::vector<std::string> recordingFormats();

/// Reads a recording of any known format, found by its content; docs/recordings.md lists them. Frames stay as
/// they stand in the file (a T-pose at the start stays). Throws ParseError for the file and UsageError for
/// the options.
Recording openRecording(const std::filesystem::path& file, const RecordingOptions& options = {});

}  // namespace abstand::tracking
