// The demos of avoidance: what happens to robots that react, and to those that do not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/run/run_scene.hpp"
#include "tests/support/paths.hpp"

namespace abstand::testing {
namespace avoid_test {

/// Coarser than the scenes are, and built once, so that the test is short; distances keep their bounds.
std::unique_ptr<session::Session> sessionOf(const std::string& name) {
  scene_file::SceneDescription scene = scene_file::loadScene(projectFile("data/scenes/" + name));
  structure::HapticOptions& haptic = scene.defaults.haptic;
  haptic.voxel_size = haptic.point_spacing = 0.015;
  haptic.outer_layers = 4;
  for (auto& o : scene.objects) o.settings.voxel = o.settings.point = 0.03;
  session::SessionOptions options;
  options.threads = 1;
  options.cache = false;
  return std::make_unique<session::Session>(std::move(scene), options);
}

run::RunSummary run(session::Session& session, double start, double end, bool react) {
  run::RunOptions o;
  o.start = start;
  o.end = end;
  o.react = react;
  return run::runScene(session, o);
}

// The boxer steps towards the left arm and punches past it, s into the capture.
constexpr double kBegin = 5.5, kEnd = 7.5;

session::Session& hug() {
  static const auto session = sessionOf("hug_avoid.yaml");
  return *session;
}
session::Session& humanoid() {
  static const auto session = sessionOf("humanoid_self.yaml");
  return *session;
}

TEST(HugAvoid, ArmsWithoutReactionAreHit) {
  const run::RunSummary s = run(hug(), kBegin, kEnd, false);
  EXPECT_EQ(s.pairs, 291u);
  EXPECT_LT(s.min_distance->value, -0.05);
  EXPECT_GT(s.contacts, 0);
}

TEST(HugAvoid, ReactingArmsKeepAwayFromBoxer) {
  const run::RunSummary s = run(hug(), kBegin, kEnd, true);
  EXPECT_EQ(s.cycles, 2001);
  ASSERT_EQ(s.robots.size(), 2u);
  for (const loop::ReactionReport& r : s.robots) {
    ASSERT_TRUE(r.nearest_person);
    EXPECT_GT(r.nearest_person->value, 0.01) << r.name;
    EXPECT_GT(r.record.max_off_plan, 0.1) << "it did move";
  }
  EXPECT_EQ(s.contacts, 0);
  // The left one was nearer than its limit for a while, stopped its plan, and went on.
  ASSERT_GE(s.robots[0].stops.size(), 1u);
  EXPECT_EQ(s.robots[0].stops[0].cause.reason, safety::StopReason::kDistance);
}

TEST(HugAvoid, JointsKeepLimitsInEveryCycle) {
  // Positions in rad, velocities in rad/s and efforts in N m may be beyond by rounding alone.
  constexpr double kShare = 1e-6;
  const std::vector<double> times = hug().frameTimes();
  loop::ClosedLoop loop(hug(), times.front());
  std::vector<double> fastest(14, 0.0);
  double nearest = kInfinity;
  while (loop.time() <= times.back()) {
    loop.step();
    for (std::size_t m = 0; m < 2; ++m) {
      const loop::ReactingRobot& robot = *loop.robots()[m];
      const auto& frames = robot.driver().mechanism().frames;
      for (std::size_t k = 0; k < 7; ++k) {
        const mechanism::JointLimits& l = frames[k].limits;
        ASSERT_LE(robot.q()[k], l.upper * (1.0 + kShare)) << loop.time() << " s, arm " << m << " joint " << k;
        ASSERT_GE(robot.q()[k], l.lower * (1.0 + kShare)) << loop.time() << " s, arm " << m << " joint " << k;
        ASSERT_LE(std::abs(robot.qd()[k]), l.velocity * (1.0 + kShare))
            << loop.time() << " s, arm " << m << " joint " << k;
        ASSERT_LE(std::abs(robot.applied()[k]), l.effort * (1.0 + kShare))
            << loop.time() << " s, arm " << m << " joint " << k;
        fastest[7 * m + k] = std::max(fastest[7 * m + k], std::abs(robot.qd()[k]) / l.velocity);
      }
    }
  }
  for (const auto& robot : loop.robots()) {
    EXPECT_TRUE(robot->limits().kept());
    nearest = std::min(nearest, robot->record().nearest_person.value);
  }
  EXPECT_GT(nearest, 0.01) << "and the boxer is never touched";
  EXPECT_GT(*std::max_element(fastest.begin(), fastest.end()), 0.999) << "some joint needed all it has";
  EXPECT_TRUE(run::jointLimitsOf(hug(), &loop, times.front(), times.back()).empty()) << "their plans neither";
}

TEST(HumanoidSelf, ArmsWithoutReactionPenetrateEachOther) {
  const run::RunSummary s = run(humanoid(), 0.0, 2.2, false);
  EXPECT_LT(s.min_distance->value, -0.03);
}

TEST(HumanoidSelf, ReactingArmsStayApart) {
  const run::RunSummary s = run(humanoid(), 0.0, 2.2, true);
  ASSERT_EQ(s.robots.size(), 1u);
  EXPECT_GT(s.robots[0].nearest->value, 0.03);
  EXPECT_EQ(s.contacts, 0);
}

}  // namespace avoid_test
}  // namespace abstand::testing
