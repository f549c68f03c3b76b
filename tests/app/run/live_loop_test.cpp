// The closed loop in live mode, and how a scene takes results of others.
#include "app/run/live_loop.hpp"

#include <gtest/gtest.h>

#include "app/run/run_scene.hpp"
#include "core/base/error.hpp"
#include "tests/app/loop/slide_scene.hpp"

namespace abstand::run {
namespace live_loop_test {

using testing::SlideScene;
using testing::thingComesTo;

TEST(LiveLoop, RobotsReactToNewestResults) {
  SlideScene s("{repulsion: {range: 0.2, force: 100}}", thingComesTo(0.05));
  RunOptions options;
  options.start = 0.6;
  options.end = 1.6;
  options.rate = 10.0;
  options.mode = RunMode::kLive;
  options.react = true;
  const RunSummary live = runScene(*s.session, options);
  EXPECT_EQ(live.frames, 11u);
  EXPECT_EQ(live.cycles, 1001);
  ASSERT_EQ(live.robots.size(), 1u);
  // Results may be old on a busy machine, but not older than `input_age`, 0.1 s, in which the thing comes 5
  // cm nearer; in lock step the least distance is more than 3 cm, without reacting less than -4 cm.
  EXPECT_GT(live.min_distance->value, -0.02);
  EXPECT_GT(live.robots[0].record.max_off_plan, 0.01);
}

TEST(LiveLoop, StaleResultsStopRobot) {
  // The group of a robot's pairs that gives no results: here none at all does.
  SlideScene s("{stop: {input_age: 0.05}}");
  loop::ClosedLoop loop(*s.session, 0.0);
  for (int i = 0; i < 100; ++i) {
    loop.move();
    s.session->scene().step();
    loop.react(1e-3 * i);
  }
  const auto report = loop::reportOf(loop);
  EXPECT_NE(report[0].state, safety::StopState::kRunning);
  ASSERT_FALSE(report[0].stops.empty());
  EXPECT_EQ(report[0].stops[0].cause.reason, safety::StopReason::kStaleInput);
  EXPECT_NEAR(report[0].stops[0].t, 0.051, 1e-9);
}

TEST(LiveLoop, RejectsRobotPairOutsideGroups) {
  SlideScene s("{}");
  EXPECT_THROW(LiveLoop(*s.session, 0.0, {}), UsageError);
  LiveLoop both(*s.session, 0.0, {{PairId(0)}});
  std::vector<query::PairResult> results(1);
  both.cycle(results);
  EXPECT_NEAR(results[0].distance, 0.5, 1e-3);
}

TEST(LiveLoop, SceneAcceptsExternalResults) {
  SlideScene s("{}", thingComesTo(0.05));
  session::Session& session = *s.session;
  scene::Scene& scene = session.scene();
  std::vector<Wrench> contacts;
  std::vector<query::PairResult> results;
  for (const double t : {0.0, 1.2, 2.0}) {
    session.step(t);
    results = {scene.result(PairId(0))};
    contacts.clear();
    for (const scene::Object& o : scene.objects()) contacts.push_back(o.contact);
    const bool touches = !scene.touching().empty();
    EXPECT_EQ(touches, t > 1.1) << t;
    scene.setResults({query::PairResult{}});
    EXPECT_TRUE(scene.touching().empty());
    EXPECT_FALSE(scene.objects()[0].colliding);
    scene.setResults(results);
    EXPECT_EQ(scene.result(PairId(0)).distance, results[0].distance);
    EXPECT_EQ(!scene.touching().empty(), touches);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      EXPECT_EQ(scene.objects()[i].contact.force, contacts[i].force);
      EXPECT_EQ(scene.objects()[i].contact.torque, contacts[i].torque);
    }
    ASSERT_TRUE(scene.nearest());
  }
}

}  // namespace live_loop_test
}  // namespace abstand::run
