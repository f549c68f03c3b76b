// Laws of a robot that are changed while it plays, and pokes.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "core/control/reaction_change.hpp"
#include "tests/app/loop/manual_clock.hpp"
#include "tests/app/loop/watched_session.hpp"

namespace abstand::loop {
namespace live_laws_test {

using testing::SlideScene;
using testing::thingComesTo;

struct Laws : testing::WatchedSession {
  explicit Laws(const std::string& reaction, double to = 0.05, const std::string& more = "")
      : WatchedSession(reaction, more, to) {}

  bool stepTo(double t) {
    live.send(command::Step{static_cast<int>(std::lround((t - seen.t) * 1e3))});
    return waitForTime(t);
  }
  void change(const control::ReactionChange& change) {
    live.send(live.laws(0, control::changedReaction(live.outline().reactions[0], change, 1)));
  }
  void setNumber(const char* key, double value) {
    control::ReactionChange one;
    one.numbers[key] = {value};
    change(one);
  }
};

/// A slide that stays where it is, so that all distances stay: torques do not reach the motors, efforts stay.
constexpr const char* kGain = "{torque: {gain: 1}, hold: {frequency: 500}}";

TEST(LiveLaws, GainScalesTorqueInProportionAndOffIsZero) {
  Laws l(kGain, 0.09);
  ASSERT_TRUE(l.stepTo(1.5));
  double contact = l.seen.joint_torques[0].contact;
  ASSERT_LT(contact, -1.0) << "they touch";
  EXPECT_NEAR(l.seen.joint_torques[0].reaction, contact, 1e-12);
  for (const double gain : {3.0, 0.5, 0.0}) {
    l.setNumber("torque.gain", gain);
    ASSERT_TRUE(l.stepTo(l.seen.t + 0.001));
    contact = l.seen.joint_torques[0].contact;
    ASSERT_LT(contact, -1.0);
    EXPECT_NEAR(l.seen.joint_torques[0].reaction, gain * contact, 1e-12 * std::abs(contact)) << gain;
  }
  control::ReactionChange off;
  off.laws["torque"] = false;
  l.change(off);
  ASSERT_TRUE(l.stepTo(l.seen.t + 0.001));
  EXPECT_EQ(l.seen.joint_torques[0].reaction, 0.0);
  l.change({});
  ASSERT_TRUE(l.stepTo(l.seen.t + 0.001));
  EXPECT_EQ(l.seen.joint_torques[0].reaction, l.seen.joint_torques[0].contact) << "as in the scene again";
  EXPECT_EQ(l.seen.loop_start, 0.0) << "the same loop went on all the time";
}

TEST(LiveLaws, RepulsionIsSwitchedOnAndReachesFarther) {
  Laws l("{hold: {frequency: 500}}", 0.3);
  ASSERT_TRUE(l.stepTo(1.5));
  EXPECT_EQ(l.seen.joint_torques[0].reaction, 0.0);
  control::ReactionChange on;
  on.laws["repulsion"] = true;
  on.numbers["repulsion.range"] = {0.4};
  on.numbers["repulsion.force"] = {100.0};
  l.change(on);
  ASSERT_TRUE(l.stepTo(1.501));
  // F (d0 - d)^2 / d0^2 at rest, at the certified distance.
  const query::PairResult& r = l.seen.pairs[0].result;
  const double e = (0.4 - (r.distance - r.bound)) / 0.4;
  EXPECT_NEAR(l.seen.joint_torques[0].reaction, -100.0 * e * e, 0.01);
}

TEST(LiveLaws, StopSurvivesChangeUntilReset) {
  Laws l("{stop: {distance: 0.12, resume_after: 0.05}}", 0.15);
  ASSERT_TRUE(l.stepTo(1.5));
  ASSERT_EQ(l.seen.robots[0].state, safety::StopState::kProtectiveStop);
  const double since = l.seen.robots[0].since;
  l.setNumber("stop.distance", 0.01);
  ASSERT_TRUE(l.stepTo(2.0));
  EXPECT_EQ(l.seen.robots[0].state, safety::StopState::kWaitingForReset) << "its cause is gone, and it stays";
  EXPECT_EQ(l.seen.robots[0].log.entry(0).t, since);
  l.live.send(command::ResetStops{});
  ASSERT_TRUE(l.stepTo(2.001));
  EXPECT_EQ(l.seen.robots[0].state, safety::StopState::kRunning);
}

TEST(LiveLaws, StopConditionTakesEffectAtOnce) {
  Laws l("{}", 0.15);
  ASSERT_TRUE(l.stepTo(1.5));
  ASSERT_EQ(l.seen.robots[0].state, safety::StopState::kRunning);
  l.setNumber("stop.distance", 0.2);
  ASSERT_TRUE(l.stepTo(1.501));
  EXPECT_EQ(l.seen.robots[0].state, safety::StopState::kWaitingForReset) << "it stood already";
  EXPECT_EQ(l.seen.robots[0].cause.limit, 0.2);
  EXPECT_EQ(l.seen.robots[0].log.entry(0).to, safety::StopState::kProtectiveStop);
}

TEST(LiveLaws, ResponseTakesEffectAtOnce) {
  Laws l("{stop: {distance: 0.2, on: {distance: none}}}", 0.15);
  ASSERT_TRUE(l.stepTo(1.5));
  ASSERT_EQ(l.seen.robots[0].state, safety::StopState::kRunning) << "the scene does not stop for distances";
  control::ReactionChange emergency;
  emergency.responses["distance"] = safety::StopResponse::kEmergency;
  l.change(emergency);
  ASSERT_TRUE(l.stepTo(1.501));
  EXPECT_EQ(l.seen.robots[0].state, safety::StopState::kEmergencyStop);
  l.change({});
  ASSERT_TRUE(l.stepTo(2.0));
  EXPECT_EQ(l.seen.robots[0].state, safety::StopState::kWaitingForReset) << "it ends only by a reset";
}

TEST(LiveLaws, LawsOutliveSeekAndSwitchingReactionOff) {
  Laws l(kGain, 0.09);
  l.setNumber("torque.gain", 3.0);
  l.live.send(command::Seek{1.4});
  ASSERT_TRUE(l.waitFor([&] { return std::abs(l.seen.t - 1.4) < 1e-9; }));
  ASSERT_TRUE(l.stepTo(1.5));
  EXPECT_NEAR(l.seen.joint_torques[0].reaction, 3.0 * l.seen.joint_torques[0].contact, 1e-9);
  l.live.send(command::React{false});
  l.setNumber("torque.gain", 2.0);
  l.live.send(command::React{true});
  ASSERT_TRUE(l.stepTo(1.6));
  ASSERT_LT(l.seen.joint_torques[0].contact, -1.0);
  EXPECT_NEAR(l.seen.joint_torques[0].reaction, 2.0 * l.seen.joint_torques[0].contact, 1e-9);
}

TEST(LiveLaws, AdmittanceOnStartsRobotAnewAndDrivesItByPosition) {
  // A thing that pushes with f = -tau; the robot yields by x = tau / k and pushes back as it yields.
  Laws l("{torque: {gain: 1}, hold: {frequency: 500}}", 0.09);
  ASSERT_TRUE(l.stepTo(1.5));
  const double stiff = l.seen.joint_positions[0];
  ASSERT_LT(l.seen.joint_torques[0].contact, -1.0) << "they touch";
  EXPECT_EQ(l.seen.loop_start, 0.0);
  control::ReactionChange on;
  on.laws["admittance"] = true;
  on.numbers["admittance.inertia"] = {1.0};
  on.numbers["admittance.damping"] = {200.0};
  on.numbers["admittance.stiffness"] = {2000.0};
  on.numbers["admittance.offset"] = {1.0};
  l.change(on);
  ASSERT_TRUE(l.stepTo(1.501));
  EXPECT_EQ(l.seen.loop_start, 1.5) << "the loop began anew at the present time";
  ASSERT_TRUE(l.stepTo(2.5));
  // At rest x = tau / k, whatever the contact pushes with then.
  EXPECT_NEAR(l.seen.joint_positions[0], l.seen.joint_torques[0].reaction / 2000.0, 1e-4);
  EXPECT_LT(l.seen.joint_positions[0], stiff - 1e-4) << "it has yielded";
  on.numbers["admittance.stiffness"] = {8000.0};
  l.change(on);
  ASSERT_TRUE(l.stepTo(2.6));
  EXPECT_EQ(l.seen.loop_start, 1.5) << "a number is exchanged in the running loop";
  l.change({});
  ASSERT_TRUE(l.stepTo(2.61));
  EXPECT_EQ(l.seen.loop_start, 2.6) << "driven by torques again";
}

TEST(LiveLaws, BadLawsAreRefusedOnWindowsThread) {
  Laws l("{}");
  control::ReactionDescription bad = l.live.outline().reactions[0];
  EXPECT_THROW(l.live.laws(1, bad), UsageError);
  EXPECT_THROW(l.live.laws(-1, bad), UsageError);
  bad.proxy.emplace();
  EXPECT_THROW(l.live.laws(0, bad), UsageError) << "it holds nothing";
  bad = l.live.outline().reactions[0];
  bad.braking.emplace().path.deceleration = {1.0, 2.0};
  EXPECT_THROW(l.live.laws(0, bad), UsageError);
  bad.braking.reset();
  bad.torque = control::TorqueLimitOptions{.gain = -1.0};
  EXPECT_THROW(l.live.laws(0, bad), UsageError);
}

/// An arm of two links of 0.5 m in the plane x, y, at rest along x; the reaction passes contact efforts on.
struct PlanarArm {
  PlanarArm() {
    folder.write("arm.mech", R"(units
length m
angle degrees
end_units
mapping
dof 0 1
dof 1 2
end_mapping
chain
frame 1 0 0 0 theta
frame 2 0.5 0 0 theta
end_chain
limits
limit 1 -180 180 180 500
limit 2 -180 180 180 500
end_limits
inertia
body 1 2 0.25 0 0 0.02 0.02 0.02 0 0 0
body 2 2 0.25 0 0 0.02 0.02 0.02 0 0 0
end_inertia
)");
    scene_file::SceneDescription scene = scene_file::parseScene(
        "abstand: 1\n"
        "defaults: {voxel: 0.02, point: 0.02}\n"
        "mechanisms:\n"
        "  - name: arm\n"
        "    file: arm.mech\n"
        "    q: [0.3, 0.8]\n"
        "    base: {xyz: [0.1, 0.2, 0.3]}\n"
        "    reaction: {torque: {gain: 2}, hold: {frequency: 500}}\n"
        "    links: [{name: hand, frame: 2, shape: {sphere: {radius: 0.05}}}]\n"
        "objects:\n"
        "  - {name: thing, shape: {sphere: {radius: 0.05}}, pose: {xyz: [3, 0, 0]}}\n",
        folder.path() / "scene.yaml");
    session::SessionOptions options;
    options.threads = 1;
    options.cache = false;
    session = std::make_unique<session::Session>(std::move(scene), options);
  }

