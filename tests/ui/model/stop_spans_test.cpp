#include "ui/model/stop_spans.hpp"

#include <gtest/gtest.h>

namespace abstand::ui {
namespace stop_spans_test {

using safety::StopState;

view::SceneSnapshot snapshotAt(double t, StopState state, double since) {
  view::SceneSnapshot snapshot;
  snapshot.t = t;
  snapshot.loops = 1;
  snapshot.robots.resize(1);
  snapshot.robots[0].state = state;
  snapshot.robots[0].since = since;
  return snapshot;
}

std::vector<TimeRange> rangesOf(const StopSpans& stops) {
  std::vector<TimeRange> ranges;
  for (const StopSpan& span : stops.spans()) ranges.push_back(span.range);
  return ranges;
}

TEST(StopSpans, KeepRobotStateAndCauseOfTheirBeginning) {
  StopSpans stops;
  view::SceneSnapshot snapshot = snapshotAt(2.0, StopState::kRunning, 0.0);
  snapshot.robots.resize(2);
  snapshot.robots[1].state = StopState::kEmergencyStop;
  snapshot.robots[1].since = 1.5;
  snapshot.robots[1].cause = {safety::StopReason::kEnergy, 2.0, 1.0, 4, -1};
  ASSERT_TRUE(stops.add(snapshot));
  snapshot.t = 3.0;
  snapshot.robots[1].state = StopState::kWaitingForReset;
  ASSERT_TRUE(stops.add(snapshot));
  ASSERT_EQ(stops.spans().size(), 1u);
  EXPECT_EQ(stops.spans()[0].robot, 1);
  EXPECT_EQ(stops.spans()[0].state, StopState::kEmergencyStop);
  EXPECT_EQ(stops.spans()[0].cause.pair, 4);
  EXPECT_EQ(stops.spans()[0].range, (TimeRange{1.5, 3.0}));
}

TEST(StopSpans, LastFromStopUntilResume) {
  StopSpans stops;
  EXPECT_FALSE(stops.add(snapshotAt(1.0, StopState::kRunning, 0.0)));
  EXPECT_TRUE(stops.add(snapshotAt(2.0, StopState::kProtectiveStop, 1.5)));
  EXPECT_EQ(rangesOf(stops), (std::vector<TimeRange>{{1.5, 2.0}}));
  EXPECT_TRUE(stops.add(snapshotAt(3.0, StopState::kWaitingForReset, 2.5)));
  EXPECT_EQ(rangesOf(stops), (std::vector<TimeRange>{{1.5, 3.0}})) << "still the same stand";
  EXPECT_TRUE(stops.add(snapshotAt(4.0, StopState::kRunning, 3.25)));
  EXPECT_EQ(rangesOf(stops), (std::vector<TimeRange>{{1.5, 3.25}}));
  EXPECT_FALSE(stops.add(snapshotAt(5.0, StopState::kRunning, 3.25)));
  EXPECT_TRUE(stops.add(snapshotAt(6.0, StopState::kProtectiveStop, 5.5)));
  EXPECT_EQ(stops.spans().size(), 2u);
}

TEST(StopSpans, StayUntilTheirBeginningIsPlayedAgain) {
  StopSpans stops;
  stops.add(snapshotAt(2.0, StopState::kProtectiveStop, 1.5));
  stops.add(snapshotAt(2.5, StopState::kRunning, 2.25));
  stops.add(snapshotAt(4.0, StopState::kProtectiveStop, 3.5));
  const auto again = [&](double t, StopState state, double since) {
    view::SceneSnapshot snapshot = snapshotAt(t, state, since);
    snapshot.loops = 2;
    return stops.add(snapshot);
  };
  EXPECT_FALSE(again(1.0, StopState::kRunning, 0.0));
  EXPECT_FALSE(again(1.4, StopState::kRunning, 0.0));
  EXPECT_EQ(rangesOf(stops), (std::vector<TimeRange>{{1.5, 2.25}, {3.5, 4.0}})) << "as they were played";
  EXPECT_TRUE(again(1.6, StopState::kRunning, 0.0));
  EXPECT_EQ(rangesOf(stops), (std::vector<TimeRange>{{3.5, 4.0}})) << "this time it did not stop";
  EXPECT_TRUE(again(3.75, StopState::kProtectiveStop, 3.25));
  EXPECT_TRUE(again(3.8, StopState::kRunning, 3.8));
  EXPECT_EQ(rangesOf(stops), (std::vector<TimeRange>{{3.25, 3.8}})) << "this time it stopped earlier";
  view::SceneSnapshot none = snapshotAt(4.0, StopState::kRunning, 0.0);
  none.robots.clear();
  EXPECT_TRUE(stops.add(none));
  EXPECT_TRUE(stops.spans().empty());
}

}  // namespace stop_spans_test
}  // namespace abstand::ui
