// Fills short gaps of joints.
#pragma once

#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

struct GapFill {
  std::size_t filled{0};  ///< number of joint positions filled
  std::size_t left{0};    ///< number not filled: longer gaps, and those at both ends of the recording
};

/// Fills gaps of at most `longest` seconds by cubic Hermite interpolation with the positions and velocities
/// on both sides; then moves filled joints of an arm or a leg along their bone to its median length (trunk
/// outwards). Filled joints are kInferred. Also applies to joints that never occur and to derived ones.
GapFill fillGaps(std::vector<humanmodel::SkeletonFrame>& frames, double longest);

}  // namespace abstand::tracking
