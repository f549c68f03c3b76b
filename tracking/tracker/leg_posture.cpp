// Heights of knees and ankles, and a leg parallel to the other one.
#include "tracking/tracker/leg_posture.hpp"

#include <algorithm>
#include <cmath>

#include "tracking/tracker/limb_search.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kLeftLeg = 2, kRightLeg = 3;  // of kLimbs
constexpr double kKneeOnFloor = 0.20;  // m; the knees of people who sit on a chair are at 0.4 and more
constexpr double kOffFloor = 0.25;     // m, of an ankle, on no step
constexpr double kInTheAir = 0.50;     // m, likewise; of people on high chairs up to 0.4
constexpr double kHeadAbove = 0.20;    // m, of somebody who does not lie
constexpr double kBentKnee = 1.0;      // rad
constexpr double kBelowHip = 0.2;      // m
constexpr double kRaised = 0.25;  // m, of an ankle above the other one; feet of people who walk stay lower

double ankleHeight(const RigPlacement& X_WS, std::size_t leg) {
  return X_WS[index(kLimbs[leg].end)].translation().z();
}

double lowerAnkle(const RigPlacement& X_WS) {
  return std::min(ankleHeight(X_WS, kLeftLeg), ankleHeight(X_WS, kRightLeg));
}

/// m, world: an ankle on the floor below the hip of its leg.
Vector3d belowHip(const RigPlacement& X_WS, const Limb& leg) {
  Vector3d below = X_WS[index(leg.upper)].translation();
  below.z() = kAnkleHeight;
  return below;
}

/// m, of their joints.
double headAbovePelvis(const RigPlacement& X_WS) {
  return X_WS[index(RigSegment::kHead)].translation().z() -
         X_WS[index(RigSegment::kPelvis)].translation().z();
}

}  // namespace

bool kneels(const RigPlacement& X_WS) {
  return std::min(X_WS[index(RigSegment::kCalfLeft)].translation().z(),
                  X_WS[index(RigSegment::kCalfRight)].translation().z()) < kKneeOnFloor;
}

bool isHeadlong(const RigPlacement& X_WS) {
  return headAbovePelvis(X_WS) < 0.0 && lowerAnkle(X_WS) > kOffFloor;
}

bool floats(const RigPlacement& X_WS) {
  return headAbovePelvis(X_WS) > kHeadAbove && lowerAnkle(X_WS) > kInTheAir;
}

RigPose standingLegs(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS) {
  RigPose standing = pose;
  for (const Limb& leg : {kLimbs[kLeftLeg], kLimbs[kRightLeg]})
    reachFor(rig, leg, X_WS, belowHip(X_WS, leg), 0.0, standing);
  return standing;
}

std::optional<std::size_t> raisedLeg(const RigPlacement& X_WS) {
  const double left = ankleHeight(X_WS, kLeftLeg), right = ankleHeight(X_WS, kRightLeg);
  if (left > right + kRaised) return kLeftLeg;
  if (right > left + kRaised) return kRightLeg;
  return std::nullopt;
}

std::optional<RigPose> plantedLeg(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS,
                                  std::size_t leg) {
  const Limb& limb = kLimbs[leg];
  if (std::abs(pose.angle[index(limb.lower)][0]) < kBentKnee) return std::nullopt;
  const Vector3d below = belowHip(X_WS, limb);
  if ((X_WS[index(limb.end)].translation() - below).norm() < kBelowHip) return std::nullopt;
  RigPose planted = pose;
  reachFor(rig, limb, X_WS, below, 0.0, planted);
  return planted;
}

RigPose loweredLeg(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS, std::size_t leg) {
  const Limb &raised = kLimbs[leg], &other = kLimbs[leg == kLeftLeg ? kRightLeg : kLeftLeg];
  const Vector3d beside = X_WS[index(raised.upper)].translation() - X_WS[index(other.upper)].translation();
  RigPose lowered = pose;
  reachFor(rig, raised, X_WS, X_WS[index(other.end)].translation() + beside, 0.0, lowered);
  return lowered;
}

}  // namespace abstand::tracking
