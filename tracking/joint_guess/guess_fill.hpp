// Adds the joints that a map lacks from a guess that agrees with it.
#pragma once

#include <vector>

#include "humanmodel/joints.hpp"
#include "tracking/recording/joint_map.hpp"

namespace abstand::tracking {

/// True if a hip, knee, ankle, shoulder, elbow, wrist or the pelvis is missing.
bool isIncomplete(const JointMatch& match);

/// Adds to `match` the joints of `guess` for legs or arms that lack a joint, and the pelvis. Legs, or arms,
/// are not filled if both name one of their hips, knees, ankles, shoulders, elbows or wrists and mean
/// different joints of the file; nothing is, if left and right of the two differ. A joint of the file that is
/// used already is not added. Returns the joints that were added.
std::vector<humanmodel::Joint> fillFrom(JointMatch& match, const JointMatch& guess);

}  // namespace abstand::tracking
