// Mechanisms in a physics world, by both solvers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/physics/physics_world.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/robots.hpp"

namespace abstand::physics {
namespace mechanism_test {

using namespace testing;

constexpr double kStep = 0.001;  // s
// Of the largest velocity: rounding, amplified by chains of bodies of very different mass.
constexpr double kSame = 1e-9;

class PhysicsMechanism : public ::testing::TestWithParam<MechanismSolver> {};
INSTANTIATE_TEST_SUITE_P(Solvers, PhysicsMechanism,
                         ::testing::Values(MechanismSolver::kJointed, MechanismSolver::kReduced),
                         [](const auto& solver) {
                           return solver.param == MechanismSolver::kJointed ? "Jointed" : "Reduced";
                         });

/// A box on a joint of one degree of freedom about y or along x, its stops at +-0.5.
mechanism::Mechanism single(mechanism::JointType type) {
  mechanism::Mechanism m;
  m.name = "single";
  m.dof = 1;
  const bool slides = type == mechanism::JointType::kPrismatic;
  m.frames.push_back(
      jointFrame(1, -1, type, slides ? Vector3d::UnitX() : Vector3d::UnitY(), Vector3d::Zero(), 0));
  m.frames[0].inertia = boxMass(2.0, {0.2, 0.2, 0.4}, slides ? Vector3d::Zero() : Vector3d(0, 0, -0.2));
  m.frames[0].limits = {-0.5, 0.5, kInfinity, 40.0};
  m.prepare();
  return m;
}
// Of single(kRevolute), about its joint.
constexpr double kInertia = 2.0 / 12.0 * (0.04 + 0.16) + 2.0 * 0.04;
constexpr double kMass = 2.0;

double inertia(mechanism::JointType type) {
  return type == mechanism::JointType::kPrismatic ? kMass : kInertia;
}

TEST_P(PhysicsMechanism, FollowsForwardDynamics) {
  // One step from any state, under efforts and wrenches: qd' = qd + h qdd(q, (qd + qd') / 2), q' = q + h qd'.
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const mechanism::Mechanism m = seed == 0 ? humanoid() : randomRobot(seed, 10, seed % 2 == 0);
    const Transform X_WB = randomPose(seed);
    PhysicsWorld world;
    const int robot = world.addMechanism(m, X_WB, {.solver = GetParam(), .limits = false});
    const auto q = randomValues(m.dof, seed, 0, 2.0), qd = randomValues(m.dof, seed, 100, 2.0);
    std::vector<double> tau = randomValues(m.dof, seed, 200, 1.0), qdd(q.size());
    world.mechanism(robot).setState(q, qd);
    for (int k = 0; k < m.dof; ++k) world.setJointEffort(robot, k, tau[static_cast<std::size_t>(k)]);
    const Wrench push{Vector3d(3, -4, 5), Vector3d(0.5, 0.2, -0.3)};
    const int frame = static_cast<int>(m.frames.size()) - 1;
    const Vector3d p_W = world.pose({robot, frame}) * Vector3d(0.1, 0.0, 0.1);
    world.applyWrench({robot, frame}, push, p_W);
    world.step(kStep);

    const mechanism::RigidTree tree = mechanism::makeRigidTree(m);
    mechanism::ForwardState state;
    std::vector<Wrench> external(tree.bodies.size());
    const Matrix3d R_BW = X_WB.linear().transpose();
    const int body = tree.frames[static_cast<std::size_t>(frame)].body;
    external[static_cast<std::size_t>(body)] =
        mechanism::aboutOrigin({R_BW * push.force, R_BW * push.torque}, X_WB.inverse() * p_W);
    auto middle = qd;
    for (std::size_t k = 0; k < qd.size(); ++k) middle[k] = 0.5 * (qd[k] + world.qd(robot)[k]);
    ASSERT_EQ(mechanism::forwardDynamics(tree, {q, middle, {}}, tau, {R_BW * mechanism::kGravity, external},
                                         state, qdd),
              -1);
    double size = 1.0;
    for (const double a : qdd) size = std::max(size, std::abs(a));
    for (std::size_t k = 0; k < q.size(); ++k) {
      EXPECT_NEAR(world.qd(robot)[k], qd[k] + kStep * qdd[k], kSame * size) << k;
      EXPECT_NEAR(world.q(robot)[k], q[k] + kStep * world.qd(robot)[k], kSame * size) << k;
    }
  }
}

TEST_P(PhysicsMechanism, FramesMatchForwardKinematics) {
  // Ten seconds of a whirling double pendulum: its joints never come apart, and angles do not wrap.
  mechanism::Mechanism m = doublePendulum(1.0, 0.5, 0.8, 0.4);
  for (auto& f : m.frames) f.inertia.inertia_F = Vector3d::Constant(1e-3).asDiagonal();
  PhysicsWorld world;
  const int robot = world.addMechanism(m, Transform::Identity(), {.solver = GetParam()});
  world.mechanism(robot).setState(std::vector{2.5, 0.5}, std::vector{6.0, 0.0});
  double last = 2.5;
  for (int i = 0; i < 10000; ++i) {
    world.step(kStep);
    ASSERT_LT(std::abs(world.q(robot)[0] - last), 0.1);
    last = world.q(robot)[0];
  }
  mechanism::MechanismState expected;
  mechanism::forward(m, world.q(robot), expected);
  for (int i = 0; i < 2; ++i)
    EXPECT_TRUE(world.pose({robot, i}).isApprox(expected.X_BF[static_cast<std::size_t>(i)], 1e-12));
}

/// Energy (J) over ten seconds, against that at the beginning: its largest gain, and the mean of the last
/// five.
struct Drift {
  double most{0.0}, mean{0.0};
};
Drift drift(PhysicsWorld& world) {
  const double begin = world.energy().total();
  Drift result;
  for (int i = 0; i < 10000; ++i) {
    world.step(kStep);
    const double gain = world.energy().total() - begin;
    result.most = std::max(result.most, gain);
    if (i >= 5000) result.mean += gain / 5000.0;
  }
  return result;
}

TEST_P(PhysicsMechanism, GainsNoEnergy) {
  // Velocities stand half a step before positions, so energy swings by the power of gravity (up to 250 W
  // here) times half a step; it must not pile up.
  mechanism::Mechanism two = doublePendulum(1.0, 0.5, 0.8, 0.4);
  for (auto& f : two.frames) f.inertia.inertia_F = Vector3d::Constant(1e-3).asDiagonal();
  PhysicsWorld world;
  world.addMechanism(two, Transform::Identity(), {.solver = GetParam()});
  world.mechanism(0).setState(std::vector{1.5, 0.5}, std::vector{0.0, 0.0});
  const Drift pendulum = drift(world);
  EXPECT_LT(pendulum.most, 0.15);
  EXPECT_NEAR(pendulum.mean, 0.0, 0.01);

  // Seven joints without any friction whip their hand round at 170 rad/s: a sixth of a turn in six steps.
  PhysicsWorld arm;
  arm.addMechanism(sevenAxisArm(), Transform::Identity(), {.solver = GetParam(), .limits = false});
  arm.mechanism(0).setState(randomValues(7, 1, 0, 1.0), std::vector(7, 0.0));
  const Drift whip = drift(arm);
  EXPECT_LT(whip.most, 20.0);
  EXPECT_NEAR(whip.mean, 0.0, 1.0);
}

TEST_P(PhysicsMechanism, StandsStillWithGravityCompensation) {
  PhysicsWorld world;
  const mechanism::Mechanism m = humanoid();
  MechanismOptions options{.solver = GetParam(), .gravity_compensation = true};
  options.limits = false;
  const int robot = world.addMechanism(m, Transform::Identity(), options);
  const auto q = randomValues(m.dof, 1, 0, 0.3);
  world.mechanism(robot).setState(q, std::vector(q.size(), 0.0));
  for (int i = 0; i < 200; ++i) world.step(kStep);
  // An unstable balance, so rounding grows a little.
  for (std::size_t k = 0; k < q.size(); ++k) EXPECT_NEAR(world.q(robot)[k], q[k], 1e-9) << k;
}

TEST_P(PhysicsMechanism, StopsAtLimits) {
  for (const auto type : {mechanism::JointType::kRevolute, mechanism::JointType::kPrismatic})
    for (const double way : {1.0, -1.0}) {
      SCOPED_TRACE(::testing::Message() << static_cast<int>(type) << " " << way);
      PhysicsWorld world({.gravity_W = Vector3d::Zero()});
      world.addMechanism(single(type), Transform::Identity(), {.solver = GetParam()});
      world.setJointEffort(0, 0, 10.0 * way);
      const double a = 10.0 / inertia(type);
      const double speed = std::sqrt(2.0 * a * 0.5);  // on arrival
      double farthest = 0.0;
      for (int i = 0; i < 3000; ++i) {
        world.step(kStep);
        farthest = std::max(farthest, way * world.q(0)[0]);
        ASSERT_LE(std::abs(world.qd(0)[0]), speed + 2 * a * kStep);
      }
      // Beyond by a step's way at most, and pressed into the stop in the end.
      EXPECT_LT(farthest, 0.5 + (speed + 2 * a * kStep) * kStep);
      EXPECT_NEAR(way * world.q(0)[0], 0.5, 1e-4);
      EXPECT_NEAR(world.qd(0)[0], 0.0, 0.02);
    }
}

TEST_P(PhysicsMechanism, HasStopsBeyondHalfTurn) {
  mechanism::Mechanism m = single(mechanism::JointType::kRevolute);
  m.frames[0].limits.lower = -1.0;
  m.frames[0].limits.upper = 10.0;
  PhysicsWorld world({.gravity_W = Vector3d::Zero()});
  // The motor pushes into the stop and does not care for it.
  MechanismOptions options{.solver = GetParam()};
  options.motors_keep_limits = false;
  world.addMechanism(m, Transform::Identity(), options);
  world.setJointEffort(0, 0, 2.0);
  double farthest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    world.step(kStep);
    farthest = std::max(farthest, world.q(0)[0]);
  }
  EXPECT_GT(farthest, 10.0);
  EXPECT_LT(farthest, 10.0 + 0.03);
  EXPECT_NEAR(world.q(0)[0], 10.0, 1e-3);
}

