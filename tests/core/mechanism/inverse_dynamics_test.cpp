// Recursive Newton-Euler against closed forms, Lagrange's equations, virtual work and the balance of power.
#include <gtest/gtest.h>

#include "core/mechanism/forward_dynamics.hpp"
#include "tests/core/mechanism/lagrange.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/robots.hpp"

namespace abstand::mechanism {
namespace inverse_dynamics_test {

using namespace testing;

// Rounding of a few dozen products of numbers near 10.
constexpr double kExact = 1e-12;
// Central differences of a step of 1e-5: the step's square, and rounding over the step, of numbers near 100.
constexpr double kDifference = 1e-7;
constexpr std::uint64_t kRobots = 60;

std::vector<double> efforts(const Mechanism& m, std::span<const double> q, std::span<const double> qd,
                            std::span<const double> qdd, const Vector3d& gravity_B = kGravity) {
  const RigidTree tree = makeRigidTree(m);
  TreeState state;
  std::vector<double> tau(static_cast<std::size_t>(m.dof), kNaN);
  inverseDynamics(tree, {q, qd, qdd}, {gravity_B, {}}, state, tau);
  return tau;
}

TEST(InverseDynamics, PendulumMatchesClosedForm) {
  const double m = 1.7, l = 0.6, g = 9.80665;
  for (const double q : {-2.0, -0.3, 0.0, 0.8, 3.0})
    for (const double qdd : {-4.0, 0.0, 2.5})
      EXPECT_NEAR(efforts(pendulum(m, l), std::vector{q}, std::vector{3.3}, std::vector{qdd})[0],
                  m * l * l * qdd + m * g * l * std::sin(q), kExact);
}

TEST(InverseDynamics, DoublePendulumMatchesClosedForm) {
  // [Craig, Introduction to Robotics, 6.7], with angles from the vertical.
  const double m0 = 1.3, l0 = 0.5, m1 = 0.7, l1 = 0.4, g = 9.80665;
  const Mechanism mechanism = doublePendulum(m0, l0, m1, l1);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    const auto q = randomValues(2, seed, 0, 3.0), v = randomValues(2, seed, 10, 4.0),
               a = randomValues(2, seed, 20, 8.0);
    const double c1 = std::cos(q[1]), s1 = std::sin(q[1]), s01 = std::sin(q[0] + q[1]);
    const double outer = m1 * l1 * l1 * (a[0] + a[1]) + m1 * l0 * l1 * c1 * a[0] +
                         m1 * l0 * l1 * s1 * v[0] * v[0] + m1 * g * l1 * s01;
    const double inner = outer + m1 * l0 * l1 * c1 * (a[0] + a[1]) + (m0 + m1) * l0 * l0 * a[0] -
                         m1 * l0 * l1 * s1 * (v[0] + v[1]) * (v[0] + v[1]) +
                         (m0 + m1) * g * l0 * std::sin(q[0]);
    const auto tau = efforts(mechanism, q, v, a);
    EXPECT_NEAR(tau[0], inner, kExact * 10);
    EXPECT_NEAR(tau[1], outer, kExact * 10);
  }
}

TEST(InverseDynamics, SlideOnTurntableMatchesClosedForm) {
  // A mass m at distance x on an arm that turns about the vertical z: m x^2 qdd0 + 2 m x v1 v0; m a - m x
  // v0^2. The slide points along x and up by 30 degrees, so it also lifts.
  Mechanism m;
  m.dof = 2;
  m.frames.push_back(jointFrame(1, -1, JointType::kRevolute, {0, 0, 1}, {0, 0, 0}, 0));
  const double up = kPi / 6, mass = 2.5;
  m.frames.push_back(jointFrame(2, 0, JointType::kPrismatic, {std::cos(up), 0, std::sin(up)}, {0, 0, 0}, 1));
  m.frames[1].inertia = pointMass(mass, Vector3d::Zero());
  m.prepare();
  const double s = 0.7, v0 = 2.0, v1 = -1.5, a0 = 3.0, a1 = 4.0, c = std::cos(up);
  const auto tau = efforts(m, std::vector{0.4, s}, std::vector{v0, v1}, std::vector{a0, a1});
  EXPECT_NEAR(tau[0], mass * c * c * (s * s * a0 + 2 * s * v1 * v0), kExact);
  EXPECT_NEAR(tau[1], mass * (a1 - c * c * s * v0 * v0 + 9.80665 * std::sin(up)), kExact);
}

TEST(InverseDynamics, MatchesLagrangeEquations) {
  for (const bool mimic : {false, true})
    for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
      SCOPED_TRACE(::testing::Message() << (mimic ? "mimic " : "") << seed);
      const Mechanism m = randomRobot(seed, 3 + static_cast<int>(seed % 8), mimic);
      const auto q = randomValues(m.dof, seed, 0, 2.0), qd = randomValues(m.dof, seed, 100, 2.0),
                 qdd = randomValues(m.dof, seed, 200, 5.0);
      const Vector3d gravity_B = 9.8 * randomPose(seed).linear().col(0);
      const Eigen::VectorXd expected = lagrangeEfforts(m, q, qd, qdd, gravity_B);
      const auto tau = efforts(m, q, qd, qdd, gravity_B);
      const double size = 1.0 + expected.cwiseAbs().maxCoeff();
      for (int k = 0; k < m.dof; ++k)
        EXPECT_NEAR(tau[static_cast<std::size_t>(k)], expected[k], kDifference * size) << k;
    }
}

