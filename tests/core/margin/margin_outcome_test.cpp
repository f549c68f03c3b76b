#include "core/margin/margin_outcome.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"

namespace abstand::margin {
namespace margin_outcome_test {

// Sums of frame times.
constexpr double kRounding = 1e-12;

/// 0.1 s a frame; nothing between frames is nearer than at them, and a stop always holds unless said.
ClearanceTrack trackOf(std::vector<double> clearance) {
  ClearanceTrack track;
  for (std::size_t i = 0; i < clearance.size(); ++i) {
    track.t.push_back(0.1 * static_cast<double>(i));
    track.between.push_back(i + 1 < clearance.size() ? std::min(clearance[i], clearance[i + 1]) : kInfinity);
  }
  track.braking.assign(clearance.size(), kInfinity);
  track.clearance = std::move(clearance);
  return track;
}

TEST(MarginOutcome, PersonOutsideCausesNoStop) {
  const MarginOutcome o = outcome(trackOf({0.5, 0.4, 0.5}), 0.3, {});
  EXPECT_EQ(o.stops, 0);
  EXPECT_EQ(o.missed_stops, 0);
  EXPECT_EQ(o.stopped_time, 0.0);
  EXPECT_EQ(o.min_clearance, 0.4);
  EXPECT_FALSE(o.lead_time);
}

TEST(MarginOutcome, CountsStopsTimesAndFalseStops) {
  // Two intrusions into 0.3 m: the first one never comes near, the second one touches.
  const ClearanceTrack track = trackOf({0.5, 0.2, 0.5, 0.25, 0.1, -0.01, 0.5});
  const MarginOutcome o = outcome(track, 0.3, {});
  EXPECT_EQ(o.stops, 2);
  EXPECT_EQ(o.false_stops, 1);
  EXPECT_EQ(o.missed_stops, 0);
  EXPECT_NEAR(o.stopped_time, 0.1 + 0.3, kRounding);
  EXPECT_NEAR(o.stoppedShare(), 0.4 / 0.6, kRounding);
  // Touched at 0.5 s (between the frames before: 0.4 s on), told at 0.3 s.
  ASSERT_TRUE(o.lead_time);
  EXPECT_NEAR(*o.lead_time, 0.1, kRounding);
}

TEST(MarginOutcome, LateStopIsMissed) {
  ClearanceTrack track = trackOf({0.5, 0.2, 0.5});
  track.braking[1] = -0.02;
  EXPECT_EQ(outcome(track, 0.3, {}).missed_stops, 1);
  EXPECT_EQ(outcome(track, 0.3, {}).min_clearance, -0.02);
  track.braking[1] = 0.05;
  EXPECT_EQ(outcome(track, 0.3, {}).missed_stops, 0);
  EXPECT_EQ(outcome(track, 0.3, {.limit = 0.05}).missed_stops, 1) << "at the limit counts as broken";
}

TEST(MarginOutcome, TouchBetweenFramesIsMissed) {
  ClearanceTrack track = trackOf({0.5, 0.4, 0.4, 0.5});
  track.between[1] = -0.01;
  const MarginOutcome o = outcome(track, 0.3, {});
  EXPECT_EQ(o.stops, 0);
  EXPECT_EQ(o.unseen, 1);
  EXPECT_EQ(o.missed_stops, 1);
  EXPECT_EQ(o.min_clearance, -0.01);
}

TEST(MarginOutcome, UnseenFramesAreInsideAndNoFalseStop) {
  ClearanceTrack track = trackOf({0.5, -kInfinity, 0.5});
  const MarginOutcome o = outcome(track, 0.0, {});
  EXPECT_EQ(o.stops, 1);
  EXPECT_EQ(o.false_stops, 0);
}

TEST(MarginOutcome, RestartTimesDoNotCountTwice) {
  // Inside at 0.1 s and again at 0.3 s; a restart of 0.5 s covers both and ends with the recording at 0.6 s.
  const ClearanceTrack track = trackOf({0.5, 0.2, 0.5, 0.2, 0.5, 0.5, 0.5});
  EXPECT_NEAR(outcome(track, 0.3, {.restart_time = 0.5}).stopped_time, 0.5, kRounding);
  EXPECT_NEAR(outcome(track, 0.3, {.restart_time = 0.15}).stopped_time, 0.2 + 0.25, kRounding);
}

TEST(MarginOutcome, RecordingsAddUp) {
  MarginOutcome all = outcome(trackOf({0.5, 0.2, 0.5}), 0.3, {});
  all.add(outcome(trackOf({0.5, 0.1, 0.1, 0.5, 0.5}), 0.3, {}));
  EXPECT_EQ(all.stops, 2);
  EXPECT_NEAR(all.time, 0.6, kRounding);
  EXPECT_NEAR(all.stopped_time, 0.3, kRounding);
}

TEST(Intrusions, MatchMarginOutcome) {
  ClearanceTrack track = trackOf({0.5, 0.2, 0.5, 0.25, 0.1, -0.01});
  track.braking[1] = -0.02;
  track.braking[3] = 0.05;
  const std::vector<Intrusion> all = intrusions(track, 0.3, {});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].begin, 1u);
  EXPECT_EQ(all[0].end, 2u);
  EXPECT_EQ(all[0].min_clearance, 0.2);
  EXPECT_TRUE(all[0].false_stop);
  EXPECT_TRUE(all[0].missed);
  EXPECT_FALSE(all[0].lead_time);
  EXPECT_EQ(all[1].begin, 3u);
  EXPECT_EQ(all[1].end, 6u) << "the recording ends inside";
  EXPECT_EQ(all[1].min_clearance, -0.01);
  EXPECT_EQ(all[1].braking, 0.05);
  EXPECT_FALSE(all[1].false_stop);
  EXPECT_FALSE(all[1].missed);
  ASSERT_TRUE(all[1].lead_time);
  EXPECT_NEAR(*all[1].lead_time, 0.1, kRounding);
}

TEST(ClearanceTrack, RejectsInvalidTracks) {
  ClearanceTrack track = trackOf({0.5, 0.4});
  EXPECT_NO_THROW(validate(track));
  track.t[1] = 0.0;
  EXPECT_THROW(validate(track), UsageError);
  track = trackOf({0.5, kNaN});
  EXPECT_THROW(validate(track), UsageError);
  track = trackOf({0.5, 0.4});
  track.braking.pop_back();
  EXPECT_THROW(validate(track), UsageError);
}

TEST(ClearanceTrack, LeastOfSeveralIsMinimumPerFrame) {
  const ClearanceTrack a = trackOf({0.5, 0.1}), b = trackOf({0.2, 0.4});
  const ClearanceTrack* both[] = {&a, &b};
  EXPECT_EQ(leastOf(both).clearance, (std::vector<double>{0.2, 0.1}));
  const ClearanceTrack longer = trackOf({0.2, 0.4, 0.5});
  const ClearanceTrack* different[] = {&a, &longer};
  EXPECT_THROW(leastOf(different), UsageError);
}

}  // namespace margin_outcome_test
}  // namespace abstand::margin
