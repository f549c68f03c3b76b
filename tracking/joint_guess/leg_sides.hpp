// Which leg of a reading is the left one.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "tracking/joint_guess/shape_reading.hpp"

namespace abstand::tracking {

struct LegSides {
  std::optional<bool> a_is_left;  ///< branch a of the legs; nullopt: not determined
  std::string reason;             ///< for the result, the rest of a sentence
};

/// From the names where all joints of the legs say a side, otherwise from where the toes point in the poses,
/// or the bent knees. Knees count only if there are arms: without them, elbows could be taken for knees, and
/// they bend the other way.
LegSides sidesOfLegs(const ShapeReading& r, std::span<const std::string> names,
                     std::span<const Places> poses);

}  // namespace abstand::tracking