TEST(InverseDynamics, ExternalWrenchesReduceMotorEfforts) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    SCOPED_TRACE(seed);
    const Mechanism m = randomRobot(seed, 9, seed % 2 == 0);
    const RigidTree tree = makeRigidTree(m);
    const auto q = randomValues(m.dof, seed, 0, 2.0), qd = randomValues(m.dof, seed, 100, 2.0),
               qdd = randomValues(m.dof, seed, 200, 5.0);
    TreeState state;
    MechanismState poses;
    std::vector<double> free(q.size()), pushed(q.size()), work(q.size(), 0.0), same(q.size(), 0.0);
    inverseDynamics(tree, {q, qd, qdd}, {kGravity, {}}, state, free);
    forward(m, q, poses);
    std::vector<Wrench> external(tree.bodies.size());
    for (std::size_t i = 0; i < m.frames.size(); ++i) {
      const auto v = randomValues(9, seed, 300 + 10 * i, 20.0);
      const Vector3d p_B(v[0] / 20, v[1] / 20, v[2] / 20);
      const Wrench w{Vector3d(v[3], v[4], v[5]), Vector3d(v[6], v[7], v[8])};
      addJointEfforts(m, poses, static_cast<int>(i), p_B, w, work);
      const int body = tree.frames[i].body;
      addBodyEfforts(tree, state, body, p_B, w, same);
      if (body >= 0) external[static_cast<std::size_t>(body)] += aboutOrigin(w, p_B);
    }
    inverseDynamics(tree, {q, qd, qdd}, {kGravity, external}, state, pushed);
    for (std::size_t k = 0; k < q.size(); ++k) {
      EXPECT_NEAR(free[k] - pushed[k], work[k], kExact * 1000);
      EXPECT_NEAR(same[k], work[k], kExact * 1000);
    }
  }
}

TEST(InverseDynamics, PowerMatchesEnergyRate) {
  // q(t) = q + qd t + qdd t^2 / 2; energy by poses and velocities alone.
  constexpr double kStep = 1e-5;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    SCOPED_TRACE(seed);
    const Mechanism m = randomRobot(seed, 9, seed % 2 == 0);
    const RigidTree tree = makeRigidTree(m);
    const auto q = randomValues(m.dof, seed, 0, 2.0), qd = randomValues(m.dof, seed, 100, 2.0),
               qdd = randomValues(m.dof, seed, 200, 5.0);
    TreeState state;
    const auto energyAt = [&](double t) {
      auto at = q, rate = qd;
      for (std::size_t k = 0; k < q.size(); ++k) {
        at[k] += t * qd[k] + 0.5 * t * t * qdd[k];
        rate[k] += t * qdd[k];
      }
      return mechanicalEnergy(tree, at, rate, kGravity, state).total();
    };
    std::vector<double> tau(q.size());
    inverseDynamics(tree, {q, qd, qdd}, {kGravity, {}}, state, tau);
    double power = 0.0, size = 1.0;
    for (std::size_t k = 0; k < q.size(); ++k) {
      power += tau[k] * qd[k];
      size += std::abs(tau[k] * qd[k]);
    }
    EXPECT_NEAR(power, (energyAt(kStep) - energyAt(-kStep)) / (2 * kStep), kDifference * size);
  }
}

TEST(InverseDynamics, GravityAndBiasMatchSpecialCases) {
  const RigidTree tree = makeRigidTree(sevenAxisArm());
  const auto q = randomValues(7, 1, 0, 2.0), qd = randomValues(7, 1, 100, 2.0);
  TreeState state;
  std::vector<double> a(7), b(7);
  const std::vector<double> zeros(7, 0.0);
  inverseDynamics(tree, {q, zeros, zeros}, {kGravity, {}}, state, a);
  gravityEfforts(tree, q, kGravity, state, b);
  EXPECT_EQ(a, b);
  inverseDynamics(tree, {q, qd, zeros}, {kGravity, {}}, state, a);
  biasEfforts(tree, q, qd, kGravity, state, b);
  EXPECT_EQ(a, b);
}

TEST(InverseDynamics, AllocatesNothingInSteadyState) {
  const RigidTree tree = makeRigidTree(sevenAxisArm());
  std::vector<double> q(7, 0.1), qd(7, 0.2), tau(7), qdd(7);
  ForwardState state;
  ASSERT_EQ(forwardDynamics(tree, {q, qd, {}}, {}, {kGravity, {}}, state, qdd), -1);
  const testing::NoAlloc guard;
  for (int i = 0; i < 100; ++i) {
    q[3] += 0.01;
    inverseDynamics(tree, {q, qd, qdd}, {kGravity, {}}, state.tree, tau);
    forwardDynamics(tree, {q, qd, {}}, tau, {kGravity, {}}, state, qdd);
  }
  EXPECT_EQ(guard.count(), 0);
}

TEST(RigidTree, FramesMatchForwardKinematics) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    SCOPED_TRACE(seed);
    Mechanism m = randomRobot(seed, 12, seed % 2 == 0);
    // A variable that no dof maps stands at its offset.
    m.frames.back().dof = -1;
    const auto q = randomValues(m.dof, seed, 0, 2.0);
    const RigidTree tree = makeRigidTree(m);
    TreeState state;
    MechanismState expected;
    placeBodies(tree, q, state);
    forward(m, q, expected);
    for (std::size_t i = 0; i < m.frames.size(); ++i)
      EXPECT_LT((poseOfFrame(tree, state, static_cast<int>(i)).matrix() - expected.X_BF[i].matrix())
                    .cwiseAbs()
                    .maxCoeff(),
                kExact)
          << i;
  }
}

}  // namespace inverse_dynamics_test
}  // namespace abstand::mechanism
