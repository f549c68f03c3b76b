// Joint efforts of a wrench: closed forms, J^T w, and the balance of power.
#include <gtest/gtest.h>

#include "core/robot_file/mech_file.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::mechanism {
namespace efforts_test {

using testing::randomUnit;
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

// Rounding of sums of a few products of numbers near 10.
constexpr double kExact = 1e-12;
// Work over a step of 1e-6: the step's square and rounding over the step.
constexpr double kStep = 1e-6;
constexpr double kPower = 1e-6;

Vector3d randomVector(std::uint64_t seed, std::uint64_t stream, double size) {
  return size * Vector3d(2 * randomUnit(seed, stream) - 1, 2 * randomUnit(seed, stream + 1) - 1,
                         2 * randomUnit(seed, stream + 2) - 1);
}

struct Bent {
  Mechanism mechanism;
  std::vector<double> q;
  MechanismState state;
  explicit Bent(const char* file, std::uint64_t seed)
      : mechanism(robot_file::loadMechanism(testing::projectFile(file))) {
    for (int i = 0; i < mechanism.dof; ++i)
      q.push_back(4 * randomUnit(seed, 50 + static_cast<std::uint64_t>(i)) - 2);
    forward(mechanism, q, state);
  }
};

TEST(JointEfforts, LeverForceMatchesForceTimesLever) {
  // Three links of 1.1 m stretched out along x, pushed along y at the third joint.
  const Mechanism m = robot_file::loadMechanism(testing::projectFile("data/scenes/chain.mech"));
  MechanismState state;
  forward(m, std::vector(3, 0.0), state);
  std::vector<double> efforts(3, 0.0);
  addJointEfforts(m, state, 2, Vector3d(2.2, 0, 0), {Vector3d(0, 10, 0), Vector3d::Zero()}, efforts);
  EXPECT_NEAR(efforts[0], 22.0, kExact);
  EXPECT_NEAR(efforts[1], 11.0, kExact);
  EXPECT_NEAR(efforts[2], 0.0, kExact);
  // It adds, and the outer joints do not feel what acts on an inner link.
  addJointEfforts(m, state, 0, Vector3d(0.5, 0, 0), {Vector3d(0, 4, 0), Vector3d(0, 0, 1)}, efforts);
  EXPECT_NEAR(efforts[0], 25.0, kExact);
  EXPECT_NEAR(efforts[1], 11.0, kExact);
}

TEST(JointEfforts, PrismaticEffortIsForceAlongAxis) {
  const Mechanism m = robot_file::loadMechanism(testing::projectFile("data/scenes/example.mech"));
  MechanismState state;
  forward(m, std::vector(3, 0.0), state);
  std::vector<double> efforts(3, 0.0);
  addJointEfforts(m, state, m.indexOf(4), Vector3d(7, 8, 9), {Vector3d(1, 2, -5), Vector3d(3, 4, 5)},
                  efforts);
  EXPECT_NEAR(efforts[1], -5.0, kExact);
}

TEST(JointEfforts, MatchTransposedJacobianTimesWrench) {
  for (const char* file : {"data/robots/lwr/lwr4.mech", "data/scenes/example.mech", "data/scenes/chain.mech"})
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      SCOPED_TRACE(::testing::Message() << file << " " << seed);
      const Bent b(file, seed);
      const int frame = static_cast<int>(seed % b.mechanism.frames.size());
      const Vector3d p_B = randomVector(seed, 1, 1.0);
      const Wrench w{randomVector(seed, 4, 10.0), randomVector(seed, 7, 10.0)};
      std::vector<double> efforts(static_cast<std::size_t>(b.mechanism.dof), 0.0);
      addJointEfforts(b.mechanism, b.state, frame, p_B, w, efforts);

      Jacobian J;
      jacobian(b.mechanism, b.state, frame, J);
      Eigen::Matrix<double, 6, 1> w_F;
      const Vector3d o_B = b.state.X_BF[static_cast<std::size_t>(frame)].translation();
      w_F << w.force, w.torque + (p_B - o_B).cross(w.force);
      const Eigen::VectorXd expected = J.transpose() * w_F;
      for (int k = 0; k < b.mechanism.dof; ++k)
        EXPECT_NEAR(efforts[static_cast<std::size_t>(k)], expected[k], kExact) << k;
    }
}

TEST(JointEfforts, PowerMatchesForce) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Bent b("data/robots/lwr/lwr4.mech", seed);
    const std::size_t frame = seed % b.mechanism.frames.size();
    const Vector3d p_F = randomVector(seed, 1, 0.2), f_B = randomVector(seed, 4, 10.0);
    std::vector<double> efforts(7, 0.0), q_plus = b.q, q_minus = b.q;
    addJointEfforts(b.mechanism, b.state, static_cast<int>(frame), b.state.X_BF[frame] * p_F,
                    {f_B, Vector3d::Zero()}, efforts);
    double power = 0.0;
    for (std::size_t k = 0; k < 7; ++k) {
      const double rate = 2 * randomUnit(seed, 20 + k) - 1;
      q_plus[k] += kStep * rate;
      q_minus[k] -= kStep * rate;
      power += efforts[k] * rate;
    }
    MechanismState plus, minus;
    forward(b.mechanism, q_plus, plus);
    forward(b.mechanism, q_minus, minus);
    const Vector3d v_B = (plus.X_BF[frame] * p_F - minus.X_BF[frame] * p_F) / (2 * kStep);
    EXPECT_NEAR(power, f_B.dot(v_B), kPower);
  }
}

}  // namespace efforts_test
}  // namespace abstand::mechanism
