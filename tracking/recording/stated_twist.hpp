// Twist of body parts from the orientations that a file states.
#pragma once

#include <string>
#include <vector>

#include "tracking/recording/part_turns.hpp"

namespace abstand::tracking {

struct StatedTwist {
  std::vector<std::string> parts;  ///< names of the body parts whose twist was set
  std::vector<std::string> notes;  ///< why not that of others
};

/// Sets SkeletonFrame::lateral of `frames` (world, joints derived): the y axis that the poser gives a part in
/// the rest pose, turned as the file states. `R_WF`: from the axes of the file to the world, with a
/// reflection if those are left-handed. `turns.rest` must have its joints derived.
///
/// If the hinge of a bent elbow deviates from them by more than 60 degrees in the mean, the arm has another
/// twist in the rest pose (palms ahead or up instead of down), and is turned by the mean deviation.
///
/// Not used are the orientations of a part whose rest pose does not show the twist (a person who does not
/// stand upright there, with straight arms and the toes ahead), and those that contradict the positions: an
/// elbow that does not turn with the arm (40 degrees in the median), a foot or a head that deviates by more
/// than 60 degrees in the mean from the calf, or from the trunk.
StatedTwist stateTwist(const StatedTurns& turns, const Matrix3d& R_WF,
                       std::vector<humanmodel::SkeletonFrame>& frames);

}  // namespace abstand::tracking
