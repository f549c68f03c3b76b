// Joints that are pushed keep to what the robot's file allows.
#include <gtest/gtest.h>

#include <cmath>

#include "core/mechanism/joint_limit_watch.hpp"
#include "core/physics/physics_world.hpp"
#include "core/robot_file/mech_file.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/robots.hpp"

namespace abstand::physics {
namespace joint_limits_test {

using namespace testing;

constexpr double kStep = 0.001;  // s

class JointLimitsIn : public ::testing::TestWithParam<MechanismSolver> {};
INSTANTIATE_TEST_SUITE_P(Solvers, JointLimitsIn,
                         ::testing::Values(MechanismSolver::kJointed, MechanismSolver::kReduced),
                         [](const auto& solver) {
                           return solver.param == MechanismSolver::kJointed ? "Jointed" : "Reduced";
                         });

mechanism::Mechanism lwr() { return robot_file::loadMechanism(projectFile("data/robots/lwr/lwr4.mech")); }

std::string list(const std::vector<mechanism::LimitBreach>& breaches) {
  std::string text;
  for (const mechanism::LimitBreach& b : breaches)
    text += "dof " + std::to_string(b.dof) + " " + std::string(mechanism::limitName(b.kind)) + " " +
            std::to_string(b.value) + " limit " + std::to_string(b.limit) + " at " + std::to_string(b.t) +
            " s, " + std::to_string(b.count) + " times\n";
  return text;
}

TEST_P(JointLimitsIn, HoldForAnyMotorCommand) {
  // Efforts up to five times the limits, changed every 50 ms, drive the arm about its whole range.
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const mechanism::Mechanism m = lwr();
    PhysicsWorld world;
    world.addMechanism(m, Transform::Identity(), {.solver = GetParam()});
    world.mechanism(0).setState(randomValues(7, seed, 0, 1.5), std::vector(7, 0.0));
    mechanism::JointLimitWatch watch(mechanism::dofLimits(m));
    std::vector<double> efforts(7), least(7, kInfinity), most(7, 0.0);
    for (int i = 0; i < 2000; ++i) {
      if (i % 50 == 0) efforts = randomValues(7, seed, 1000 + static_cast<std::uint64_t>(i), 5.0);
      for (int k = 0; k < 7; ++k)
        world.setJointEffort(
            0, k, efforts[static_cast<std::size_t>(k)] * watch.limits()[static_cast<std::size_t>(k)].effort);
      world.step(kStep);
      watch.check(kStep * (i + 1), world.q(0), world.qd(0), {}, world.mechanism(0).appliedEfforts());
      for (std::size_t k = 0; k < 7; ++k) most[k] = std::max(most[k], std::abs(world.qd(0)[k]));
    }
    EXPECT_TRUE(watch.kept()) << list(watch.breaches());
    for (std::size_t k = 0; k < 7; ++k) EXPECT_GT(most[k], 0.9 * watch.limits()[k].velocity) << k;
  }
}

TEST_P(JointLimitsIn, HoldWhileHandIsPushed) {
  // 20 N on the hand, that the motors can hold against; they are told to do nothing but to carry gravity.
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const mechanism::Mechanism m = lwr();
    PhysicsWorld world;
    world.addMechanism(m, Transform::Identity(), {.solver = GetParam(), .gravity_compensation = true});
    world.mechanism(0).setState(randomValues(7, seed, 0, 1.0), std::vector(7, 0.0));
    mechanism::JointLimitWatch watch(mechanism::dofLimits(m));
    Vector3d push = Vector3d::Zero();
    for (int i = 0; i < 2000; ++i) {
      if (i % 100 == 0) push = 20.0 * randomPose(seed + 10 * static_cast<std::uint64_t>(i)).linear().col(0);
      world.applyWrench({0, 6}, {push, Vector3d::Zero()}, world.pose({0, 6}).translation());
      world.step(kStep);
      watch.check(kStep * (i + 1), world.q(0), world.qd(0), {}, world.mechanism(0).appliedEfforts());
    }
    EXPECT_TRUE(watch.kept()) << list(watch.breaches());
  }
}

TEST_P(JointLimitsIn, YieldToForcesBeyondMotors) {
  // 3 kN on the hand: no motor can hold the velocity, so it is broken, and efforts are not.
  const mechanism::Mechanism m = lwr();
  PhysicsWorld world;
  world.addMechanism(m, Transform::Identity(), {.solver = GetParam()});
  world.mechanism(0).setState(std::vector{0.0, 0.5, 0.0, -1.2, 0.0, 0.8, 0.0}, std::vector(7, 0.0));
  mechanism::JointLimitWatch watch(mechanism::dofLimits(m));
  for (int i = 0; i < 20; ++i) {
    world.applyWrench({0, 6}, {Vector3d(0, 3000, 0), Vector3d::Zero()}, world.pose({0, 6}).translation());
    world.step(kStep);
    watch.check(kStep * (i + 1), {}, world.qd(0), {}, world.mechanism(0).appliedEfforts());
  }
  ASSERT_FALSE(watch.kept());
  for (const mechanism::LimitBreach& b : watch.breaches())
    EXPECT_EQ(b.kind, mechanism::LimitKind::kVelocity) << list({b});
}

