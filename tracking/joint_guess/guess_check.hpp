// Leaves out limbs of a guess whose lengths no person has.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "humanmodel/joints.hpp"
#include "tracking/recording/joint_map.hpp"

namespace abstand::tracking {

/// Removes from `match` both legs, or both arms, if left and right differ by more than 15 %, or the upper
/// bone is not 0.6 to 1.8 (arms: 0.6 to 2.2) of the lower one; all four if a leg is not 0.9 to 2.5 of an arm.
/// `frames`: the joints of the match, in any units. Returns a sentence on each removal.
std::vector<std::string> removeImplausible(JointMatch& match,
                                           std::span<const humanmodel::SkeletonFrame> frames);

/// Removes the pelvis from `match` if it is farther than 0.6 of a thigh from the middle of the hips: a root
/// on the floor, or an origin. It stays if hips or thighs are not known.
void removeDistantPelvis(JointMatch& match, std::span<const humanmodel::SkeletonFrame> frames);

}  // namespace abstand::tracking
