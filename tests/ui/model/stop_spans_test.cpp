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

TEST(StopSpans, LastFromStopUntilResume) {
  StopSpans stops;
  EXPECT_FALSE(stops.add(snapshotAt(1.0, StopState::kRunning, 0.0)));
  EXPECT_TRUE(stops.add(snapshotAt(2.0, StopState::kProtectiveStop, 1.5)));
  EXPECT_EQ(stops.spans(), (std::vector<TimeRange>{{1.5, 2.0}}));
  EXPECT_TRUE(stops.add(snapshotAt(3.0, StopState::kWaitingForReset, 2.5)));
  EXPECT_EQ(stops.spans(), (std::vector<TimeRange>{{1.5, 3.0}})) << "still the same stand";
  EXPECT_TRUE(stops.add(snapshotAt(4.0, StopState::kRunning, 3.25)));
  EXPECT_EQ(stops.spans(), (std::vector<TimeRange>{{1.5, 3.25}}));
  EXPECT_FALSE(stops.add(snapshotAt(5.0, StopState::kRunning, 3.25)));
  EXPECT_TRUE(stops.add(snapshotAt(6.0, StopState::kProtectiveStop, 5.5)));
  EXPECT_EQ(stops.spans().size(), 2u);
  view::SceneSnapshot again = snapshotAt(0.0, StopState::kRunning, 0.0);
  again.loops = 2;
  EXPECT_TRUE(stops.add(again));
  EXPECT_TRUE(stops.spans().empty());
}

}  // namespace stop_spans_test
}  // namespace abstand::ui