TEST_P(PhysicsMechanism, DampingMatchesClosedForm) {
  // qd decays by 1 / (1 + h d / I) each step, however large the damping is.
  for (const auto type : {mechanism::JointType::kRevolute, mechanism::JointType::kPrismatic})
    for (const double damping : {0.5, 1e4}) {
      SCOPED_TRACE(damping);
      PhysicsWorld world({.gravity_W = Vector3d::Zero()});
      MechanismOptions options{.solver = GetParam()};
      options.damping = {damping};
      world.addMechanism(single(type), Transform::Identity(), options);
      world.mechanism(0).setState(std::vector{0.0}, std::vector{1.0});
      double expected = 1.0;
      for (int i = 0; i < 20; ++i) {
        world.step(kStep);
        expected /= 1.0 + kStep * damping / inertia(type);
        ASSERT_NEAR(world.qd(0)[0], expected, 1e-12);
      }
    }
}

TEST_P(PhysicsMechanism, MotorsKeepSpeedWithinEffort) {
  for (const auto type : {mechanism::JointType::kRevolute, mechanism::JointType::kPrismatic}) {
    PhysicsWorld world({.gravity_W = Vector3d::Zero()});
    world.addMechanism(single(type), Transform::Identity(), {.solver = GetParam()});
    world.setMotor(0, 0, 0.3, 5.0);
    const double a = 5.0 / inertia(type);
    world.step(kStep);
    EXPECT_NEAR(world.qd(0)[0], std::min(0.3, a * kStep), 1e-12);
    for (int i = 0; i < 500; ++i) world.step(kStep);
    EXPECT_NEAR(world.qd(0)[0], 0.3, 1e-12);
    // Less than its most does not move it, more does by the rest.
    world.setJointEffort(0, 0, -4.9);
    world.step(kStep);
    EXPECT_NEAR(world.qd(0)[0], 0.3, 1e-12);
    world.setJointEffort(0, 0, -6.0);
    world.step(kStep);
    EXPECT_NEAR(world.qd(0)[0], 0.3 - kStep * 1.0 / inertia(type), 1e-12);
    // Switched off, it coasts.
    world.setJointEffort(0, 0, 0.0);
    world.setMotor(0, 0, 0.0, 0.0);
    const double before = world.qd(0)[0];
    world.step(kStep);
    EXPECT_NEAR(world.qd(0)[0], before, 1e-12);
  }
}