  testing::ScratchFolder folder;
  std::unique_ptr<session::Session> session;
};

/// J^T f of the point p (m) for two joints about z, the second 0.5 m from the first along its link.
std::array<double, 2> effortsOf(const Vector3d& base, double q0, const Vector3d& p, const Vector3d& f) {
  const Vector3d elbow = base + 0.5 * Vector3d(std::cos(q0), std::sin(q0), 0.0);
  return {(p - base).cross(f).z(), (p - elbow).cross(f).z()};
}

TEST(Poke, GivesJointEffortsOfForce) {
  PlanarArm arm;
  const Vector3d base(0.1, 0.2, 0.3);
  ClosedLoop loop(*arm.session, 0.0);
  for (int i = 0; i < 10; ++i) loop.step();
  const scene::Scene& scene = arm.session->scene();
  const ObjectId hand = ObjectId(0);
  const Vector3d p_B(0.02, 0.03, 0.01);
  for (const Vector3d& way : {Vector3d(0.1, -0.05, 0.02), Vector3d(-0.03, 0.2, 0.0)}) {
    const Vector3d p = scene.object(hand).X_WB * p_B;
    loop.setPoke(Poke{hand, p_B, p + way});
    loop.step();
    const Vector3d at = scene.object(hand).X_WB * p_B;
    const double q0 = arm.session->mechanisms()[0]->q()[0];
    const auto expected = effortsOf(base, q0, at, Poke::kStiffness * (p + way - at));
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(loop.robots()[0]->torque()[i], 2.0 * expected[i], 1e-9) << "the gain of the law is 2";
    view::SceneSnapshot seen;
    loop.capture(seen);
    EXPECT_EQ(seen.movers.poke.object, 0);
  }
  loop.setPoke(std::nullopt);
  loop.step();
  EXPECT_EQ(loop.robots()[0]->torque()[0], 0.0) << "at once";
}

TEST(Poke, ForceIsLimitedAndOtherBodiesFeelNone) {
  PlanarArm arm;
  ClosedLoop loop(*arm.session, 0.0);
  loop.step();
  const scene::Scene& scene = arm.session->scene();
  const Vector3d p = scene.object(ObjectId(0)).X_WB.translation();
  loop.setPoke(Poke{ObjectId(0), Vector3d::Zero(), p + Vector3d(0.0, 10.0, 0.0)});
  loop.step();
  view::SceneSnapshot seen;
  loop.capture(seen);
  EXPECT_NEAR(seen.movers.poke.force_W.norm(), Poke::kMaxForce, 1e-9);
  loop.setPoke(Poke{ObjectId(1), Vector3d::Zero(), p});
  loop.step();
  EXPECT_EQ(loop.robots()[0]->torque()[0], 0.0);
  loop.capture(seen);
  EXPECT_EQ(seen.movers.poke.object, -1);
}

TEST(Poke, YieldsAsAdmittanceSays) {
  // x = gain f / k: 400 N/m against 2000 N/m of the admittance, both from the same place.
  SlideScene s("{torque: {gain: 1}, admittance: {inertia: 1, damping: 100, stiffness: 2000, offset: 1}}");
  ClosedLoop loop(*s.session, 0.0);
  loop.setPoke(Poke{ObjectId(0), Vector3d::Zero(), Vector3d(-0.3, 0.0, 0.0)});
  for (int i = 0; i < 3000; ++i) loop.step();
  EXPECT_NEAR(loop.robots()[0]->q()[0], -0.3 * 400.0 / 2400.0, 1e-6);
  loop.setPoke(std::nullopt);
  for (int i = 0; i < 3000; ++i) loop.step();
  EXPECT_NEAR(loop.robots()[0]->q()[0], 0.0, 1e-6) << "it returns";
}

TEST(Poke, EndsWhenReleasedAndWhenNotRenewed) {
  SlideScene s("{torque: {gain: 1}, hold: {frequency: 500}}", thingComesTo(0.5));
  testing::ManualTime time(1e-6);
  LiveSession live(std::move(s.session), 0.0, std::make_unique<testing::ManualClock>(time));
  view::SceneSnapshot seen;
  const auto run = [&](double seconds) {
    static_cast<void>(time.runTo(time.now() + seconds));
    live.takeSnapshot(seen);
  };
  run(0.01);
  live.send(command::Play{true});
  live.send(command::Poke{0, Vector3d::Zero(), Vector3d(-0.1, 0.0, 0.0)});
  run(0.02);
  EXPECT_EQ(seen.movers.poke.object, 0);
  EXPECT_NEAR(seen.joint_torques[0].reaction, -0.1 * Poke::kStiffness, 1.0);
  live.send(command::EndPoke{});
  run(0.02);
  EXPECT_EQ(seen.movers.poke.object, -1);
  EXPECT_EQ(seen.joint_torques[0].reaction, 0.0);
  // Renewed it lasts, and no longer than that.
  for (int i = 0; i < 5; ++i) {
    live.send(command::Poke{0, Vector3d::Zero(), Vector3d(-0.1, 0.0, 0.0)});
    run(0.8 * Poke::kTimeout);
    EXPECT_EQ(seen.movers.poke.object, 0) << i;
  }
  run(0.4 * Poke::kTimeout);
  EXPECT_EQ(seen.movers.poke.object, -1) << "stale";
  EXPECT_EQ(seen.joint_torques[0].reaction, 0.0);
  // What makes no sense is dropped.
  live.send(command::Poke{7, Vector3d::Zero(), Vector3d::Zero()});
  live.send(command::Poke{0, Vector3d::Zero(), Vector3d::Constant(kNaN)});
  run(0.02);
  EXPECT_EQ(seen.movers.poke.object, -1);
  time.release();
}

}  // namespace live_laws_test
}  // namespace abstand::loop
