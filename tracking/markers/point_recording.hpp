// Converts the points of a file to a recording of a person.
#pragma once

#include <string>

#include "tracking/recording/point_reader.hpp"
#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

/// Reads all frames, maps points to joints, and converts. `file` is its name in messages. Names that no joint
/// map knows are a ParseError; for a file of markers they are a warning, and the recording moves nothing.
/// Throws ParseError for file and maps, UsageError for the options.
Recording readPoints(PointReader& reader, const std::string& file, const RecordingOptions& options);

}  // namespace abstand::tracking
