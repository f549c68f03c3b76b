// Postures in which people of another stature are as high as somebody who stands upright.
#pragma once

#include <vector>

#include "tracking/body/body_rig.hpp"
#include "tracking/tracker/stature.hpp"

namespace abstand::tracking {

/// A posture of a person who is seen from head to feet, and the stature in it.
struct OtherPosture {
  enum class Kind : std::uint8_t { kSeated, kKneeling, kLowered, kRaisedArms, kChild } kind;
  Stature stature;
};

/// Of a person with Stature::seen. May allocate.
std::vector<OtherPosture> otherPostures(const Stature& stature);

/// Whether a body that was fitted for a posture agrees with it: hands are raised, a child stands upright. The
/// others are those of any body.
bool isIn(OtherPosture::Kind kind, const humanmodel::SkeletonFrame& frame, const BodyRig& rig);

/// m, height of the lowest ankle or toe above the floor z = 0.
double lowestFoot(const humanmodel::SkeletonFrame& frame);

/// Whether nearly the whole stature is between the lowest and the highest joint, and no hand is at the head.
bool standsUpright(const humanmodel::SkeletonFrame& frame, const BodyRig& rig);

/// Whether a hand may be the highest of the person.
bool raisesHands(const humanmodel::SkeletonFrame& frame);

}  // namespace abstand::tracking
