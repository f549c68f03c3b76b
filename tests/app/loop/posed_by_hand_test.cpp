// Robots that are posed by hand while everything else goes on.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/loop/watched_session.hpp"

namespace abstand::loop {
namespace posed_by_hand_test {

using testing::SlideScene;

constexpr const char* kStops = "{stop: {distance: 0.12}}";

struct Hand : testing::WatchedSession {
  explicit Hand(const std::string& more) : WatchedSession(kStops, more, 0.3) {}

  bool goTo(double t) {
    live.send(command::Seek{t});
    return waitForTime(t);
  }
};

TEST(PosedByHand, NonReactingRobotKeepsPoseWhileTimeRuns) {
  Hand h("    motion: go.csv\n");
  h.live.send(command::React{false});
  ASSERT_TRUE(h.goTo(1.0));
  EXPECT_NEAR(h.seen.joint_positions[0], -0.3, 1e-9);
  EXPECT_EQ(h.seen.movers.by_hand, std::vector<bool>{false});
  h.live.send(command::PoseJoint{0, 0.1});
  ASSERT_TRUE(h.waitFor([&] { return h.seen.movers.by_hand[0]; }));
  EXPECT_EQ(h.seen.joint_positions[0], 0.1);
  EXPECT_NEAR(h.seen.objects[0].X_WB.translation().x(), 0.1, 1e-12);
  const double thing = h.seen.objects[1].X_WB.translation().x();
  ASSERT_TRUE(h.goTo(0.4));
  EXPECT_EQ(h.seen.joint_positions[0], 0.1);
  EXPECT_NE(h.seen.objects[1].X_WB.translation().x(), thing);
  // Distances are those of where it stands: two balls of 5 cm.
  EXPECT_NEAR(h.seen.pairs[0].result.distance, (0.6 - 0.5 * 0.4) - 0.1 - 0.1, 1e-4);
  h.live.send(command::FollowMotion{0});
  ASSERT_TRUE(h.waitFor([&] { return !h.seen.movers.by_hand[0]; }));
  EXPECT_NEAR(h.seen.joint_positions[0], -0.12, 1e-9);
}

TEST(PosedByHand, InvalidPosesAreIgnoredAndLimitsKept) {
  Hand h("");
  h.live.send(command::React{false});
  h.live.send(command::PoseJoint{0, kNaN});
  h.live.send(command::PoseJoint{1, 0.5});
  h.live.send(command::PoseJoint{-1, 0.5});
  h.live.send(command::FollowMotion{7});
  ASSERT_TRUE(h.goTo(0.5));
  EXPECT_FALSE(h.seen.movers.by_hand[0]);
  EXPECT_EQ(h.seen.joint_positions[0], 0.0);
  h.live.send(command::PoseJoint{0, 1e6});
  ASSERT_TRUE(h.waitFor([&] { return h.seen.movers.by_hand[0]; }));
  EXPECT_EQ(h.seen.joint_positions[0], 5.0);
}

/// A second robot beside the slide; SlideScene writes its reaction and its ball.
const char* const kSecond =
    "    reaction: {stop: {distance: 0.12}}\n"
    "    links: [{name: far_ball, frame: 1, shape: {sphere: {radius: 0.05}}}]\n"
    "  - name: second\n"
    "    file: slide.mech\n"
    "    base: {xyz: [0, 3, 0], rpy: [0, 0, 1.5707963267948966]}\n"
    "    motion: go.csv\n";

TEST(PosedByHand, SuspendsReactionOfPosedRobotOnly) {
  Hand h(kSecond);
  ASSERT_EQ(h.live.outline().robots.size(), 2u);
  EXPECT_EQ(h.live.outline().robots[1].name, "second");
  EXPECT_EQ(h.live.outline().robots[1].first_joint, 1);
  EXPECT_EQ(h.live.outline().joints[1].upper, 5.0);
  EXPECT_EQ(h.live.outline().joints[1].effort, 500.0);
  h.live.send(command::Step{500});
  ASSERT_TRUE(h.waitFor([&] { return std::abs(h.seen.t - 0.5) < 1e-9; }));
  const long loops = h.seen.loops;
  ASSERT_LT(h.seen.joint_positions[1], -0.05) << "it moves as planned";
  // Beside the thing, where it would have to stop.
  h.live.send(command::PoseJoint{0, 0.2});
  ASSERT_TRUE(h.waitFor([&] { return h.seen.movers.by_hand[0]; }));
  h.live.send(command::Step{500});
  ASSERT_TRUE(h.waitFor([&] { return h.seen.t > 1.0; }));
  ASSERT_EQ(h.seen.robots.size(), 2u);
  EXPECT_LT(h.seen.pairs[1].result.distance, 0.12) << "far_ball and the thing";
  EXPECT_EQ(h.seen.robots[0].state, safety::StopState::kRunning);
  EXPECT_EQ(h.seen.robots[0].log.count(), 0u);
  EXPECT_EQ(h.seen.joint_positions[0], 0.2) << "nothing pulls it back to its plan";
  EXPECT_EQ(h.seen.loops, loops) << "the other one goes on where it was";
  EXPECT_LT(h.seen.joint_positions[1], -0.2);
  EXPECT_EQ(h.seen.joint_torques[0].reaction, 0.0);
  // Given back, all begin anew on their plans.
  h.live.send(command::FollowMotion{0});
  ASSERT_TRUE(h.waitFor([&] { return !h.seen.movers.by_hand[0]; }));
  EXPECT_EQ(h.seen.loops, loops + 1);
  EXPECT_EQ(h.seen.loop_start, h.seen.t);
  EXPECT_NEAR(h.seen.joint_positions[0], 0.0, 1e-9) << "on its plan";
}

TEST(PosedByHand, SeekKeepsPose) {
  Hand h(kSecond);
  h.live.send(command::PoseJoint{1, 0.4});
  ASSERT_TRUE(h.goTo(1.5));
  EXPECT_TRUE(h.seen.movers.by_hand[1]);
  EXPECT_EQ(h.seen.joint_positions[1], 0.4);
  h.live.send(command::React{false});
  ASSERT_TRUE(h.waitFor([&] { return h.seen.robots.empty(); }));
  EXPECT_EQ(h.seen.joint_positions[1], 0.4);
}

}  // namespace posed_by_hand_test
}  // namespace abstand::loop
