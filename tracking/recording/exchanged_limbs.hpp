// Left and right exchanged in a part of the body only.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// Where the shoulders are the other way round than the hips.
struct OpposedShoulders {
  std::size_t frames{0}, of{0};  ///< that show it, of those with both shoulders and both hips
};

/// If the line of the shoulders is turned by more than 120 degrees from that of the hips, about the trunk, in
/// more than half of sampled frames: nobody can turn so far. Names of both arms, or of both legs, are
/// exchanged. Otherwise nullopt.
std::optional<OpposedShoulders> opposedShoulders(std::span<const humanmodel::SkeletonFrame> frames);

/// A sentence on each pair of limb bones whose ends are exchanged, such as the names of both calves: the
/// distance from the inner joint to the outer one of its own side varies, and that to the outer one of the
/// other side is shorter in the median and does not (by less than a quarter). As lengths of bones stay the
/// same, crossed legs are not named. One side suffices for knees and elbows that are on each other's side by
/// more than 0.6 of the distance of hips or shoulders in 95 % of the frames. Variation is the range from 5 %
/// to 95 % of sampled frames, of measured joints; less than 0.0005 of the length shows nothing. Empty: none
/// is exchanged, or the limbs hardly move.
std::vector<std::string> exchangedLimbs(std::span<const humanmodel::SkeletonFrame> frames);

}  // namespace abstand::tracking
