// T-poses that converters put before a movement.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// A T-pose at the start that no person held.
struct LeadingTPose {
  std::size_t frames{0};  ///< in the T-pose
  std::size_t steps{0};   ///< frames until an arm has left it
  double seconds{0.0};    ///< the same as a time
  double turned{0.0};     ///< rad, by which this arm turns meanwhile
};

/// The T-pose at the start, if it is left faster than a person can: an arm turns by more than 20 degrees
/// within 0.17 s (or one frame) at 6.5 rad/s in the mean, 15 rad/s if it may be in motion in the first frame
/// (the pose lasts one frame and is inexact). A T-pose has both arms straight and level (within 25 degrees,
/// exact: 8) along the line of the shoulders, and both legs within 25 degrees of vertical, or within 45
/// degrees with knees straight within 3 degrees; it lasts as long as the arms keep their direction within 5
/// degrees, and within 1 degree and 1 rad/s. z up. nullopt for a T-pose that lasts to the end or is left at
/// human speed, fewer than two frames, other poses, and missing joints.
std::optional<LeadingTPose> leadingTPose(std::span<const humanmodel::SkeletonFrame> frames);

/// A sentence on it, with frames that count from 1.
std::string warningOf(const LeadingTPose& pose);

}  // namespace abstand::tracking