TEST_P(PhysicsMechanism, EffortIsLimited) {
  PhysicsWorld world({.gravity_W = Vector3d::Zero()});
  world.addMechanism(single(mechanism::JointType::kRevolute), Transform::Identity(), {.solver = GetParam()});
  world.setJointEffort(0, 0, 1000.0);
  world.step(kStep);
  EXPECT_NEAR(world.qd(0)[0], kStep * 40.0 / kInertia, 1e-12);
}

TEST(MechanismSolvers, AgreeWithStopsMotorsAndDamping) {
  // From the same state, step by step: left alone, rounding grows at every stop that is reached.
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    mechanism::Mechanism m = seed == 0 ? sevenAxisArm() : randomRobot(seed, 8, false);
    for (auto& f : m.frames)
      f.limits = {f.offset - 0.4, f.offset + 0.5, kInfinity, seed % 2 == 0 ? 20.0 : kInfinity};
    PhysicsWorld world;
    MechanismOptions options;
    options.damping.assign(static_cast<std::size_t>(m.dof), 2.0);
    options.damping[0] = 0.0;
    for (const auto solver : {MechanismSolver::kJointed, MechanismSolver::kReduced}) {
      options.solver = solver;
      const int robot = world.addMechanism(m, randomPose(seed), options);
      world.mechanism(robot).setState(randomValues(m.dof, seed, 0, 0.3), randomValues(m.dof, seed, 100, 1.0));
      for (int k = 0; k < m.dof; k += 2) world.setMotor(robot, k, k % 4 == 0 ? 0.3 : 0.0, 3.0);
      world.setJointEffort(robot, 1, 15.0);
    }
    int at_stops = 0;
    for (int i = 0; i < 1000; ++i) {
      world.step(kStep);
      double size = 1.0;
      for (const double v : world.qd(0)) size = std::max(size, std::abs(v));
      for (std::size_t k = 0; k < world.q(0).size(); ++k) {
        ASSERT_NEAR(world.qd(0)[k], world.qd(1)[k], kSame * size) << i << " " << k;
        at_stops += world.q(0)[k] <= -0.4 || world.q(0)[k] >= 0.5;
      }
      world.mechanism(1).setState(world.q(0), world.qd(0));
    }
    EXPECT_GT(at_stops, 100);
  }
}

