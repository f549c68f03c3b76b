// The mass matrix against Newton-Euler's columns and Lagrange's sum; effective masses against closed forms.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "core/mechanism/effective_mass.hpp"
#include "core/mechanism/forward_dynamics.hpp"
#include "tests/core/mechanism/lagrange.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/robots.hpp"

namespace abstand::mechanism {
namespace mass_matrix_test {

using namespace testing;

// Rounding of some hundred products, as a share of the largest entry.
constexpr double kExact = 1e-12;
constexpr std::uint64_t kRobots = 60;

struct Posed {
  RigidTree tree;
  ForwardState state;
  std::vector<double> q;
  Posed(const Mechanism& m, std::uint64_t seed) : tree(makeRigidTree(m)) {
    q = randomValues(m.dof, seed, 0, 2.0);
    placeBodies(tree, q, state.tree);
    massMatrix(tree, state.tree, state.mass);
  }
};

TEST(MassMatrix, ColumnsMatchNewtonEuler) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    SCOPED_TRACE(seed);
    Posed p(randomRobot(seed, 12, seed % 2 == 0), seed);
    const Eigen::MatrixXd M = p.state.mass.M;
    EXPECT_EQ((M - M.transpose()).cwiseAbs().maxCoeff(), 0.0);
    std::vector<double> unit(p.q.size(), 0.0), column(p.q.size());
    for (std::size_t k = 0; k < unit.size(); ++k) {
      unit[k] = 1.0;
      inverseDynamics(p.tree, {p.q, {}, unit}, {Vector3d::Zero(), {}}, p.state.tree, column);
      unit[k] = 0.0;
      for (std::size_t i = 0; i < unit.size(); ++i)
        EXPECT_NEAR(M(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)), column[i],
                    kExact * M.cwiseAbs().maxCoeff());
    }
  }
}

TEST(MassMatrix, MatchesKineticEnergyAndIsPositiveDefinite) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    SCOPED_TRACE(seed);
    const Mechanism m = randomRobot(seed, 12, seed % 2 == 0);
    Posed p(m, seed);
    const Eigen::MatrixXd& M = p.state.mass.M;
    EXPECT_LT((M - lagrangeMass(m, p.q)).cwiseAbs().maxCoeff(), kExact * M.cwiseAbs().maxCoeff());
    EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(M).info(), Eigen::Success) << "not positive definite";
    // Twice the kinetic energy.
    const auto qd = randomValues(m.dof, seed, 100, 2.0);
    const Eigen::Map<const Eigen::VectorXd> rate(qd.data(), m.dof);
    TreeState state;
    EXPECT_NEAR(0.5 * rate.dot(M * rate), mechanicalEnergy(p.tree, p.q, qd, Vector3d::Zero(), state).kinetic,
                kExact * M.cwiseAbs().maxCoeff() * (1.0 + rate.squaredNorm()));
    // And it is solved.
    ASSERT_EQ(factor(p.state.mass), -1);
    std::vector<double> x = qd;
    solveMass(p.state.mass, x);
    const Eigen::Map<const Eigen::VectorXd> solved(x.data(), m.dof);
    EXPECT_LT((M * solved - rate).norm(), kExact * M.cwiseAbs().maxCoeff() * (1.0 + solved.norm()));
  }
}

TEST(MassMatrix, HumanoidIsFactorized) {
  Posed p(humanoid(), 3);
  ASSERT_EQ(p.tree.dof, 47);
  ASSERT_EQ(factor(p.state.mass), -1);
  const Eigen::MatrixXd L = p.state.mass.L.triangularView<Eigen::Lower>();
  EXPECT_LT((L * L.transpose() - p.state.mass.M).cwiseAbs().maxCoeff(),
            kExact * p.state.mass.M.cwiseAbs().maxCoeff());
}

TEST(MassMatrix, ReportsDofWithoutMass) {
  Mechanism m = doublePendulum(1.0, 0.5, 0.0, 0.4);
  Posed p(m, 1);
  EXPECT_EQ(factor(p.state.mass), 1);
  // Two joints about the same axis: either alone moves the mass, both together one dof too many.
  m = doublePendulum(0.0, 0.0, 1.0, 0.4);
  Posed twice(m, 1);
  EXPECT_EQ(factor(twice.state.mass), 1);
  // A massless frame between two axes is no trouble when what it carries has mass.
  m = doublePendulum(0.0, 0.5, 1.0, 0.4);
  Posed carried(m, 1);
  EXPECT_EQ(factor(carried.state.mass), -1);
}

TEST(EffectiveMass, RodMatchesClosedForm) {
  // A rod with a mass m at l, pushed at r across: m l^2 / r^2; along the rod: a wall.
  const double mass = 1.5, l = 0.8, r = 0.5;
  Posed p(pendulum(mass, l), 1);
  ASSERT_EQ(factor(p.state.mass), -1);
  std::vector<double> work(1);
  const Vector3d along_B = p.state.tree.bodies[0].R_B.col(2), across_B = p.state.tree.bodies[0].R_B.col(0);
  const auto at = [&](const Vector3d& n_B) {
    return effectiveMass({p.tree, p.state.tree, p.state.mass}, 0, -r * along_B, n_B, work);
  };
  EXPECT_NEAR(at(across_B), mass * l * l / (r * r), kExact);
  EXPECT_NEAR(at((across_B + along_B).normalized()), 2 * mass * l * l / (r * r), 10 * kExact);
  EXPECT_GT(at(along_B), 1e15);
  EXPECT_EQ(at(Vector3d::UnitY()), kInfinity);
}

TEST(EffectiveMass, MatchesForceOverAcceleration) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    SCOPED_TRACE(seed);
    const Mechanism m = randomRobot(seed, 10, seed % 2 == 0);
    Posed p(m, seed);
    ASSERT_EQ(factor(p.state.mass), -1);
    const int frame = static_cast<int>(m.frames.size()) - 1;
    const Vector3d n_B = randomPose(seed).linear().col(1);
    const Transform X_BF = poseOfFrame(p.tree, p.state.tree, frame);
    const Vector3d p_B = X_BF * Vector3d(0.1, 0.2, -0.1);
    std::vector<double> work(p.q.size()), qdd(p.q.size());
    const double mass = effectiveMass({p.tree, p.state.tree, p.state.mass}, frame, p_B, n_B, work);
    // Push with 1 N at rest, without gravity.
    std::vector<Wrench> external(p.tree.bodies.size());
    const auto body = static_cast<std::size_t>(p.tree.frames[static_cast<std::size_t>(frame)].body);
    external[body] = aboutOrigin({n_B, Vector3d::Zero()}, p_B);
    ASSERT_EQ(forwardDynamics(p.tree, {p.q, {}, {}}, {}, {Vector3d::Zero(), external}, p.state, qdd), -1);
    moveBodies(p.tree, qdd, p.state.tree);  // at rest, accelerations are the velocities of the rates qdd
    const TreeBodyState& s = p.state.tree.bodies[body];
    EXPECT_NEAR(mass * n_B.dot(s.velocity + s.omega.cross(p_B - s.p_B)), 1.0, 1e-9);
  }
}

}  // namespace mass_matrix_test
}  // namespace abstand::mechanism
