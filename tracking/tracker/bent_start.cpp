// Extents, bent trunks, feet on the floor.
#include "tracking/tracker/bent_start.hpp"

#include <algorithm>
#include <cmath>

#include "tracking/tracker/leg_posture.hpp"
#include "tracking/tracker/limb_search.hpp"
#include "tracking/tracker/longest_extent.hpp"

namespace abstand::tracking {
namespace {

/// Bent to the floor; squatting.
struct Bend {
  double pelvis, chest, head;  ///< rad, ahead, each relative to the one before
  double hips;                 ///< m, below the highest point of the back
};
constexpr std::array<Bend, 2> kBends{{{1.1, 0.5, 0.0, 0.12}, {0.8, 0.3, -0.5, 0.32}}};
constexpr double kBackBehindHips = 0.14;  // m, of a bent trunk's skin
constexpr double kAnklesAhead = 0.08;     // m
constexpr double kHangs = 0.95;           // share of the length of an arm

/// m, along `forward` (unit): the rearmost point, at most 0.
double rearOf(const SeenPoints& points, const Vector3d& middle, const Vector3d& forward) {
  double rear = 0.0;
  for (std::size_t i = 0; i < points.count; ++i) rear = std::min(rear, forward.dot(points.point(i) - middle));
  return rear;
}

RigPose bentStart(const BodyRig& rig, const SeenPoints& points, const Vector3d& middle, double top,
                  double facing, const Bend& bend) {
  const Eigen::Matrix3d yaw = Eigen::AngleAxisd(facing, Vector3d::UnitZ()).toRotationMatrix();
  RigPose pose;
  pose.X_WP.linear() = yaw * Eigen::AngleAxisd(bend.pelvis, Vector3d::UnitY());
  pose.X_WP.translation() = middle + (rearOf(points, middle, yaw.col(0)) + kBackBehindHips) * yaw.col(0);
  pose.X_WP.translation().z() = std::max(top - bend.hips, kAnkleHeight);
  pose.R_PS[index(RigSegment::kChest)] = Eigen::AngleAxisd(bend.chest, Vector3d::UnitY());
  pose.R_PS[index(RigSegment::kHead)] = Eigen::AngleAxisd(bend.head, Vector3d::UnitY());
  RigPlacement X_WS;
  place(rig, pose, X_WS);
  for (const Limb& limb : kLimbs) {
    const Vector3d joint = X_WS[index(limb.upper)].translation();
    Vector3d goal = joint + kAnklesAhead * yaw.col(0);
    goal.z() = kAnkleHeight;
    if (limb.isArm()) goal = joint - kHangs * lengthOf(rig, limb) * Vector3d::UnitZ();
    reachFor(rig, limb, X_WS, goal, 0.0, pose);
  }
  return pose;
}

}  // namespace

void bentStarts(const BodyRig& rig, const SeenPoints& points, const Vector3d& middle, double top,
                double facing, std::array<RigPose, kBentStarts>& starts) {
  const double angle = longestExtent(points, middle);
  std::size_t k = 0;
  for (const double end : {0.0, kPi})
    for (const Bend& bend : kBends) starts[k++] = bentStart(rig, points, middle, top, angle + end, bend);
  starts[k] = bentStart(rig, points, middle, top, facing, kBends[1]);
}

}  // namespace abstand::tracking
