// The frames of a session that a user asks for.
#pragma once

#include <optional>
#include <vector>

namespace abstand::session {

/// Those of `times` (s) from `start` to `end`, both included to a nanosecond, so that an end like 0.3 takes
/// the frame at 0.30000000000000004. Throws UsageError when none is left.
std::vector<double> timesBetween(std::vector<double> times, std::optional<double> start,
                                 std::optional<double> end);

}  // namespace abstand::session
