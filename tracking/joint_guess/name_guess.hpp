// A joint map from the names of a skeleton, read word by word.
#pragma once

#include <span>
#include <string>

#include "tracking/recording/joint_map.hpp"

namespace abstand::tracking {

/// Number of joints of a match among hips, knees, ankles, shoulders, elbows and wrists: 0 to 12.
int limbJoints(const JointMatch& match);
inline constexpr int kLimbJointCount = 12;

/// Joints by readJointName(). Words with several meanings are decided by the other names of their side:
/// a shoulder is the collar bone if there is an upper arm too, a leg is the shin if there is a thigh, a hand
/// is behind the wrist and a foot behind the ankle if there are both. Of several names for one joint, that
/// with the fewest other words wins, then the lowest number, then the first. `is_tree`: the names are bones
/// of a hierarchy, so a head is its base; otherwise points, so it is the middle of the head.
JointMatch guessByNames(std::span<const std::string> names, bool is_tree);

}  // namespace abstand::tracking