TEST_P(JointLimitsIn, DoNotAffectMotionWithinLimits) {
  // Far from its limits an arm moves with and without them alike.
  const mechanism::Mechanism m = lwr();
  PhysicsWorld with, without;
  with.addMechanism(m, Transform::Identity(), {.solver = GetParam(), .gravity_compensation = true});
  MechanismOptions options{.solver = GetParam(), .gravity_compensation = true};
  options.motors_keep_limits = false;
  without.addMechanism(m, Transform::Identity(), options);
  for (int i = 0; i < 300; ++i) {
    for (int k = 0; k < 7; ++k) {
      with.setJointEffort(0, k, 0.001 * (k % 3 - 1));
      without.setJointEffort(0, k, 0.001 * (k % 3 - 1));
    }
    with.step(kStep);
    without.step(kStep);
  }
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_EQ(with.q(0)[k], without.q(0)[k]) << k;
    EXPECT_EQ(with.qd(0)[k], without.qd(0)[k]) << k;
  }
}

TEST_P(JointLimitsIn, HoldForAccelerations) {
  mechanism::Mechanism m = lwr();
  for (auto& f : m.frames) f.limits.acceleration = 3.0;
  PhysicsWorld world;
  world.addMechanism(m, Transform::Identity(), {.solver = GetParam(), .gravity_compensation = true});
  mechanism::JointLimitWatch watch(mechanism::dofLimits(m));
  std::vector<double> before(7, 0.0), qdd(7);
  for (int i = 0; i < 2000; ++i) {
    for (int k = 0; k < 7; ++k) world.setJointEffort(0, k, (i / 400) % 2 == 0 ? 5.0 : -5.0);
    world.step(kStep);
    for (std::size_t k = 0; k < 7; ++k) {
      qdd[k] = (world.qd(0)[k] - before[k]) / kStep;
      before[k] = world.qd(0)[k];
    }
    watch.check(kStep * (i + 1), world.q(0), world.qd(0), qdd, world.mechanism(0).appliedEfforts());
  }
  EXPECT_TRUE(watch.kept()) << list(watch.breaches());
}

TEST(JointLimiter, AllocatesNothing) {
  const mechanism::Mechanism m = lwr();
  PhysicsWorld world;
  world.addMechanism(m, Transform::Identity(), {.solver = MechanismSolver::kReduced});
  const auto push = [&] {
    for (int k = 0; k < 7; ++k) world.setJointEffort(0, k, 1000.0);
    world.step(kStep);
  };
  for (int i = 0; i < 100; ++i) push();
  const NoAlloc guard;
  for (int i = 0; i < 400; ++i) push();
  EXPECT_EQ(guard.count(), 0);
}

TEST(VelocityBounds, StopBeforePositionLimit) {
  // A joint that always goes as fast as it may comes to rest at its limit, never beyond, and never slows down
  // harder than it can.
  for (const double braking : {0.5, 5.0, 500.0}) {
    mechanism::DofLimits limits{-1.0, 1.0, 2.0, kInfinity, kInfinity};
    double q = 0.3, qd = 0.0;
    for (int i = 0; i < 200000 && q < 1.0 - 1e-6; ++i) {
      const double next = mechanism::velocityBounds(limits, q, qd, braking, kStep).upper;
      EXPECT_LE(next, 2.0);
      EXPECT_GE(next, qd - kStep * braking * (1.0 + 1e-9));
      qd = next;
      q += kStep * qd;
      ASSERT_LE(q, 1.0);
    }
    EXPECT_GT(q, 1.0 - 1e-3);
    EXPECT_LT(qd, 0.05);
  }
}

TEST(VelocityBounds, LeadBackFromBeyondLimit) {
  const mechanism::DofLimits limits{-1.0, 1.0, 2.0, kInfinity, kInfinity};
  const mechanism::VelocityBounds above = mechanism::velocityBounds(limits, 1.2, 0.5, 10.0, kStep);
  EXPECT_EQ(above.upper, 0.0);
  EXPECT_EQ(above.lower, -2.0);
  const mechanism::VelocityBounds below = mechanism::velocityBounds(limits, -1.0, 0.0, kInfinity, kStep);
  EXPECT_EQ(below.lower, 0.0);
  EXPECT_EQ(below.upper, 2.0);
}

}  // namespace joint_limits_test
}  // namespace abstand::physics
