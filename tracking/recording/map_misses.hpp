// Entries of a joint map that a file does not have.
#pragma once

#include <span>
#include <string>

#include "tracking/recording/joint_map.hpp"

namespace abstand::tracking {

/// One sentence that names the joints of `map` without a match in the file, with the names that they have in
/// the map and the nearest ones of the file; empty if all are matched. `match` is that of the map.
std::string missesOf(const JointMap& map, const JointMatch& match, std::span<const std::string> names);

}  // namespace abstand::tracking
