#include "core/margin/safe_margin.hpp"

#include <gtest/gtest.h>

#include <random>

namespace abstand::margin {
namespace safe_margin_test {

/// Clearances, braking clearances and what lies between frames at random, some of them at or below 0.
ClearanceTrack randomTrack(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(-0.1, 0.1), loss(0.0, 0.3);
  ClearanceTrack track;
  double clearance = 0.4;
  for (int i = 0; i < 60; ++i) {
    clearance = std::abs(clearance + step(random));
    track.t.push_back(0.01 * i);
    track.clearance.push_back(clearance);
    track.braking.push_back(clearance - loss(random));
    track.between.push_back(clearance - 0.3 * loss(random));
  }
  track.between.back() = kInfinity;
  return from(track, firstJudgedFrame(track, {}));
}

TEST(SafeMargin, IsLargestMarginThatMissesStops) {
  int decided = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    const ClearanceTrack track = randomTrack(seed);
    if (track.frames() == 0) continue;
    const SafeMargin safe = smallestSafeMargin(track, {});
    for (double above = 1e-9; above < 2.0; above = 1.5 * above + 1e-3)
      EXPECT_EQ(outcome(track, safe.margin + above, {}).missed_stops, 0) << seed << " " << above;
    if (!safe.decided) {
      EXPECT_EQ(outcome(track, 0.0, {}).missed_stops, 0) << seed;
      continue;
    }
    ++decided;
    EXPECT_GT(outcome(track, safe.margin, {}).missed_stops, 0) << seed;
  }
  EXPECT_GT(decided, 100) << "do the tracks decide anything?";
}

TEST(SafeMargin, IsClearanceOneFrameBeforeLateStop) {
  const ClearanceTrack track{
      {0, 1, 2, 3}, {0.5, 0.4, 0.2, 0.3}, {0.4, 0.2, 0.2, kInfinity}, {0.3, 0.2, -0.1, 0.1}};
  const SafeMargin safe = smallestSafeMargin(track, {});
  EXPECT_TRUE(safe.decided);
  EXPECT_EQ(safe.margin, 0.4);
  EXPECT_EQ(safe.frame, 2u);
  EXPECT_DOUBLE_EQ(safe.sampling, 0.2);
}

TEST(SafeMargin, IsInfiniteIfFirstFrameIsTooNear) {
  const ClearanceTrack track{{0, 1, 2}, {0.1, 0.4, 0.5}, {0.1, 0.4, kInfinity}, {-0.1, 0.2, 0.4}};
  EXPECT_EQ(smallestSafeMargin(track, {}).margin, kInfinity);
  EXPECT_EQ(firstJudgedFrame(track, {}), 1u);
  EXPECT_FALSE(smallestSafeMargin(from(track, 1), {}).decided);
}

}  // namespace safe_margin_test
}  // namespace abstand::margin
