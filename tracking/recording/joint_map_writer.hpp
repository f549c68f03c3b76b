// Writes the joints that were used of a recording as a joint map.
#pragma once

#include <filesystem>
#include <string>

#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

/// The text of a map that parseJointMap() reads and that finds the same joints in the same file. Throws
/// UsageError if markers were solved, and for names that a map cannot tell apart. If no part moves: a map to
/// fill in, with the joints that were found, the other canonical joints and the names of the file as
/// comments.
std::string jointMapText(const RecordingReport& report);

}  // namespace abstand::tracking