TEST(ReducedMechanisms, BrakeMimicJoints) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    const mechanism::Mechanism m = randomRobot(seed, 10, true);
    PhysicsWorld world;
    const int robot = world.addMechanism(m, Transform::Identity(), {.solver = MechanismSolver::kReduced});
    const auto q = randomValues(m.dof, seed, 0, 2.0), qd = randomValues(m.dof, seed, 100, 2.0);
    world.mechanism(robot).setState(q, qd);
    for (int k = 0; k < m.dof; ++k) world.setMotor(robot, k, 0.0, 1e8);
    world.step(kStep);
    for (const double rate : world.qd(robot)) EXPECT_NEAR(rate, 0.0, 1e-6);
  }
}

TEST(ReducedMechanisms, LeaveStopsOfMimicJoints) {
  mechanism::Mechanism m = single(mechanism::JointType::kRevolute);
  m.frames.push_back(
      jointFrame(2, 0, mechanism::JointType::kRevolute, Vector3d::UnitY(), Vector3d(0, 0, -0.4), 0));
  m.frames[1].inertia = m.frames[0].inertia;
  m.frames[1].limits = m.frames[0].limits;
  m.frames[1].mimic = true;
  m.prepare();
  PhysicsWorld world;
  const int robot = world.addMechanism(m, Transform::Identity(), {.solver = MechanismSolver::kReduced});
  world.mechanism(robot).setState(std::vector<double>{0.6}, std::vector<double>{3.0});
  for (int k = 0; k < 3000; ++k) world.step(kStep);
  // Gravity takes it away from the stop.
  EXPECT_LT(std::abs(world.q(robot)[0]), 0.5 + 1e-6);
}

TEST_P(PhysicsMechanism, AllocatesNothingInSteadyState) {
  PhysicsWorld world;
  mechanism::Mechanism m = randomRobot(2, 12, true);
  for (auto& f : m.frames) f.limits = {-0.4, 0.5, kInfinity, kInfinity};
  MechanismOptions options{.solver = GetParam()};
  options.gravity_compensation = true;
  options.damping.assign(static_cast<std::size_t>(m.dof), 0.1);
  world.addMechanism(m, Transform::Identity(), options);
  world.setMotor(0, 0, 0.1, 1.0);
  const int frame = static_cast<int>(m.frames.size()) - 1;
  const auto cycle = [&] {
    const Contact contact{Vector3d(0, 0, 1), Vector3d(0.1, 0, 0), world.pose({0, frame}).translation(),
                          Vector3d::Zero()};
    world.applyContact({0, frame}, {}, contact, {}, kStep);
    world.step(kStep);
  };
  for (int i = 0; i < 3; ++i) cycle();
  const testing::NoAlloc guard;
  for (int i = 0; i < 300; ++i) cycle();
  EXPECT_EQ(guard.count(), 0);
}

