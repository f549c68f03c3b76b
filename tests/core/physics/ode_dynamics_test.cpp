// Our forward dynamics against ODE's own, left to itself: bodies, hinges and sliders, steps towards zero.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include "core/mechanism/forward_dynamics.hpp"
#include "tests/support/robots.hpp"

namespace abstand::physics {
namespace ode_dynamics_test {

using namespace testing;

// Of the largest value: a thousandth of the agreement that is asked for, and some thirty times what is found.
constexpr double kAgreement = 1e-9;

/// Bodies and joints of ODE, made from a tree whose dofs all have the scale 1, moving with q and qd. `erp`:
/// the share of the joints' error that a step takes back.
class OdeChain {
 public:
  OdeChain(const mechanism::RigidTree& tree, std::span<const double> q, std::span<const double> qd,
           double erp)
      : tree_(tree) {
    dInitODE2(0);
    world_ = dWorldCreate();
    dWorldSetGravity(world_, mechanism::kGravity.x(), mechanism::kGravity.y(), mechanism::kGravity.z());
    dWorldSetCFM(world_, 0.0);
    dWorldSetERP(world_, erp);
    mechanism::placeBodies(tree, q, state_);
    mechanism::moveBodies(tree, qd, state_);
    for (std::size_t i = 0; i < tree.bodies.size(); ++i) addBody(i);
  }
  ~OdeChain() { dWorldDestroy(world_); }
  OdeChain(const OdeChain&) = delete;
  OdeChain& operator=(const OdeChain&) = delete;

  void push(std::size_t i, const Wrench& w, const Vector3d& p_W) {
    dBodyAddForceAtPos(bodies_[i], w.force.x(), w.force.y(), w.force.z(), p_W.x(), p_W.y(), p_W.z());
    dBodyAddTorque(bodies_[i], w.torque.x(), w.torque.y(), w.torque.z());
  }
  void step(double h, std::span<const double> efforts) {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      tree_.bodies[i].prismatic ? dJointAddSliderForce(joints_[i], efforts[i])
                                : dJointAddHingeTorque(joints_[i], efforts[i]);
    dWorldStep(world_, h);
  }
  /// Along a slider's axis, that is against the point of the parent that is there: ODE's own rate of a slider
  /// forgets that the parent turns.
  double rate(std::size_t i) const {
    const int parent = tree_.bodies[i].parent;
    if (!tree_.bodies[i].prismatic) return dJointGetHingeAngleRate(joints_[i]);
    dVector3 axis, v{};
    dJointGetSliderAxis(joints_[i], axis);
    const dReal* p = dBodyGetPosition(bodies_[i]);
    if (parent >= 0) dBodyGetPointVel(bodies_[static_cast<std::size_t>(parent)], p[0], p[1], p[2], v);
    const dReal* mine = dBodyGetLinearVel(bodies_[i]);
    return axis[0] * (mine[0] - v[0]) + axis[1] * (mine[1] - v[1]) + axis[2] * (mine[2] - v[2]);
  }
  /// Since the beginning.
  double moved(std::size_t i) const {
    return tree_.bodies[i].prismatic ? dJointGetSliderPosition(joints_[i]) : dJointGetHingeAngle(joints_[i]);
  }

 private:
  void addBody(std::size_t i) {
    const mechanism::TreeBody& b = tree_.bodies[i];
    const mechanism::TreeBodyState& s = state_.bodies[i];
    const dBodyID body = dBodyCreate(world_);
    dMass mass;
    const Matrix3d& I = b.inertia;
    dMassSetParameters(&mass, b.mass, 0, 0, 0, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
    dBodySetMass(body, &mass);
    dBodySetFiniteRotationMode(body, 1);
    const Vector3d c = s.p_B + s.com_B, v = s.velocity + s.omega.cross(s.com_B);
    dMatrix3 R{};
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) R[4 * row + column] = s.R_B(row, column);
    dBodySetPosition(body, c.x(), c.y(), c.z());
    dBodySetRotation(body, R);
    dBodySetLinearVel(body, v.x(), v.y(), v.z());
    dBodySetAngularVel(body, s.omega.x(), s.omega.y(), s.omega.z());
    const dBodyID parent = b.parent < 0 ? nullptr : bodies_[static_cast<std::size_t>(b.parent)];
    bodies_.push_back(body);
    if (b.prismatic) {
      joints_.push_back(dJointCreateSlider(world_, nullptr));
      dJointAttach(joints_[i], body, parent);
      dJointSetSliderAxis(joints_[i], s.axis_B.x(), s.axis_B.y(), s.axis_B.z());
    } else {
      joints_.push_back(dJointCreateHinge(world_, nullptr));
      dJointAttach(joints_[i], body, parent);
      dJointSetHingeAnchor(joints_[i], s.p_B.x(), s.p_B.y(), s.p_B.z());
      dJointSetHingeAxis(joints_[i], s.axis_B.x(), s.axis_B.y(), s.axis_B.z());
    }
  }

