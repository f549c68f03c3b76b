// Forward dynamics: the inverse of inverse dynamics, and what it does to energy over time.
#include <gtest/gtest.h>

#include "core/mechanism/forward_dynamics.hpp"
#include "tests/support/robots.hpp"

namespace abstand::mechanism {
namespace forward_dynamics_test {

using namespace testing;

// Rounding, amplified by the mass matrix's condition (some thousand).
constexpr double kInverse = 1e-8;

/// One step of Runge and Kutta's fourth-order method under gravity alone.
void rungeKutta(const RigidTree& tree, double h, ForwardState& state, Eigen::VectorXd& q,
                Eigen::VectorXd& qd) {
  const auto rate = [&](const Eigen::VectorXd& at, const Eigen::VectorXd& v) {
    Eigen::VectorXd a(at.size());
    const auto view = [](const Eigen::VectorXd& x) {
      return std::span<const double>(x.data(), static_cast<std::size_t>(x.size()));
    };
    EXPECT_EQ(forwardDynamics(tree, {view(at), view(v), {}}, {}, {kGravity, {}}, state,
                              {a.data(), static_cast<std::size_t>(a.size())}),
              -1);
    return a;
  };
  const Eigen::VectorXd a1 = rate(q, qd), v2 = qd + 0.5 * h * a1;
  const Eigen::VectorXd a2 = rate(q + 0.5 * h * qd, v2), v3 = qd + 0.5 * h * a2;
  const Eigen::VectorXd a3 = rate(q + 0.5 * h * v2, v3), v4 = qd + h * a3;
  const Eigen::VectorXd a4 = rate(q + h * v3, v4);
  q += h / 6.0 * (qd + 2.0 * v2 + 2.0 * v3 + v4);
  qd += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
}

/// Largest change of energy within a second, J.
double drift(const Mechanism& m, std::uint64_t seed, double h) {
  const RigidTree tree = makeRigidTree(m);
  ForwardState state;
  const auto q0 = randomValues(m.dof, seed, 0, 1.0), qd0 = randomValues(m.dof, seed, 100, 1.0);
  Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(q0.data(), m.dof);
  Eigen::VectorXd qd = Eigen::Map<const Eigen::VectorXd>(qd0.data(), m.dof);
  const auto energy = [&] {
    const auto n = static_cast<std::size_t>(m.dof);
    return mechanicalEnergy(tree, {q.data(), n}, {qd.data(), n}, kGravity, state.tree).total();
  };
  const double begin = energy();
  double worst = 0.0;
  for (int i = 0; i < std::lround(1.0 / h); ++i) {
    rungeKutta(tree, h, state, q, qd);
    worst = std::max(worst, std::abs(energy() - begin));
  }
  return worst;
}

TEST(ForwardDynamics, InvertsInverseDynamics) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const Mechanism m = randomRobot(seed, 12, seed % 2 == 0);
    const RigidTree tree = makeRigidTree(m);
    const auto q = randomValues(m.dof, seed, 0, 2.0), qd = randomValues(m.dof, seed, 100, 2.0),
               qdd = randomValues(m.dof, seed, 200, 5.0);
    std::vector<Wrench> external(tree.bodies.size(), {Vector3d(3, -2, 1), Vector3d(-1, 4, 2)});
    ForwardState state;
    std::vector<double> tau(q.size()), back(q.size());
    inverseDynamics(tree, {q, qd, qdd}, {kGravity, external}, state.tree, tau);
    ASSERT_EQ(forwardDynamics(tree, {q, qd, {}}, tau, {kGravity, external}, state, back), -1);
    for (std::size_t k = 0; k < q.size(); ++k) EXPECT_NEAR(back[k], qdd[k], kInverse) << k;
  }
}

// Halving the step divides the error of a fourth-order method by 16, where rounding does not show yet.
constexpr double kMinFall = 12.0;

TEST(ForwardDynamics, ConservesEnergyToOrderOfStep) {
  struct Case {
    const char* name;
    Mechanism mechanism;
    double step;  ///< s
    double most;  ///< J, of some 10 J of energy that is exchanged
  };
  const Case cases[] = {{"double pendulum", doublePendulum(1.0, 0.5, 0.8, 0.4), 0.01, 1e-3},
                        {"seven axes", sevenAxisArm(), 0.002, 0.1},
                        {"mimic", randomRobot(4, 8, true), 0.004, 0.1}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const double coarse = drift(c.mechanism, 7, c.step), fine = drift(c.mechanism, 7, 0.5 * c.step);
    RecordProperty("coarse", std::to_string(coarse));
    EXPECT_LT(coarse, c.most);
    EXPECT_GT(coarse / fine, kMinFall) << coarse << " " << fine;
  }
}

}  // namespace forward_dynamics_test
}  // namespace abstand::mechanism
