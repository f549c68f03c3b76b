// The closed loop on small scenes whose outcome is known: rest, a push, a stop, brakes, positions.
#include "app/loop/closed_loop.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "app/loop/loop_report.hpp"
#include "app/run/run_scene.hpp"
#include "core/base/error.hpp"
#include "tests/app/loop/slide_scene.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::loop {
namespace closed_loop_test {

using testing::SlideScene;
using testing::thingAt;
using testing::thingComesTo;

void steps(ClosedLoop& loop, int count) {
  for (int i = 0; i < count; ++i) loop.step();
}

TEST(ClosedLoop, UndisturbedRobotFollowsPlan) {
  SlideScene s("{}", "", "    motion: go.csv\n");
  ClosedLoop loop(*s.session, 0.0);
  steps(loop, 2000);
  const ReactingRobot& robot = *loop.robots()[0];
  EXPECT_NEAR(loop.time(), 2.0, 1e-12);
  EXPECT_NEAR(robot.q()[0], -0.6, 1e-3);
  // A step behind at the most: 0.45 m/s for a millisecond.
  EXPECT_LT(robot.record().max_off_plan, 1e-3);
  EXPECT_NEAR(robot.record().lost_time, 0.0, 1e-9);
}

TEST(ClosedLoop, PotentialIsBalancedBySpring) {
  // The thing stays at 0.2 m: 0.1 m from the ball at rest. Balance of the potential F (d0 - d)^2 / d0^2 and
  // the spring m omega^2 x, with d = 0.1 + x: solved by bisection here.
  const double force = 100.0, range = 0.2, spring = 2.0 * 6.0 * 6.0;
  double low = 0.0, high = range - 0.1;
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (low + high), e = range - 0.1 - x;
    (force * e * e / (range * range) > spring * x ? low : high) = x;
  }
  SlideScene s("{repulsion: {range: 0.2, force: 100, damping: 1}}", thingComesTo(0.2));
  ClosedLoop loop(*s.session, 0.0);
  steps(loop, 2900);
  // The laws take the distance less its bound, which is micrometres for two balls.
  EXPECT_NEAR(loop.robots()[0]->q()[0], -low, 1e-4);
  EXPECT_NEAR(loop.robots()[0]->qd()[0], 0.0, 1e-3);
}

TEST(ClosedLoop, WithoutLawOnlyContactForceActs) {
  SlideScene s("{}", thingComesTo(0.05));
  ClosedLoop loop(*s.session, 0.0);
  steps(loop, 2900);
  const ReactingRobot& robot = *loop.robots()[0];
  EXPECT_LT(robot.record().nearest.value, -0.001) << "they touch";
  EXPECT_LT(robot.q()[0], -0.02) << "and it gives way";
  // At rest the penalty force carries the spring, so it is 2 kg 36/s^2 x.
  const double f = std::abs(s.session->scene().object(s.session->scene().pairs()[0].a).contact.force.x());
  EXPECT_NEAR(f, 2.0 * 36.0 * std::abs(robot.q()[0]), 0.05);
  EXPECT_EQ(robot.record().max_torque, 0.0);
}

TEST(ClosedLoop, StopHoldsPlanAndResumes) {
  SlideScene s("{stop: {distance: 0.4, resume_after: 0.2}}", "", "    motion: go.csv\n");
  ClosedLoop loop(*s.session, 0.0);
  // 0.5 m at the beginning, and it goes away: nothing stops it.
  steps(loop, 1000);
  EXPECT_EQ(loop.robots()[0]->record().stopped, 0.0);

  // The thing comes nearer than that, and goes away after a second.
  const auto visit = thingAt([](double t) {
    return t < 0.4 ? 0.6 - 0.5 * t : t < 1.0 ? 0.4 : 0.4 + 0.5 * (t - 1.0);
  });
  SlideScene near("{stop: {distance: 0.45, resume_after: 0.2}}", visit, "    motion: go.csv\n");
  ClosedLoop other(*near.session, 0.0);
  steps(other, 2900);
  const auto report = reportOf(other);
  ASSERT_EQ(report.size(), 1u);
  EXPECT_GT(report[0].record.stopped, 1.0);
  EXPECT_NEAR(report[0].record.lost_time, report[0].record.stopped, 2e-3)
      << "its plan stood as long as it did";
  EXPECT_EQ(report[0].state, safety::StopState::kRunning);
  ASSERT_EQ(report[0].stops.size(), 2u);
  EXPECT_EQ(report[0].stops[0].to, safety::StopState::kProtectiveStop);
  EXPECT_EQ(report[0].stops[0].cause.reason, safety::StopReason::kDistance);
  EXPECT_NE(report[0].lines[0].find("pair ball - thing"), std::string::npos) << report[0].lines[0];
}

TEST(ClosedLoop, BrakesHoldPushedRobot) {
  // Any approach of its own within range engages the brakes; then the thing comes and pushes in vain.
  SlideScene s("{repulsion: {range: 0.6, force: 1, stop_share: 0}}", thingComesTo(0.05),
               "    motion: come.csv\n");
  ClosedLoop loop(*s.session, 0.0);
  steps(loop, 2900);
  const ReactingRobot& robot = *loop.robots()[0];
  EXPECT_EQ(robot.stops().state(), safety::StopState::kWaitingForReset);
  EXPECT_LT(std::abs(robot.q()[0]), 2e-3);
  EXPECT_GT(s.session->scene().object(ObjectId(0)).contact.force.norm(), 100.0) << "5 cm deep, 164 N";
}

