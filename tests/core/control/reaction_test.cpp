// The pipeline: laws add up, causes stop, nothing is allocated.
#include "core/control/reaction.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/error.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::control {
namespace reaction_test {

constexpr double kExact = 1e-12;
const Eigen::MatrixXd kNoMass;

/// Two joints; one cycle's input, to be changed by the tests.
struct Cycle {
  std::vector<double> qd{0.1, 0.2}, planned{0.5, 0.0}, efforts{0.0, 0.0}, row{1.0, 0.5};
  std::vector<ReactionPair> pairs;
  std::vector<safety::StopCause> causes;
  ReactionInput in;
  Cycle() { in.dt = 1e-3; }
  const ReactionInput& at(double t) {
    in.t = t;
    in.qd = qd;
    in.planned = planned;
    in.efforts = efforts;
    in.pairs = pairs;
    in.causes = causes;
    return in;
  }
  void add(double distance, bool person = false, double other_rate = 0.0) {
    pairs.push_back(
        {.pair = 7, .distance = distance, .row = row, .other_rate = other_rate, .person = person});
  }
};

TEST(Reaction, DoesNothingWithoutLaws) {
  Reaction reaction({}, 2, 4);
  Cycle c;
  c.efforts = {100.0, 100.0};
  c.add(0.01, true);
  const ReactionOutput out = reaction.update(c.at(0.0), kNoMass);
  EXPECT_EQ(out.torque[0], 0.0);
  EXPECT_TRUE(out.velocity.empty());
  EXPECT_EQ(out.speed_scale, 1.0);
  EXPECT_EQ(out.state, safety::StopState::kRunning);
  EXPECT_FALSE(out.brakes);
}

TEST(Reaction, AddsContactAndRepulsionAndLimitsSum) {
  ReactionDescription d;
  d.torque = TorqueLimitOptions{.gain = 2.0, .limit = {30.0}, .cut = TorqueCut::kEach};
  d.repulsion = RepulsionOptions{.range = 0.1, .force = 40.0, .damping = 0.0, .stop_share = 1.0};
  Reaction reaction(d, 2, 4);
  Cycle c;
  c.efforts = {1.0, -3.0};
  c.add(0.05);
  const ReactionOutput out = reaction.update(c.at(0.0), kNoMass);
  // 10 N at half the range, by the row (1, 0.5).
  EXPECT_NEAR(out.torque[0], 12.0, kExact);
  EXPECT_NEAR(out.torque[1], -1.0, kExact);
  c.efforts = {100.0, 0.0};
  EXPECT_EQ(reaction.update(c.at(0.001), kNoMass).torque[0], 30.0);
  EXPECT_EQ(reaction.withoutMass(), 2);
  EXPECT_EQ(reaction.update(c.at(0.002), kNoMass).state, safety::StopState::kRunning)
      << "a limit alone is no stop";
}

TEST(Reaction, DampsWithMassMatrix) {
  ReactionDescription d;
  d.repulsion = RepulsionOptions{.range = 0.1, .force = 40.0, .damping = 1.0};
  Reaction reaction(d, 2, 4);
  Cycle c;
  c.qd = {-0.1, 0.0};
  c.add(0.05);
  const Eigen::MatrixXd M = Eigen::Vector2d(2.0, 4.0).asDiagonal();
  // 1 / m = 1 / 2 + 0.25 / 4; K = 400; rate -0.1.
  const double m = 1.0 / (0.5 + 0.0625);
  const double f = 10.0 + 0.1 * 2.0 * std::sqrt(400.0 * m);
  EXPECT_NEAR(reaction.update(c.at(0.0), M).torque[0], f, 1e-9);
  EXPECT_EQ(reaction.withoutMass(), 0);
  // A fist that comes is felt as well.
  c.qd = {0.0, 0.0};
  c.pairs[0].other_rate = -0.1;
  EXPECT_NEAR(reaction.update(c.at(0.1), M).torque[0], f, 1e-9);
  c.pairs[0].other_rate = kNaN;
  EXPECT_NEAR(reaction.update(c.at(0.2), M).torque[0], 10.0, 1e-9);
}

TEST(Reaction, ExcessEnergyIsEmergencyStop) {
  ReactionDescription d;
  d.repulsion = RepulsionOptions{.range = 0.1, .force = 40.0, .mass = 5.0};
  d.admittance = AdmittanceOptions{};
  Reaction reaction(d, 2, 4);
  Cycle c;
  c.qd = {-5.0, 0.0};
  c.add(0.09);
  ReactionOutput out = reaction.update(c.at(0.0), kNoMass);
  EXPECT_EQ(out.state, safety::StopState::kEmergencyStop);
  EXPECT_TRUE(out.brakes);
  EXPECT_EQ(out.torque[0], 0.0);
  EXPECT_EQ(out.velocity[0], 0.0);
  EXPECT_EQ(out.speed_scale, 0.0);
  EXPECT_EQ(reaction.stops().cause().reason, safety::StopReason::kEnergy);
  EXPECT_EQ(reaction.stops().cause().pair, 7);
  EXPECT_NEAR(reaction.stops().cause().value, 0.5 * 5.0 * 25.0, kExact);
  // The brakes stay on until somebody lets it go on.
  c.qd = {0.0, 0.0};
  out = reaction.update(c.at(0.5), kNoMass);
  EXPECT_EQ(out.state, safety::StopState::kWaitingForReset);
  EXPECT_TRUE(out.brakes);
  c.in.reset = true;
  out = reaction.update(c.at(1.0), kNoMass);
  EXPECT_EQ(out.state, safety::StopState::kRunning);
  EXPECT_FALSE(out.brakes);
}

TEST(Reaction, ScalesSpeedByPeopleOnly) {
  ReactionDescription d;
  d.speed = SpeedScaleOptions{};
  Reaction reaction(d, 2, 4);
  Cycle c;
  c.planned = {-1.0, 0.0};
  c.add(0.0);
  EXPECT_EQ(reaction.update(c.at(0.0), kNoMass).speed_scale, 1.0) << "a table";
  // S_p = 1.6 * 0.4 + 0.25 v: at 0.765 m, 0.5 m/s.
  c.add(0.765, true, kNaN);
  ReactionOutput out = reaction.update(c.at(0.001), kNoMass);
  EXPECT_NEAR(out.speed_scale, 0.5, 1e-9);
  EXPECT_EQ(out.state, safety::StopState::kSlowing);
  EXPECT_EQ(reaction.stops().cause().reason, safety::StopReason::kSeparation);
  // Another point of the link comes twice as fast.
  c.pairs[1].spread = 1.0;
  EXPECT_NEAR(reaction.update(c.at(0.002), kNoMass).speed_scale, 0.25, 1e-9);
  // Too near: a protective stop for want of distance, that goes on yielding.
  c.pairs[1].distance = 0.5;
  out = reaction.update(c.at(0.003), kNoMass);
  EXPECT_EQ(out.speed_scale, 0.0);
  EXPECT_EQ(out.state, safety::StopState::kProtectiveStop);
  EXPECT_FALSE(out.brakes);
  EXPECT_EQ(reaction.stops().cause().reason, safety::StopReason::kDistance);
  EXPECT_NEAR(reaction.stops().cause().limit, 0.64 + 0.25 * 2.0 * 0.02, 1e-9);
}

TEST(Reaction, ResumesSlowlyAfterStop) {
  ReactionDescription d;
  d.speed = SpeedScaleOptions{};
  d.stop.resume_after = 0.2;
  Reaction reaction(d, 2, 4);
  Cycle c;
  c.planned = {-1.0, 0.0};
  c.qd = {0.0, 0.0};
  c.add(0.3, true, kNaN);
  EXPECT_EQ(reaction.update(c.at(0.0), kNoMass).state, safety::StopState::kProtectiveStop);
  c.pairs.clear();
  EXPECT_EQ(reaction.update(c.at(0.1), kNoMass).speed_scale, 0.0);
  reaction.update(c.at(0.25), kNoMass);
  const ReactionOutput out = reaction.update(c.at(0.251), kNoMass);
  EXPECT_EQ(out.state, safety::StopState::kRunning);
  EXPECT_GT(out.speed_scale, 0.0);
  EXPECT_LT(out.speed_scale, 0.1) << "not at full speed at once";
}

TEST(Reaction, WatchesAgesDistancesAndSpeeds) {
  struct Case {
    const char* name;
    safety::StopReason reason;
    void (*change)(Cycle&);
  };
  for (const Case& k : {
           Case{"stale", safety::StopReason::kStaleInput, [](Cycle& c) { c.in.input_age = 0.11; }},
           Case{"no age", safety::StopReason::kStaleInput, [](Cycle& c) { c.in.input_age = kNaN; }},
           Case{"lost", safety::StopReason::kLostPerson, [](Cycle& c) { c.in.person_age = kInfinity; }},
           Case{"near", safety::StopReason::kDistance, [](Cycle& c) { c.add(0.019); }},
           Case{"unknown distance", safety::StopReason::kDistance, [](Cycle& c) { c.add(kNaN); }},
           Case{"fast", safety::StopReason::kJointSpeed,
                [](Cycle& c) {
                  c.qd = {0.1, -2.1};
                }},
           Case{"unknown speed", safety::StopReason::kJointSpeed,
                [](Cycle& c) {
                  c.qd = {kNaN, 0.0};
                }},
           Case{"link", safety::StopReason::kLostLink,
                [](Cycle& c) { c.causes = {{safety::StopReason::kLostLink}}; }},
           Case{"bound", safety::StopReason::kSpeedBound,
                [](Cycle& c) { c.causes = {{safety::StopReason::kSpeedBound}}; }},
       }) {
    ReactionDescription d;
    d.watch.distance = 0.02;
    d.watch.joint_speed = {2.0};
    Reaction reaction(d, 2, 4);
    Cycle c;
    c.add(0.021);
    EXPECT_EQ(reaction.update(c.at(0.0), kNoMass).state, safety::StopState::kRunning);
    k.change(c);
    const ReactionOutput out = reaction.update(c.at(0.001), kNoMass);
    EXPECT_EQ(out.state, safety::StopState::kProtectiveStop) << k.name;
    EXPECT_EQ(reaction.stops().cause().reason, k.reason) << k.name;
    EXPECT_EQ(out.speed_scale, 0.0);
  }
}

TEST(Reaction, PoseUncertaintyCountsForStopsAndSpeedOnly) {
  ReactionDescription d;
  d.repulsion = RepulsionOptions{.range = 1.0, .force = 40.0, .damping = 0.0};
  d.speed = SpeedScaleOptions{};
  d.watch.distance = 0.02;
  Reaction exact(d, 2, 4), uncertain(d, 2, 4), unknown(d, 2, 4);
  Cycle c;
  c.planned = {-1.0, 0.0};
  c.add(0.765, true, kNaN);
  const ReactionOutput shown = exact.update(c.at(0.0), kNoMass);
  EXPECT_EQ(shown.state, safety::StopState::kSlowing);
  c.pairs[0].distance = 1.065;
  c.pairs[0].uncertainty = 0.3;
  EXPECT_NEAR(uncertain.update(c.at(0.0), kNoMass).speed_scale, shown.speed_scale, kExact);
  EXPECT_EQ(uncertain.stops().state(), safety::StopState::kSlowing);
  // The potential acts on the bodies as shown: at the edge of its range it is 0.
  EXPECT_EQ(uncertain.update(c.at(0.001), kNoMass).torque[0], 0.0);
  c.pairs[0].uncertainty = 1.05;
  EXPECT_EQ(uncertain.update(c.at(0.002), kNoMass).state, safety::StopState::kProtectiveStop);
  EXPECT_NEAR(uncertain.stops().cause().value, 0.015, kExact);
  EXPECT_EQ(uncertain.stops().cause().reason, safety::StopReason::kDistance);
  // A part that was never seen may be anywhere.
  c.pairs[0].uncertainty = kInfinity;
  EXPECT_EQ(unknown.update(c.at(0.0), kNoMass).state, safety::StopState::kProtectiveStop);
}

TEST(Reaction, SlowResponseHasDefaultSpeed) {
  ReactionDescription d;
  d.stop.policy.response[static_cast<std::size_t>(safety::StopReason::kLostPerson)] =
      safety::StopResponse::kSlow;
  d.stop.slow_to = 0.3;
  Reaction reaction(d, 2, 4);
  Cycle c;
  c.in.person_age = 1.0;
  const ReactionOutput out = reaction.update(c.at(0.0), kNoMass);
  EXPECT_EQ(out.state, safety::StopState::kSlowing);
  EXPECT_EQ(out.speed_scale, 0.3);
}

TEST(Reaction, ConvertsTorquesToMotion) {
  ReactionDescription d;
  d.torque = TorqueLimitOptions{};
  d.admittance = AdmittanceOptions{.inertia = {0.5}, .damping = {8.0}, .stiffness = {20.0, 0.0}};
  Reaction reaction(d, 2, 4);
  Cycle c;
  c.efforts = {4.0, 4.0};
  ReactionOutput out;
  for (int i = 0; i < 5000; ++i) out = reaction.update(c.at(0.001 * i), kNoMass);
  EXPECT_NEAR(out.offset[0], 0.2, 1e-5);
  EXPECT_EQ(out.offset[1], 0.5) << "its limit";
}

TEST(Reaction, HoldsObject) {
  ReactionDescription d;
  d.proxy = GodObjectOptions{.gap = 0.0};
  Reaction reaction(d, 2, 4);
  EXPECT_EQ(reaction.proxy(), nullptr);
  reaction.hold({Vector3d::Zero(), 0.05}, Transform::Identity());
  ASSERT_NE(reaction.proxy(), nullptr);
  Cycle c;
  const ContactConstraint ground{Vector3d::Zero(), Vector3d::UnitZ(), 0.0};
  const HeldObject held{Transform(Eigen::Translation3d(0, 0, -0.01)), {&ground, 1}};
  c.in.held = &held;
  reaction.update(c.at(0.0), kNoMass);
  EXPECT_NEAR(reaction.proxy()->wrench().force.z(), 10.0, 1e-9);
  Reaction none({}, 2, 4);
  none.hold({Vector3d::Zero(), 0.05}, Transform::Identity());
  EXPECT_EQ(none.proxy(), nullptr) << "not among its laws";
}

TEST(Reaction, AllocatesNothing) {
  ReactionDescription d;
  d.torque = TorqueLimitOptions{.limit = {20.0}};
  d.repulsion = RepulsionOptions{};
  d.admittance = AdmittanceOptions{};
  d.speed = SpeedScaleOptions{};
  d.proxy = GodObjectOptions{};
  Reaction reaction(d, 2, 300);
  reaction.hold({Vector3d::Zero(), 0.05}, Transform::Identity());
  Cycle c;
  for (int i = 0; i < 300; ++i) c.add(0.01 * i, i % 2);
  c.causes.assign(Reaction::kMaxCauses, {safety::StopReason::kSpeedBound});
  c.qd = {-5.0, 9.0};
  c.in.input_age = c.in.person_age = 9.0;
  const HeldObject held;
  c.in.held = &held;
  const Eigen::MatrixXd M = Eigen::MatrixXd::Identity(2, 2);
  const testing::NoAlloc guard;
  for (int i = 0; i < 100; ++i) reaction.update(c.at(0.001 * i), M);
  EXPECT_EQ(guard.count(), 0);
}

TEST(Reaction, RejectsOptionsOfWrongJointCount) {
  ReactionDescription d;
  d.torque = TorqueLimitOptions{.limit = {1.0, 2.0, 3.0}};
  EXPECT_THROW(Reaction(d, 2, 4), UsageError);
  EXPECT_NO_THROW(Reaction(d, 3, 4));
  d = {};
  d.watch.joint_speed = {0.0};
  EXPECT_THROW(Reaction(d, 2, 4), UsageError);
  d = {};
  d.proxy = GodObjectOptions{.step = -1.0};
  EXPECT_THROW(Reaction(d, 2, 4), UsageError);
  d = {};
  d.stop.resume_after = -1.0;
  EXPECT_THROW(Reaction(d, 2, 4), UsageError);
}

}  // namespace reaction_test
}  // namespace abstand::control