std::string refusal(const mechanism::Mechanism& m, MechanismOptions options) {
  PhysicsWorld world;
  try {
    world.addMechanism(m, Transform::Identity(), options);
  } catch (const ParseError& e) {
    return e.what();
  } catch (const UsageError& e) {
    return e.what();
  }
  return "taken";
}

TEST(MechanismErrors, NameLinkAndRemedyForMissingMass) {
  using ::testing::HasSubstr;
  constexpr auto kReduced = MechanismSolver::kReduced;
  mechanism::Mechanism m = single(mechanism::JointType::kRevolute);
  m.frames[0].name = "upper_arm";
  EXPECT_EQ(refusal(m, {}), "taken");
  m.frames[0].inertia = {};
  EXPECT_THAT(refusal(m, {}), HasSubstr("single: error: what moves with frame 'upper_arm': found no mass"));
  EXPECT_THAT(refusal(m, {}), HasSubstr("hint: give the link an inertia in its file, or its mesh a density"));
  EXPECT_THAT(refusal(m, {.solver = kReduced}), HasSubstr("'upper_arm' moves no mass"));
  // A point mass turns about a point elsewhere: no body for ODE, but one for joint coordinates.
  m.frames[0].inertia = pointMass(1.0, {0, 0, -1});
  EXPECT_THAT(refusal(m, {}), HasSubstr("a body without extent"));
  EXPECT_EQ(refusal(m, {.solver = kReduced}), "taken");
  m.frames[0].inertia.mass = kNaN;
  EXPECT_THAT(refusal(m, {}), HasSubstr("frame 'upper_arm': found mass nan"));
  m = single(mechanism::JointType::kRevolute);
  MechanismOptions bad;
  bad.damping = {1.0, 2.0};
  EXPECT_THAT(refusal(m, bad), HasSubstr("damping: found 2 values, expected 1"));
  bad.damping = {-1.0};
  EXPECT_THAT(refusal(m, bad), HasSubstr("0 or more"));
}

TEST(MechanismBodies, MasslessFixedFramesJoinParentBody) {
  // The same arm with its tool as a frame of its own: the same motion.
  mechanism::Mechanism whole = single(mechanism::JointType::kRevolute), parts = whole;
  mechanism::MechanismFrame tool =
      jointFrame(2, 0, mechanism::JointType::kFixed, Vector3d::UnitZ(), {0.1, 0, -0.4}, -1);
  tool.inertia = boxMass(0.5, {0.1, 0.1, 0.1}, {0, 0, 0});
  parts.frames.push_back(tool);
  parts.frames.push_back(jointFrame(3, 1, mechanism::JointType::kFixed, Vector3d::UnitZ(), {0, 0, 0.1}, -1));
  parts.prepare();
  const mechanism::LinkInertia &a = whole.frames[0].inertia,
                               b = boxMass(0.5, {0.1, 0.1, 0.1}, {0.1, 0, -0.4});
  const double mass = a.mass + b.mass;
  mechanism::LinkInertia sum{mass, (a.mass * a.com_F + b.mass * b.com_F) / mass, a.inertia_F + b.inertia_F};
  for (const auto* part : {&a, &b}) {
    const Vector3d r = part->com_F - sum.com_F;
    sum.inertia_F += part->mass * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
  }
  whole.frames[0].inertia = sum;
  PhysicsWorld world;
  world.addMechanism(whole, Transform::Identity());
  world.addMechanism(parts, Transform::Identity());
  world.applyWrench({1, 2}, {Vector3d(0, 0, 7), Vector3d::Zero()}, Vector3d(0.1, 0, -0.3));
  world.applyWrench({0, 0}, {Vector3d(0, 0, 7), Vector3d::Zero()}, Vector3d(0.1, 0, -0.3));
  for (int i = 0; i < 100; ++i) world.step(kStep);
  EXPECT_NEAR(world.q(0)[0], world.q(1)[0], 1e-13);
  EXPECT_TRUE(
      world.pose({1, 2}).isApprox(world.pose({1, 0}) * Transform(Eigen::Translation3d(0.1, 0, -0.3)), 1e-13));
}

}  // namespace mechanism_test
}  // namespace abstand::physics
