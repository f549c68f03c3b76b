// Skeletons in motion for tests of the poser.
#pragma once

#include <cmath>

#include "humanmodel/poser.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::testing {

inline humanmodel::HumanModel person(
    double height = 1.75, humanmodel::HumanPreset preset = humanmodel::HumanPreset::kAnthropometric) {
  humanmodel::HumanOptions options;
  options.height = height;
  options.preset = preset;
  return humanmodel::makeHuman(options);
}

inline void drop(humanmodel::SkeletonFrame& frame, humanmodel::Joint joint) {
  frame.set(joint, Vector3d::Constant(kNaN), humanmodel::JointState::kMissing);
}

/// Turns the joints `moved` about `centre` by `angle` about `axis`.
inline void bend(humanmodel::SkeletonFrame& frame, humanmodel::Joint centre, const Vector3d& axis,
                 double angle, std::initializer_list<humanmodel::Joint> moved) {
  const Matrix3d R = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  for (const humanmodel::Joint j : moved) frame.set(j, frame[centre] + R * (frame[j] - frame[centre]));
}

/// A person of another height who walks: hips sway, all elbows and knees bend, the trunk leans and twists.
inline humanmodel::SkeletonFrame walking(double t, double height = 1.62) {
  using enum humanmodel::Joint;
  humanmodel::SkeletonFrame f = person(height).rest;
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const double s = std::sin(3.0 * t), c = std::cos(3.0 * t);
  bend(f, kElbowLeft, -y, 0.6 + 0.4 * s, {kWristLeft, kHandLeft});
  bend(f, kElbowRight, -y, 0.6 - 0.4 * s, {kWristRight, kHandRight});
  bend(f, kWristLeft, x, 0.3 * c, {kHandLeft});
  bend(f, kShoulderLeft, -y + 0.3 * x, 0.5 * s, {kElbowLeft, kWristLeft, kHandLeft});
  bend(f, kShoulderRight, y - 0.4 * x, 0.5 * s, {kElbowRight, kWristRight, kHandRight});
  bend(f, kKneeLeft, y, 0.5 + 0.3 * c, {kAnkleLeft, kToeLeft});
  bend(f, kKneeRight, y, 0.5 - 0.3 * c, {kAnkleRight, kToeRight});
  bend(f, kHipLeft, -y, 0.4 * s, {kKneeLeft, kAnkleLeft, kToeLeft});
  bend(f, kHipRight, y, 0.4 * s, {kKneeRight, kAnkleRight, kToeRight});
  bend(f, kPelvis, y + 0.2 * z, 0.2 + 0.1 * c,
       {kSpine, kThorax, kNeck, kHead, kHeadTop, kShoulderLeft, kElbowLeft, kWristLeft, kHandLeft,
        kShoulderRight, kElbowRight, kWristRight, kHandRight});
  bend(f, kNeck, z + y, 0.2 * s, {kHead, kHeadTop});
  f.t = t;
  return f;
}

/// Largest angle (rad) between the rotations of the same part.
inline double largestTurn(const humanmodel::HumanPose& a, const humanmodel::HumanPose& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i)
    largest = std::max(
        largest, Eigen::AngleAxisd(Matrix3d(a.X_WP[i].linear().transpose() * b.X_WP[i].linear())).angle());
  return largest;
}

inline double largestShift(const humanmodel::HumanPose& a, const humanmodel::HumanPose& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i)
    largest = std::max(largest, (a.X_WP[i].translation() - b.X_WP[i].translation()).norm());
  return largest;
}

}  // namespace abstand::testing