TEST(ClosedLoop, PositionControlledRobotYieldsByAdmittance) {
  SlideScene s(
      "{repulsion: {range: 0.2, force: 100, damping: 0}, admittance: {inertia: 1, damping: 50, stiffness: "
      "500, offset: 1}}",
      thingComesTo(0.2));
  ClosedLoop loop(*s.session, 0.0);
  EXPECT_TRUE(loop.robots()[0]->positioned());
  steps(loop, 2900);
  double low = 0.0, high = 0.1;
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (low + high), e = 0.1 - x;
    (100.0 * e * e / 0.04 > 500.0 * x ? low : high) = x;
  }
  EXPECT_NEAR(loop.robots()[0]->q()[0], -low, 1e-4);
}

TEST(ClosedLoop, IsDeterministicWithoutAllocation) {
  double q[2];
  for (double& end : q) {
    SlideScene s("{repulsion: {range: 0.2, force: 100}, torque: {limit: 30}, speed: {}}", thingComesTo(0.05));
    ClosedLoop loop(*s.session, 0.0);
    steps(loop, 1100);  // they touch
    {
      testing::NoAlloc guard;
      steps(loop, 500);
      EXPECT_EQ(guard.count(), 0);
    }
    end = loop.robots()[0]->q()[0];
  }
  EXPECT_EQ(q[0], q[1]);
}

TEST(ClosedLoop, RunReportsReactionAndReactOffIsPlainRun) {
  SlideScene s("{repulsion: {range: 0.2, force: 100}}", thingComesTo(0.05));
  run::RunOptions options;
  options.end = 2.0;
  options.rate = 10.0;
  run::RunSummary plain = run::runScene(*s.session, options);
  EXPECT_EQ(plain.cycles, 0);
  EXPECT_TRUE(plain.robots.empty());
  EXPECT_NEAR(plain.min_distance->value, -0.05, 1e-3);
  options.react = true;
  const run::RunSummary reacting = run::runScene(*s.session, options);
  EXPECT_EQ(reacting.frames, plain.frames);
  EXPECT_EQ(reacting.cycles, 2001);
  EXPECT_GT(reacting.min_distance->value, 0.03);
  ASSERT_EQ(reacting.robots.size(), 1u);
  EXPECT_EQ(reacting.robots[0].nearest->value, reacting.min_distance->value);
  EXPECT_FALSE(reacting.robots[0].nearest_person);
}

TEST(ClosedLoop, CheckEvaluatesEveryCycle) {
  SlideScene s("{repulsion: {range: 0.2, force: 100}}", thingComesTo(0.05));
  run::RunOptions options;
  options.end = 2.0;
  options.rate = 10.0;
  int cycles = 0;
  double least = kInfinity;
  options.on_cycle = [&](double t, const std::vector<query::PairResult>& results) {
    EXPECT_NEAR(t, 1e-3 * cycles, 1e-9);
    ++cycles;
    least = std::min(least, results[0].distance);
  };
  options.react = true;
  const run::RunSummary reacting = run::runScene(*s.session, options);
  EXPECT_EQ(cycles, 2001);
  EXPECT_EQ(least, reacting.min_distance->value);
  cycles = 0;
  options.react = false;
  options.on_cycle = [&](double, const std::vector<query::PairResult>&) { ++cycles; };
  run::runScene(*s.session, options);
  EXPECT_EQ(cycles, 21) << "frames alone";
}

TEST(ClosedLoop, RejectsRobotWithoutMassesWithPosition) {
  testing::ScratchFolder folder;
  const scene_file::SceneDescription scene = testing::sceneWithoutMasses(folder);
  session::SessionOptions options;
  options.cache = false;
  session::Session session(scene, options);
  try {
    ClosedLoop loop(session, 0.0);
    FAIL() << "it was taken";
  } catch (const ParseError& e) {
    EXPECT_EQ(e.pos().line, 3) << e.what();
  }
}

TEST(ClosedLoop, SnapshotReportsBrokenLimits) {
  testing::SlideScene inside("{}"), outside("{}", "", "    q: [5.5]\n");
  view::SceneSnapshot snapshot;
  ClosedLoop within(*inside.session, 0.0);
  within.capture(snapshot);
  ASSERT_EQ(snapshot.robots.size(), 1u);
  EXPECT_EQ(snapshot.robots[0].breach_count, 0u);
  ClosedLoop beyond(*outside.session, 0.0);
  for (int i = 0; i < 10; ++i) beyond.step();
  beyond.capture(snapshot);
  ASSERT_GE(snapshot.robots[0].breach_count, 1u);
  const mechanism::LimitBreach& breach = snapshot.robots[0].breaches[0];
  EXPECT_EQ(breach.kind, mechanism::LimitKind::kPosition);
  EXPECT_EQ(breach.limit, 5.0);
  EXPECT_NEAR(breach.value, 5.5, 0.01);
  EXPECT_GT(breach.count, 1);
}

}  // namespace closed_loop_test
}  // namespace abstand::loop
