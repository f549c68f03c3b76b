// Axes of joints against forward kinematics.
#include "core/mechanism/joint_axis.hpp"

#include <gtest/gtest.h>

#include "tests/support/robots.hpp"

namespace abstand::mechanism {
namespace joint_axis_test {

constexpr double kStep = 0.7;         // rad, m
constexpr double kTolerance = 1e-12;  // rounding of a chain of twelve frames of about 1 m

/// The motion of everything behind the joint when its value increases by `value`.
Transform motionOf(const JointAxis& axis, double value) {
  if (axis.prismatic) return Transform(Eigen::Translation3d(value * axis.direction));
  return Transform(Eigen::Translation3d(axis.p) * Eigen::AngleAxisd(value, axis.direction) *
                   Eigen::Translation3d(-axis.p));
}

TEST(JointAxis, IncreasingJointValueMovesFrameAboutOrAlongAxis) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Mechanism robot = testing::randomRobot(seed, 12, false);
    std::vector<double> q = testing::randomValues(robot.dof, seed, 1, 2.0);
    MechanismState before, after;
    forward(robot, q, before);
    std::vector<JointAxis> axes(static_cast<std::size_t>(robot.dof));
    jointAxes(robot, before, axes);
    for (std::size_t i = 0; i < robot.frames.size(); ++i) {
      const MechanismFrame& f = robot.frames[i];
      if (f.dof < 0) continue;
      const auto dof = static_cast<std::size_t>(f.dof);
      EXPECT_NEAR(axes[dof].direction.norm(), 1.0, kTolerance);
      q[dof] += kStep;
      forward(robot, q, after);
      q[dof] -= kStep;
      const Transform expected = motionOf(axes[dof], std::abs(f.scale) * kStep) * before.X_BF[i];
      EXPECT_LT((after.X_BF[i].matrix() - expected.matrix()).norm(), kTolerance) << seed << ", frame " << i;
    }
  }
}

TEST(JointAxis, MimicJointsDoNotReplaceTheirLeader) {
  const Mechanism robot = testing::humanoid();
  MechanismState state;
  forward(robot, std::vector<double>(static_cast<std::size_t>(robot.dof), 0.2), state);
  std::vector<JointAxis> axes(static_cast<std::size_t>(robot.dof));
  jointAxes(robot, state, axes);
  for (std::size_t i = 0; i < robot.frames.size(); ++i) {
    const MechanismFrame& f = robot.frames[i];
    if (f.dof < 0 || f.mimic) continue;
    EXPECT_EQ(axes[static_cast<std::size_t>(f.dof)].p, state.X_BF[i].translation()) << i;
  }
}

}  // namespace joint_axis_test
}  // namespace abstand::mechanism
