// People in postures that are written down, for simulated depth recordings.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::testing {

/// Stature (m) of a posed person.
inline constexpr double kPosedStature = 1.75;

/// A posture. Lengths in m, angles in rad; world: the floor is z = 0, the person faces +x. The default stands
/// over the origin with hanging arms. Elbows and knees follow from the lengths of the bones.
struct Posture {
  double t{0.0};                                ///< s, at which it is reached
  Vector3d hips{0.0, 0.0, 0.922};               ///< middle of the hip joints
  double loins{0.0}, back{0.0}, head{0.0};      ///< of lower and upper trunk and of the head: leans forward
  double reach{0.04}, aside{0.27}, low{0.88};   ///< of both wrists: x, distance from the middle plane, z
  double foot{0.0}, apart{0.10}, ankle{0.068};  ///< of both ankles: likewise
  double toes{-0.25};                           ///< slope of the feet; below -pi/2 the toes point backwards
  Vector3d elbows{-0.6, 0.7, -0.5};             ///< direction into which the left one bends; right: mirrored
};

/// Joints at 30 Hz from the first to the last posture, between which every number goes smoothly. Hips and
/// wrists move by some centimetres all the time, as no person stands still. Lengths are shares of the stature
/// (Drillis and Contini 1966, in Winter 2009), not those of the model that is fitted.
std::vector<humanmodel::SkeletonFrame> posedFrames(std::span<const Posture> postures);

}  // namespace abstand::testing
