// The demos of avoidance: what happens to robots that react, and to those that do not.
#include <gtest/gtest.h>

#include "app/run/run_scene.hpp"
#include "tests/support/paths.hpp"

namespace abstand::testing {
namespace {

/// Coarser than the scenes are, so that the test is short; distances keep their bounds.
RunSummary run(const std::string& name, double start, double end, bool react, bool laws = true) {
  SceneDescription scene = loadScene(projectFile("data/scenes/" + name));
  scene.defaults.haptic.voxel_size = scene.defaults.haptic.point_spacing = 0.01;
  for (auto& o : scene.objects) o.settings.voxel = o.settings.point = 0.02;
  if (!laws)
    for (auto& m : scene.mechanisms) {
      m.reaction->repulsion.reset();
      m.reaction->torque.reset();
      m.reaction->watch = {};
    }
  SessionOptions options;
  options.threads = 1;
  options.cache = false;
  Session session(std::move(scene), options);
  RunOptions o;
  o.start = start;
  o.end = end;
  o.react = react;
  return runScene(session, o);
}

// The boxer steps towards the left arm and punches past it, s into the capture.
constexpr double kBegin = 5.5, kEnd = 7.5;

TEST(HugAvoid, ArmsThatDoNotReactAreHit) {
  const RunSummary s = run("hug_avoid.yaml", kBegin, kEnd, false);
  EXPECT_EQ(s.pairs, 291u);
  EXPECT_LT(s.min_distance->value, -0.05);
  EXPECT_GT(s.contacts, 0);
}

TEST(HugAvoid, ArmsThatReactKeepAwayFromTheBoxer) {
  const RunSummary s = run("hug_avoid.yaml", kBegin, kEnd, true);
  EXPECT_EQ(s.cycles, 2001);
  ASSERT_EQ(s.robots.size(), 2u);
  for (const ReactionReport& r : s.robots) {
    ASSERT_TRUE(r.nearest_person);
    EXPECT_GT(r.nearest_person->value, 0.01) << r.name;
    EXPECT_GT(r.record.most_off_plan, 0.1) << "it did move";
  }
  EXPECT_EQ(s.contacts, 0);
  // The left one was nearer than its limit for a while, stopped its plan, and went on.
  ASSERT_GE(s.robots[0].stops.size(), 1u);
  EXPECT_EQ(s.robots[0].stops[0].cause.reason, StopReason::kDistance);
}

TEST(HugAvoid, APersonCannotPushThroughAnArmThatOnlyGivesWay) {
  // No law: held softly, and pushed by the contact itself. The boxer goes less deep than through a rigid arm.
  const RunSummary rigid = run("hug_avoid.yaml", kBegin, kEnd, false);
  const RunSummary soft = run("hug_avoid.yaml", kBegin, kEnd, true, false);
  EXPECT_LT(soft.min_distance->value, 0.0);
  EXPECT_GT(soft.min_distance->value, 0.7 * rigid.min_distance->value);
  EXPECT_GT(soft.contacts, 0);
}

TEST(HumanoidSelf, ArmsThatDoNotReactGoThroughEachOther) {
  const RunSummary s = run("humanoid_self.yaml", 0.0, 2.2, false);
  EXPECT_LT(s.min_distance->value, -0.03);
}

TEST(HumanoidSelf, ArmsThatReactStayApart) {
  const RunSummary s = run("humanoid_self.yaml", 0.0, 2.2, true);
  ASSERT_EQ(s.robots.size(), 1u);
  EXPECT_GT(s.robots[0].nearest->value, 0.03);
  EXPECT_EQ(s.contacts, 0);
}

}  // namespace
}  // namespace abstand::testing