  const mechanism::RigidTree& tree_;
  mechanism::TreeState state_;
  dWorldID world_;
  std::vector<dBodyID> bodies_;
  std::vector<dJointID> joints_;
};

double largest(std::span<const double> v) {
  double most = 0.0;
  for (const double x : v) most = std::max(most, std::abs(x));
  return most;
}

TEST(OdeDynamics, AccelerationsAtRestMatchForwardDynamics) {
  // A step of a microsecond from rest: velocities over the step, without what velocities would add.
  constexpr double kStep = 1e-6;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const mechanism::Mechanism m = seed == 0 ? sevenAxisArm() : randomRobot(seed, 10, false);
    const mechanism::RigidTree tree = mechanism::makeRigidTree(m);
    const auto q = randomValues(m.dof, seed, 0, 2.0), tau = randomValues(m.dof, seed, 100, 20.0);
    const std::vector<double> rest(q.size(), 0.0);
    OdeChain ode(tree, q, rest, 0.0);  // else rounding over the step's square is put right
    mechanism::ForwardState state;
    mechanism::placeBodies(tree, q, state.tree);
    std::vector<Wrench> external(tree.bodies.size());
    for (std::size_t i = 0; i < external.size(); ++i) {
      const auto v = randomValues(9, seed, 300 + 10 * i, 10.0);
      const Vector3d p_W = state.tree.bodies[i].p_B + 0.02 * Vector3d(v[0], v[1], v[2]);
      const Wrench w{Vector3d(v[3], v[4], v[5]), Vector3d(v[6], v[7], v[8])};
      ode.push(i, w, p_W);
      external[i] = mechanism::aboutOrigin(w, p_W);
    }
    std::vector<double> qdd(q.size());
    ASSERT_EQ(
        mechanism::forwardDynamics(tree, {q, rest, {}}, tau, {mechanism::kGravity, external}, state, qdd),
        -1);
    ode.step(kStep, tau);
    for (std::size_t i = 0; i < q.size(); ++i)
      EXPECT_NEAR(ode.rate(i) / kStep, qdd[i], kAgreement * largest(qdd)) << i;
  }
}

constexpr double kTime = 0.05;  // s
constexpr int kLevels = 5;      // 100 to 1,600 steps

/// q and qd after kTime under constant efforts, by ODE, Richardson's extrapolation of steps towards zero.
std::vector<double> extrapolated(const mechanism::RigidTree& tree, std::span<const double> q,
                                 std::span<const double> qd, std::span<const double> tau) {
  const std::size_t n = q.size();
  std::vector<std::vector<double>> levels;
  for (int level = 0; level < kLevels; ++level) {
    const int steps = 100 << level;
    OdeChain ode(tree, q, qd, 1.0);
    for (int i = 0; i < steps; ++i) ode.step(kTime / steps, tau);
    std::vector<double> end(2 * n);
    for (std::size_t i = 0; i < n; ++i) {
      end[i] = q[i] + ode.moved(i);
      end[n + i] = ode.rate(i);
    }
    levels.push_back(end);
  }
  for (int order = 1; order < kLevels; ++order)
    for (std::size_t level = levels.size() - 1; level >= static_cast<std::size_t>(order); --level)
      for (std::size_t i = 0; i < 2 * n; ++i) {
        const double factor = std::pow(2.0, order);
        levels[level][i] = (factor * levels[level][i] - levels[level - 1][i]) / (factor - 1.0);
      }
  return levels.back();
}

/// The same by our forward dynamics and Runge and Kutta's method of fourth order.
std::vector<double> integrated(const mechanism::RigidTree& tree, std::span<const double> q,
                               std::span<const double> qd, std::span<const double> tau) {
  const std::size_t n = q.size();
  mechanism::ForwardState state;
  std::vector<double> x(q.begin(), q.end());
  x.insert(x.end(), qd.begin(), qd.end());
  const auto slope = [&](const std::vector<double>& at) {
    std::vector<double> out(at.begin() + static_cast<std::ptrdiff_t>(n), at.end());
    out.resize(2 * n);
    const std::span<const double> all(at);
    EXPECT_EQ(mechanism::forwardDynamics(tree, {all.first(n), all.last(n), {}}, tau,
                                         {mechanism::kGravity, {}}, state, std::span(out).last(n)),
              -1);
    return out;
  };
  const auto along = [&](const std::vector<double>& s, double h) {
    std::vector<double> out = x;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += h * s[i];
    return out;
  };
  constexpr int kSteps = 500;
  const double h = kTime / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    const auto a = slope(x), b = slope(along(a, h / 2)), c = slope(along(b, h / 2)), d = slope(along(c, h));
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  }
  return x;
}

TEST(OdeDynamics, MotionConvergesToForwardDynamics) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    const mechanism::Mechanism m = seed == 0 ? sevenAxisArm() : randomRobot(seed, 6, false);
    mechanism::RigidTree tree = mechanism::makeRigidTree(m);
    for (mechanism::TreeBody& b : tree.bodies) b.offset = 0.0;
    const auto q = randomValues(m.dof, seed, 0, 1.0), qd = randomValues(m.dof, seed, 100, 1.5),
               tau = randomValues(m.dof, seed, 200, 5.0);
    const auto ode = extrapolated(tree, q, qd, tau), ours = integrated(tree, q, qd, tau);
    for (std::size_t i = 0; i < ours.size(); ++i)
      EXPECT_NEAR(ode[i], ours[i], kAgreement * largest(ours)) << i;
  }
}

}  // namespace ode_dynamics_test
}  // namespace abstand::physics
