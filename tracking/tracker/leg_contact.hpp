// Legs that a pose puts into each other.
#pragma once

#include <array>

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// m, between the axes of two thighs or two calves: they do not come nearer, as each has a radius of about
/// 0.055 m, part of which is soft. Ellipsoids of both would hardly overlap near the knees, where they end.
inline constexpr double kLegsApart = 0.09;

/// The nearest points of the axes of two segments that are too near.
struct LegContact {
  RigSegment left, right;
  Vector3d p_left{Vector3d::Zero()}, p_right{Vector3d::Zero()};  ///< m, world
  Vector3d n{Vector3d::Zero()};  ///< unit, world, from the right one to the left one; zero without contact
  double depth{0.0};             ///< m, by which they are nearer than kLegsApart; 0: no contact
};

/// Of the thighs, and of the calves.
std::array<LegContact, 2> legContacts(const RigPlacement& X_WS);

}  // namespace abstand::tracking
