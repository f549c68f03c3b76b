#include "core/margin/margin_set.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.hpp"
#include "tests/core/margin/same_outcome.hpp"

namespace abstand::margin {
namespace {

/// A walk with stretches far away, near, and inside; some frames not seen at all.
ClearanceTrack walk(std::uint32_t seed, int frames) {
  std::mt19937 random(seed);
  std::normal_distribution<double> step(0.0, 0.03);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  ClearanceTrack track;
  double c = 0.5;
  for (int i = 0; i < frames; ++i) {
    c = std::clamp(c + step(random), -0.1, 2.0);
    track.t.push_back(0.01 * i);
    track.clearance.push_back(uniform(random) < 0.002 ? -kInfinity : c);
    track.between.push_back(uniform(random) < 0.01 ? c - 0.3 : c - 0.005);
    track.braking.push_back(uniform(random) < 0.1 ? c - 0.4 : kInfinity);
  }
  track.between.back() = kInfinity;
  return track;
}

TEST(MarginSets, OfOneTrackAreTheFrameByFramePass) {
  for (const int frames : {1, 63, 64, 65, 1000})
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      const ClearanceTrack track = walk(seed, frames);
      const MarginSets sets({&track});
      for (const MarginOptions& options : {MarginOptions{}, MarginOptions{0.05, 0.2}})
        for (double m = 0.0; m < 2.2; m += 0.07) {
          SCOPED_TRACE(testing::Message() << frames << " " << seed << " " << m);
          expectEqual(sets.outcome(std::vector{m}, options), outcome(track, m, options));
        }
    }
}

TEST(MarginSets, WithOneMarginForAllAreTheLeastOfAllTracks) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const ClearanceTrack a = walk(3 * seed, 700), b = walk(3 * seed + 1, 700), c = walk(3 * seed + 2, 700);
    const ClearanceTrack* all[] = {&a, &b, &c};
    const ClearanceTrack least = leastOf(all);
    const MarginSets sets({&a, &b, &c});
    for (double m = 0.0; m < 1.0; m += 0.09)
      expectEqual(sets.outcome(std::vector{m, m, m}, {}), outcome(least, m, {}));
  }
}

TEST(MarginSets, WithTheirOwnMarginsStopWhereAnyPartIsInside) {
  const ClearanceTrack hand{
      {0, 1, 2, 3}, {0.5, 0.3, 0.3, 0.5}, {0.3, 0.3, 0.3, kInfinity}, {0.2, 0.2, 0.2, 0.2}};
  const ClearanceTrack torso{
      {0, 1, 2, 3}, {0.9, 0.9, 0.6, 0.9}, {0.6, 0.6, 0.6, kInfinity}, {0.5, 0.5, -0.1, 0.5}};
  const MarginSets sets({&hand, &torso});
  EXPECT_EQ(sets.outcome(std::vector{0.2, 0.5}, {}).stops, 0);
  const MarginOutcome by_hand = sets.outcome(std::vector{0.4, 0.5}, {});
  EXPECT_EQ(by_hand.stops, 1);
  EXPECT_EQ(by_hand.missed_stops, 0);
  EXPECT_EQ(by_hand.stopped_time, 2.0);
  const MarginOutcome by_torso = sets.outcome(std::vector{0.2, 0.7}, {});
  EXPECT_EQ(by_torso.stops, 1);
  EXPECT_EQ(by_torso.missed_stops, 1);
  EXPECT_EQ(by_torso.stopped_time, 1.0);
}

TEST(MarginSets, RefuseTracksOfDifferentRecordings) {
  const ClearanceTrack a = walk(1, 10), b = walk(1, 11);
  EXPECT_THROW(MarginSets({&a, &b}), UsageError);
  EXPECT_THROW(MarginSets({}), UsageError);
}

}  // namespace
}  // namespace abstand::margin
