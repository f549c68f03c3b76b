// Heights and distances of points to the legs of a person who sits.
#include "tracking/tracker/seat_points.hpp"

#include <algorithm>

#include "tracking/tracker/bone.hpp"

namespace abstand::tracking {
namespace {

using enum RigSegment;

// Sines: thighs within 30 degrees of level, calves within 45 degrees of upright.
constexpr double kLevelThigh = 0.5, kUprightCalf = 0.7;
constexpr double kLowestHips = 0.30;  // m; those of people who sit on the floor are at 0.1

double lean(const BodyRig& rig, const RigPlacement& X_WS, RigSegment s) {
  return (X_WS[index(s)].linear() * rig[s].along).z();
}

}  // namespace

bool sitsOnSeat(const BodyRig& rig, const RigPlacement& X_WS) {
  if (X_WS[index(kPelvis)].translation().z() < kLowestHips) return false;
  return std::abs(lean(rig, X_WS, kThighLeft)) < kLevelThigh &&
         std::abs(lean(rig, X_WS, kThighRight)) < kLevelThigh && lean(rig, X_WS, kCalfLeft) < -kUprightCalf &&
         lean(rig, X_WS, kCalfRight) < -kUprightCalf;
}

std::size_t moveSeatPoints(const BodyRig& rig, const RigPlacement& X_WS, SeenPoints& points,
                           SeenPoints& seat) {
  using enum humanmodel::Joint;
  const auto bone = [&](humanmodel::Joint from, humanmodel::Joint to) {
    return Bone{jointPosition(rig, X_WS, from), jointPosition(rig, X_WS, to)};
  };
  const std::array<Bone, 4> bones{bone(kKneeLeft, kAnkleLeft), bone(kKneeRight, kAnkleRight),
                                  bone(kAnkleLeft, kToeLeft), bone(kAnkleRight, kToeRight)};
  const double level = std::min(bones[0].from.z(), bones[1].from.z()) - kUnderThighs;
  const Vector3d hips = 0.5 * (jointPosition(rig, X_WS, kHipLeft) + jointPosition(rig, X_WS, kHipRight));
  Vector3d ahead = 0.5 * (bones[0].from + bones[1].from) - hips;
  ahead.z() = 0.0;
  const double knees = ahead.norm();
  if (knees < 1e-6) return 0;
  ahead /= knees;
  const Vector3d aside{-ahead.y(), ahead.x(), 0.0};
  const std::size_t before = points.count;
  points.count = 0;
  for (std::size_t i = 0; i < before; ++i) {
    const Vector3d p = points.point(i);
    const bool is_below =
        p.z() < level && ahead.dot(p - hips) < knees && std::abs(aside.dot(p - hips)) < kHalfSeat;
    const bool is_seat = is_below && std::all_of(bones.begin(), bones.end(), [&](const Bone& b) {
                           return b.distanceTo(p) > kBesideCalf;
                         });
    if (is_seat)
      seat.append(points, i);
    else
      points.append(points, i);
  }
  return before - points.count;
}

}  // namespace abstand::tracking
