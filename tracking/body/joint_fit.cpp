// Gauss-Newton fit to joints.
#include "tracking/body/joint_fit.hpp"

#include <cmath>

namespace abstand::tracking {
namespace {

constexpr double kInferredWeight = 0.25;
constexpr double kLimitWeight = 1.0;  // 1/rad^2; a radian beyond costs as much as a metre of distance
// Unobservable dof, as the twist of a straight arm, keep their values.
constexpr double kDamping = 1e-5;
constexpr double kMaxTurn = 0.6;  // rad, m, for each step
constexpr double kAtRest = 1e-7;  // rad, m, convergence

}  // namespace

JointFit fitJoints(const BodyRig& rig, const humanmodel::SkeletonFrame& frame, const RigPose& start,
                   int max_steps) {
  BodySolver solver(rig);
  JointFit fit{start, kInfinity, 0};
  const auto misfit = [&](const RigPlacement& X_WS) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      if (frame.state[j] == humanmodel::JointState::kMissing) continue;
      sum += (jointPosition(rig, X_WS, static_cast<humanmodel::Joint>(j)) - frame.p[j]).squaredNorm();
      ++count;
    }
    return count > 0 ? std::sqrt(sum / count) : kInfinity;
  };
  for (; fit.steps < max_steps; ++fit.steps) {
    solver.begin(fit.pose);
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      if (frame.state[j] == humanmodel::JointState::kMissing) continue;
      const RigSegment s = rig.carrier[j];
      solver.addPoint(s, solver.placement()[index(s)] * rig.p_joint[j], frame.p[j],
                      frame.state[j] == humanmodel::JointState::kTracked ? 1.0 : kInferredWeight);
    }
    solver.addLimits(kLimitWeight);
    const double moved = solver.step(kDamping, kMaxTurn);
    fit.pose = solver.pose();
    if (moved < kAtRest) break;
  }
  RigPlacement X_WS;
  place(rig, fit.pose, X_WS);
  fit.rms = misfit(X_WS);
  return fit;
}

RigPose startAt(const humanmodel::SkeletonFrame& frame) {
  RigPose pose;
  Vector3d mean = Vector3d::Zero();
  int count = 0;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    if (frame.state[j] == humanmodel::JointState::kMissing) continue;
    mean += frame.p[j];
    ++count;
  }
  if (count > 0) pose.X_WP.translation() = mean / count;
  if (frame.has(humanmodel::Joint::kPelvis)) pose.X_WP.translation() = frame[humanmodel::Joint::kPelvis];
  Vector3d left = Vector3d::Zero();
  const auto line = [&](humanmodel::Joint l, humanmodel::Joint r) {
    if (frame.has(l) && frame.has(r)) left += frame[l] - frame[r];
  };
  line(humanmodel::Joint::kHipLeft, humanmodel::Joint::kHipRight);
  line(humanmodel::Joint::kShoulderLeft, humanmodel::Joint::kShoulderRight);
  if (left.head<2>().norm() > 1e-6)
    pose.X_WP.linear() =
        Eigen::AngleAxisd(std::atan2(-left.x(), left.y()), Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

}  // namespace abstand::tracking
