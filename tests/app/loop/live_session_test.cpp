// A session that plays a closed loop on its own thread.
#include "app/loop/live_session.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "core/base/error.hpp"
#include "tests/app/loop/watched_session.hpp"

namespace abstand::loop {
namespace live_session_test {

using testing::SlideScene;
using testing::thingComesTo;

constexpr const char* kYield = "{repulsion: {range: 0.2, force: 100}, stop: {distance: 0.12}}";

using Live = testing::WatchedSession;

TEST(LiveSession, StepsMatchClosedLoop) {
  Live l(kYield);
  EXPECT_EQ(l.live.outline().reacting, std::vector<std::string>{"slide"});
  ASSERT_TRUE(l.waitForTime(0.0));
  ASSERT_EQ(l.seen.robots.size(), 1u);
  EXPECT_EQ(l.seen.robots[0].state, safety::StopState::kRunning);
  EXPECT_EQ(l.seen.loop_start, 0.0);
  for (int i = 0; i < 12; ++i) l.live.send(command::Step{100});
  ASSERT_TRUE(l.waitForTime(1.2));

  SlideScene same(kYield, thingComesTo(0.05));
  ClosedLoop loop(*same.session, 0.0);
  for (int i = 0; i <= 1200; ++i) loop.step();
  EXPECT_EQ(l.seen.joint_positions[0], same.session->mechanisms()[0]->q()[0]);
  EXPECT_LT(l.seen.joint_positions[0], -0.01) << "it gave way";
  const safety::StopMachine& stops = loop.robots()[0]->stops();
  const view::RobotSnapshot& robot = l.seen.robots[0];
  EXPECT_EQ(robot.state, stops.state());
  EXPECT_FALSE(stops.moving());
  EXPECT_EQ(robot.since, stops.since());
  EXPECT_EQ(robot.cause.reason, safety::StopReason::kDistance);
  EXPECT_EQ(robot.speed_scale, 0.0);
  ASSERT_EQ(robot.log.count(), stops.log().count());
  EXPECT_EQ(safety::describe(robot.log.entry(0)), safety::describe(stops.log().entry(0)));
}

TEST(LiveSession, SeekPutsRobotsOnPlans) {
  Live l(kYield);
  l.live.send(command::Step{1200});
  ASSERT_TRUE(l.waitForTime(1.2));
  EXPECT_GT(l.seen.robots[0].log.count(), 0u);
  const long loops = l.seen.loops;
  l.live.send(command::Seek{1.0});
  ASSERT_TRUE(l.waitForTime(1.0));
  EXPECT_GT(l.seen.loops, loops);
  EXPECT_EQ(l.seen.loop_start, 1.0);
  EXPECT_EQ(l.seen.robots[0].log.count(), 0u);
  EXPECT_EQ(l.seen.joint_positions[0], 0.0) << "its plan is to rest there";
  l.live.send(command::Step{-10});
  ASSERT_TRUE(l.waitForTime(0.99));
  EXPECT_EQ(l.seen.loop_start, l.seen.t);
}

TEST(LiveSession, ChangingMarginDoesNotMoveRobot) {
  Live l(kYield);
  l.live.send(command::Step{900});
  ASSERT_TRUE(l.waitForTime(0.9));
  const double q = l.seen.joint_positions[0];
  l.live.send(command::Margin{1, 0.2});
  ASSERT_TRUE(l.waitFor([&] { return l.seen.objects[1].margin == 0.2 && l.seen.objects[1].colliding; }));
  // The next cycle is shown, not run: a millisecond on at the speed it has.
  EXPECT_NEAR(l.seen.joint_positions[0], q, 2e-3);
  EXPECT_NEAR(l.seen.t, 0.901, 1e-9);
  EXPECT_EQ(l.seen.loop_start, 0.0);
}

TEST(LiveSession, ClassMarginReplacesSumsOfItsPairs) {
  Live l(kYield);
  l.live.send(command::ClassMargin{view::PairClass::kRobotThing, 0.3});
  ASSERT_TRUE(l.waitFor([&] { return l.seen.pairs[0].margin == 0.3; }));
  l.live.send(command::Margin{1, 0.2});
  ASSERT_TRUE(l.waitFor([&] { return l.seen.objects[1].margin == 0.2; }));
  EXPECT_EQ(l.seen.pairs[0].margin, 0.3);
  l.live.send(command::ClassMargin{view::PairClass::kPersonRobot, 0.7});
  l.live.send(command::ClassMargin{view::PairClass::kRobotThing, kNaN});
  l.live.send(command::Margin{1, 0.1});
  ASSERT_TRUE(l.waitFor([&] { return l.seen.objects[1].margin == 0.1; }));
  EXPECT_EQ(l.seen.pairs[0].margin, 0.3) << "no pair of that class, and no number";
  l.live.send(command::ClassMargin{view::PairClass::kRobotThing, -1.0});
  ASSERT_TRUE(l.waitFor([&] { return l.seen.pairs[0].margin == 0.1; }));
}

/// Things of a scene that nothing else moves.
struct LiveThings {
  explicit LiveThings(const std::string& mass) {
    session::SessionOptions options;
    options.threads = 1;
    options.cache = false;
    const auto scene = scene_file::parseScene(
        "abstand: 1\ndefaults: {voxel: 0.02, point: 0.02}\nobjects:\n"
        "  - {name: table, shape: {cuboid: {size: [0.5, 0.5, 0.1]}}, pose: {xyz: [0, 0, -0.05]}}\n"
        "  - {name: ball, shape: {sphere: {radius: 0.05}}, pose: {xyz: [0, 0, 0.5]}" +
            mass + "}\n",
        "scene.yaml");
    live = std::make_unique<LiveSession>(std::make_unique<session::Session>(scene, options), 0.0);
  }
  template <class Condition>
  bool waitFor(Condition condition) {
    for (int i = 0; i < 6000; ++i) {
      live->takeSnapshot(seen);
      if (seen.step > 0 && condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }
  bool ballIsAt(const Vector3d& p_W) {
    return waitFor([&] { return (seen.objects[1].X_WB.translation() - p_W).norm() < 1e-12; });
  }
  void place(const Vector3d& p_W) { live->send(command::PlaceThing{1, fromXyzRpy(p_W, Vector3d::Zero())}); }

  std::unique_ptr<LiveSession> live;
  view::SceneSnapshot seen;
};

TEST(LiveSession, PlacedThingIsThereAtOnceAndRests) {
  LiveThings l("");
  // The distance of a ball above a table is exact up to the bound of its query.
  const auto clearance = [&] { return std::abs(l.seen.pairs[0].result.distance - 0.25) <= 1e-3; };
  l.place({0.0, 0.0, 0.3});
  ASSERT_TRUE(l.ballIsAt({0.0, 0.0, 0.3}));
  EXPECT_TRUE(l.waitFor(clearance)) << l.seen.pairs[0].result.distance;
  EXPECT_EQ(l.seen.objects[1].velocity.linear.norm(), 0.0);
  l.live->send(command::PlaceThing{7, Transform::Identity()});
  l.place({kNaN, 0.0, 0.0});
  l.place({0.0, 0.0, 0.2});
  ASSERT_TRUE(l.ballIsAt({0.0, 0.0, 0.2})) << "no such thing, and no pose, change nothing";
  l.live->send(command::PlaceThing{1, std::nullopt});
  EXPECT_TRUE(l.ballIsAt({0.0, 0.0, 0.5})) << "as in the scene";
}

TEST(LiveSession, PlacedThingFallsFromThere) {
  LiveThings l(", mass: 0.5");
  l.live->send(command::Step{100});
  ASSERT_TRUE(l.waitFor([&] { return std::abs(l.seen.t - 0.1) < 1e-9; }));
  const double fallen = 0.5 - l.seen.objects[1].X_WB.translation().z();
  EXPECT_GT(fallen, 0.04);
  const long loops = l.seen.loops;
  l.place({0.0, 0.0, 0.4});
  ASSERT_TRUE(l.waitFor([&] { return l.seen.loops > loops; }));
  EXPECT_NEAR(l.seen.objects[1].X_WB.translation().z(), 0.4, 1e-12);
  EXPECT_NEAR(l.seen.t, 0.1, 1e-9) << "the clock stays";
  l.live->send(command::Step{100});
  ASSERT_TRUE(l.waitFor([&] { return std::abs(l.seen.t - 0.2) < 1e-9; }));
  EXPECT_NEAR(0.4 - l.seen.objects[1].X_WB.translation().z(), fallen, 1e-9) << "from rest, as before";
}

TEST(LiveSession, WithoutReactionMotionMatchesRecording) {
  Live l(kYield);
  l.live.send(command::React{false});
  ASSERT_TRUE(l.waitFor([&] { return l.seen.robots.empty(); }));
  EXPECT_TRUE(std::isnan(l.seen.loop_start));
  l.live.send(command::Step{2000});
  ASSERT_TRUE(l.waitForTime(2.0));
  EXPECT_EQ(l.seen.joint_positions[0], 0.0);
  EXPECT_NEAR(l.seen.pairs[0].result.distance, -0.05, 1e-3);
  l.live.send(command::React{true});
  ASSERT_TRUE(l.waitFor([&] { return l.seen.robots.size() == 1; }));
  EXPECT_EQ(l.seen.loop_start, 2.0);
}

TEST(LiveSession, UserResetsStop) {
  // Any approach of its own within range engages the brakes.
  Live l("{repulsion: {range: 0.6, force: 1, stop_share: 0}}", "    motion: come.csv\n", 0.5);
  l.live.send(command::Step{1500});
  ASSERT_TRUE(l.waitForTime(1.5));
  ASSERT_EQ(l.seen.robots[0].state, safety::StopState::kWaitingForReset);
  l.live.send(command::ResetStops{});
  l.live.send(command::Step{1});
  ASSERT_TRUE(l.waitForTime(1.501));
  // It was let go, and is stopped again when it moves on.
  EXPECT_EQ(l.seen.robots[0].state, safety::StopState::kRunning);
  l.live.send(command::Step{100});
  ASSERT_TRUE(l.waitForTime(1.601));
  EXPECT_FALSE(l.seen.robots[0].state == safety::StopState::kRunning);
}

TEST(LiveSession, PlaysToTheEndAndStops) {
  Live l(kYield, "", 0.05, 2.9);
  l.live.send(command::Loop{false});
  l.live.send(command::Speed{8.0});
  l.live.send(command::Play{true});
  ASSERT_TRUE(l.waitForTime(3.0));
  ASSERT_TRUE(l.waitFor([&] { return !l.seen.playing; }));
  EXPECT_EQ(l.seen.loop_start, 2.9);
  l.live.send(command::Loop{true});
  l.live.send(command::Play{true});
  ASSERT_TRUE(l.waitFor([&] { return l.seen.playing && l.seen.loop_start == 0.0 && l.seen.t > 0.05; }));
}

TEST(LiveSession, ReportsJointTorques) {
  Live l(kYield);
  l.live.send(command::Step{1000});
  ASSERT_TRUE(l.waitForTime(1.0));
  ASSERT_EQ(l.seen.joint_torques.size(), 1u);
  const view::TorqueParts& parts = l.seen.joint_torques[0];
  EXPECT_EQ(parts.contact, l.seen.joint_efforts[0]);
  EXPECT_LT(parts.reaction, -1.0) << "the thing comes near and pushes the ball away";
  EXPECT_NEAR(parts.gravity, 0.0, 1e-9) << "the slide is level";
  // Nothing else moves it than the reaction and what holds it on its plan, so that its inertia is against
  // both.
  EXPECT_TRUE(std::isfinite(parts.motion));
  std::vector<view::PlotSample> samples;
  l.live.drainPlot(samples);
  double most = 0.0;
  for (const view::PlotSample& sample : samples) {
    most = std::max(most, sample.peak_torque.reaction);
    EXPECT_GT(sample.cycle_s, 0.0);
    EXPECT_EQ(sample.step_s, ClosedLoop::kStep);
    EXPECT_EQ(sample.nearest_pair, 0);
    EXPECT_FALSE(sample.played) << "a step is none";
  }
  EXPECT_GE(most, -parts.reaction);
}

TEST(LiveSession, TorquesCanBeTurnedOffAndOn) {
  Live l("{repulsion: {range: 0.2, force: 100}}");
  l.live.send(command::Torques{false});
  l.live.send(command::Step{900});
  ASSERT_TRUE(l.waitForTime(0.9));
  EXPECT_FALSE(l.seen.torques_on);
  EXPECT_EQ(l.seen.joint_torques[0].reaction, 0.0);
  EXPECT_NEAR(l.seen.joint_positions[0], 0.0, 1e-9) << "it stays on its plan";
  l.live.send(command::Torques{true});
  l.live.send(command::Step{300});
  ASSERT_TRUE(l.waitForTime(1.2));
  EXPECT_TRUE(l.seen.torques_on);
  EXPECT_LT(l.seen.joint_torques[0].reaction, 0.0);
  EXPECT_LT(l.seen.joint_positions[0], -0.01);
  // They stay off over a seek, which begins a new closed loop.
  l.live.send(command::Torques{false});
  l.live.send(command::Seek{0.9});
  l.live.send(command::Step{100});
  ASSERT_TRUE(l.waitForTime(1.0));
  EXPECT_EQ(l.seen.joint_torques[0].reaction, 0.0);
}

TEST(LiveSession, PausedGroupIsStaleAndStopsRobot) {
  Live l("{repulsion: {range: 0.2, force: 100}}");
  EXPECT_EQ(l.live.outline().pair_groups, std::vector<std::string>{"slide - objects"});
  l.live.send(command::SetGroup{0, view::PairGroupState::kPaused});
  l.live.send(command::Step{900});
  ASSERT_TRUE(l.waitForTime(0.9));
  EXPECT_EQ(l.seen.groups[0].state, view::PairGroupState::kPaused);
  EXPECT_TRUE(l.seen.pairs[0].paused);
  EXPECT_EQ(l.seen.nearest_pair, -1) << "a distance that is stale is not the smallest one";
  ASSERT_EQ(l.seen.robots.size(), 1u);
  EXPECT_NE(l.seen.robots[0].state, safety::StopState::kRunning);
  EXPECT_EQ(l.seen.robots[0].cause.reason, safety::StopReason::kDistance);
  EXPECT_TRUE(std::isnan(l.seen.robots[0].cause.value)) << "it is not known";
  EXPECT_EQ(l.seen.joint_torques[0].reaction, 0.0) << "no direction is known";
  l.live.send(command::SetGroup{0, view::PairGroupState::kRunning});
  l.live.send(command::Step{100});
  ASSERT_TRUE(l.waitForTime(1.0));
  EXPECT_FALSE(l.seen.pairs[0].paused);
  EXPECT_EQ(l.seen.nearest_pair, 0);
}

TEST(LiveSession, RemovedPairReturnsToGroup) {
  Live l("{}");
  l.live.send(command::RemovePair{0});
  ASSERT_TRUE(l.waitFor([&] { return !l.seen.pair_group.empty() && l.seen.pair_group[0] == -1; }));
  EXPECT_TRUE(l.seen.pairs[0].paused);
  EXPECT_EQ(l.seen.groups[0].pairs, 0u);
  for (const int wrong : {-1, 1, 99}) {
    l.live.send(command::AddPair{wrong, 0});
    l.live.send(command::AddPair{0, wrong});
    l.live.send(command::RemovePair{wrong});
    l.live.send(command::SetGroup{wrong, view::PairGroupState::kStopped});
  }
  l.live.send(command::AddPair{0, 0});
  ASSERT_TRUE(l.waitFor([&] { return l.seen.pair_group[0] == 0; }));
  EXPECT_FALSE(l.seen.pairs[0].paused);
  EXPECT_EQ(l.seen.groups[0].pairs, 1u);
}

TEST(LiveSession, ReportsWhyRobotCannotReact) {
  testing::ScratchFolder folder;
  const scene_file::SceneDescription scene = testing::sceneWithoutMasses(folder);
  session::SessionOptions options;
  options.cache = false;
  LiveSession live(std::make_unique<session::Session>(scene, options), 0.0);
  EXPECT_NE(live.outline().cannot_react.find("needs masses"), std::string::npos)
      << live.outline().cannot_react;
  view::SceneSnapshot seen;
  live.send(command::React{true});
  live.send(command::Seek{0.0});
  while (!live.takeSnapshot(seen)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_TRUE(seen.robots.empty()) << "nothing reacts, and nothing ended";
}

}  // namespace live_session_test
}  // namespace abstand::loop
