// Forward kinematics against products of elementary transforms, and Jacobians against differences.
#include <gtest/gtest.h>

#include "core/robot_file/mech_file.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::mechanism {
namespace kinematics_test {

using testing::randomUnit;
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

// Rounding of a dozen products of numbers near 1.
constexpr double kExact = 1e-13;
// Central differences with a step of 1e-6: the step's square and rounding over the step.
constexpr double kStep = 1e-6;
constexpr double kDifference = 1e-8;

Transform craig(double a, double alpha, double d, double theta) {
  return Transform(Eigen::AngleAxisd(alpha, Vector3d::UnitX())) * Eigen::Translation3d(a, 0, 0) *
         Eigen::AngleAxisd(theta, Vector3d::UnitZ()) * Eigen::Translation3d(0, 0, d);
}

std::vector<double> randomJoints(int dof, std::uint64_t seed) {
  std::vector<double> q;
  for (int i = 0; i < dof; ++i)
    q.push_back(4.0 * randomUnit(seed, 100 + static_cast<std::uint64_t>(i)) - 2.0);
  return q;
}

// A tree of revolute, prismatic and fixed frames with offsets and scales, all drawn from the seed.
Mechanism randomTree(std::uint64_t seed) {
  auto draw = [&, stream = std::uint64_t{0}]() mutable { return 2.0 * randomUnit(seed, ++stream) - 1.0; };
  Mechanism m;
  for (int i = 0; i < 9; ++i) {
    MechanismFrame f;
    f.id = i + 1;
    f.parent = i == 0 ? -1 : i - 1 - (i % 4 == 3 ? 1 : 0);
    f.type = std::array{JointType::kRevolute, JointType::kPrismatic,
                        JointType::kFixed}[static_cast<std::size_t>((i + static_cast<int>(seed % 3)) % 3)];
    f.a = draw();
    f.alpha = 3.0 * draw();
    if (f.type != JointType::kPrismatic) f.d = draw();
    if (f.type != JointType::kRevolute) f.theta = 3.0 * draw();
    if (f.type != JointType::kFixed) {
      f.dof = m.dof++;
      f.offset = draw();
      f.scale = 2.0 * draw();
    }
    m.frames.push_back(f);
  }
  m.prepare();
  return m;
}

TEST(ForwardKinematics, MatchesProductOfElementaryTransforms) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Mechanism m = randomTree(seed);
    const auto q = randomJoints(m.dof, seed);
    MechanismState state;
    forward(m, q, state);
    std::vector<Transform> expected;
    for (const auto& f : m.frames) {
      const double value = f.dof < 0 ? 0.0 : f.offset + f.scale * q[static_cast<std::size_t>(f.dof)];
      const Transform X_PF = craig(f.a, f.alpha, f.d + (f.type == JointType::kPrismatic ? value : 0.0),
                                   f.theta + (f.type == JointType::kRevolute ? value : 0.0));
      expected.push_back(
          (f.parent < 0 ? Transform::Identity() : expected[static_cast<std::size_t>(f.parent)]) * X_PF);
    }
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_LT((state.X_BF[i].matrix() - expected[i].matrix()).cwiseAbs().maxCoeff(), kExact) << i;
  }
}

TEST(ForwardKinematics, ThesisListing31MatchesClosedForm) {
  const Mechanism m = robot_file::loadMechanism(testing::projectFile("data/scenes/example.mech"));
  const double q0 = 0.3, q1 = 0.12, q2 = -0.8;
  MechanismState state;
  forward(m, std::vector{q0, q1, q2}, state);
  // L1 = 240 mm out and q1 up along joint 2, then L2 = 160 mm in the upright plane that q0 turns.
  const Vector3d x_B(std::cos(q0), std::sin(q0), 0.0), z_B(0, 0, 1);
  EXPECT_TRUE(state.X_BF[1].translation().isApprox(0.24 * x_B + q1 * z_B, kExact));
  const Vector3d tip_B = 0.24 * x_B + q1 * z_B + 0.16 * (std::cos(q2) * x_B + std::sin(q2) * z_B);
  EXPECT_TRUE(state.X_BF[3].translation().isApprox(tip_B, kExact));
}

TEST(Jacobian, MatchesFiniteDifferences) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const Mechanism m = randomTree(seed);
    const auto q = randomJoints(m.dof, seed);
    MechanismState state, plus, minus;
    forward(m, q, state);
    Jacobian J;
    for (std::size_t frame = 0; frame < m.frames.size(); ++frame) {
      jacobian(m, state, static_cast<int>(frame), J);
      ASSERT_EQ(J.cols(), m.dof);
      for (int k = 0; k < m.dof; ++k) {
        auto q_plus = q, q_minus = q;
        q_plus[static_cast<std::size_t>(k)] += kStep;
        q_minus[static_cast<std::size_t>(k)] -= kStep;
        forward(m, q_plus, plus);
        forward(m, q_minus, minus);
        const Vector3d linear =
            (plus.X_BF[frame].translation() - minus.X_BF[frame].translation()) / (2 * kStep);
        const Eigen::AngleAxisd turn(plus.X_BF[frame].linear() * minus.X_BF[frame].linear().transpose());
        const Vector3d angular = turn.angle() * turn.axis() / (2 * kStep);
        EXPECT_LT((J.col(k).head<3>() - linear).norm(), kDifference) << frame << " " << k;
        EXPECT_LT((J.col(k).tail<3>() - angular).norm(), kDifference) << frame << " " << k;
      }
    }
  }
}

TEST(Kinematics, AllocatesNothingInSteadyState) {
  const Mechanism m = robot_file::loadMechanism(testing::projectFile("data/robots/lwr/lwr4.mech"));
  std::vector<double> q(7, 0.1), efforts(7, 0.0);
  MechanismState state;
  Jacobian J;
  forward(m, q, state);
  jacobian(m, state, 6, J);
  const testing::NoAlloc guard;
  for (int i = 0; i < 100; ++i) {
    q[3] += 0.01;
    forward(m, q, state);
    jacobian(m, state, 6, J);
    addJointEfforts(m, state, 6, Vector3d(0.1, 0.2, 0.3), {Vector3d(1, 2, 3), Vector3d(4, 5, 6)}, efforts);
  }
  EXPECT_EQ(guard.count(), 0);
}

TEST(KinematicsDeathTest, AbortsOnUnpreparedMechanism) {
  Mechanism m;
  m.frames.emplace_back();
  MechanismState state;
  EXPECT_DEATH(forward(m, {}, state), "prepared");
}

}  // namespace kinematics_test
}  // namespace abstand::mechanism
