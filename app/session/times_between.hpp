// Selects the frames of a session in a time range.
#pragma once

#include <optional>
#include <vector>

namespace abstand::session {

/// Those of `times` (s) from `start` to `end`, inclusive with a tolerance of one nanosecond, so that an end
/// of 0.3 includes the frame at 0.30000000000000004. Throws UsageError if none is left.
std::vector<double> timesBetween(std::vector<double> times, std::optional<double> start,
                                 std::optional<double> end);

}  // namespace abstand::session
