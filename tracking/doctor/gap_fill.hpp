// Fills short gaps of joints.
#pragma once

#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

struct GapFill {
  std::size_t filled{0};  ///< joints of frames that have a place now
  std::size_t left{0};    ///< that have none: longer gaps, and those at both ends of the recording
};

/// Fills gaps of at most `longest` seconds with a cubic Hermite curve through the joint's places and
/// velocities on both sides, then moves what was filled in an arm or a leg along its bone to the median
/// length that the bone has elsewhere (trunk outwards). What is filled is kInferred. Joints that are never
/// there, and derived ones, are treated alike.
GapFill fillGaps(std::vector<humanmodel::SkeletonFrame>& frames, double longest);

}  // namespace abstand::tracking
