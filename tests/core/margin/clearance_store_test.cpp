#include "core/margin/clearance_store.hpp"

#include <gtest/gtest.h>

#include "tests/core/margin/stored_pairs.hpp"

namespace abstand::margin {
namespace clearance_store_test {

TEST(HalfFloat, RoundsToStatedSideWithinOneStep) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-9.0, 3.0);
  for (int i = 0; i < 20000; ++i) {
    const double value = (i % 2 ? 1.0 : -1.0) * std::pow(10.0, exponent(random));
    const double below = fromHalf(halfBelow(value)), above = fromHalf(halfAbove(value));
    EXPECT_LE(below, value);
    EXPECT_GE(above, value);
    // 11 significant bits; 2^-24 is the smallest step of all.
    const double step = std::max(std::abs(value) * std::ldexp(1.0, -10), std::ldexp(1.0, -24));
    EXPECT_LE(above - below, step * 1.0000001) << value;
  }
  for (const double v : {0.0, 0.5, -0.25, kInfinity, -kInfinity}) {
    EXPECT_EQ(fromHalf(halfBelow(v)), v);
    EXPECT_EQ(fromHalf(halfAbove(v)), v);
  }
  EXPECT_EQ(fromHalf(halfBelow(std::nan(""))), -kInfinity);
  EXPECT_EQ(fromHalf(halfAbove(std::nan(""))), kInfinity);
  EXPECT_EQ(fromHalf(halfBelow(1e9)), 65504.0);
}

TEST(ClearanceStore, ReturnsStoredValues) {
  for (const std::size_t frames : {1u, 255u, 256u, 257u, 900u}) {
    const StoredPairs pairs = storedPairs(3, 3, 4, frames);
    const ClearanceStore store = pairs.store();
    ASSERT_EQ(store.frames(), frames);
    for (std::size_t k = 0; k < 3; ++k) {
      const ClearanceTrack track = pairs.track(k);
      for (std::size_t i = 0; i < frames; ++i) {
        const ClearanceChunk::Nearest nearest = store.nearest(k, i);
        const bool seen = std::isfinite(track.clearance[i]);
        EXPECT_EQ(store.t(i), track.t[i]);
        EXPECT_EQ(nearest.clearance, track.clearance[i]);
        EXPECT_EQ(nearest.between, track.between[i]);
        EXPECT_EQ(nearest.braking, track.braking[i]);
        EXPECT_EQ(nearest.closing, 0.25);
        if (seen) {
          EXPECT_EQ(nearest.distance, track.clearance[i] + 0.015625);
        }
        EXPECT_EQ(nearest.unknown, !seen || pairs.at(i, k * 4).lost);
        EXPECT_EQ(pairs.at(i, k * 4 + nearest.link).clearance, track.clearance[i]);
      }
    }
  }
}

TEST(ClearanceStore, NeverOverestimatesPairClearance) {
  const StoredPairs pairs = storedPairs(11, 3, 5, 700);
  const ClearanceStore store = pairs.store();
  std::size_t exact = 0;
  for (std::size_t i = 0; i < 700; ++i)
    for (std::size_t p = 0; p < pairs.pairs(); ++p) {
      const ClearanceChunk& chunk = *store.chunks()[i / ClearanceChunk::kFrames];
      const double kept = chunk.pairClearance(p, i % ClearanceChunk::kFrames);
      const double nearest = store.nearest(pairs.layout->pairs[p].part, i).clearance;
      const double clearance = pairs.at(i, p).clearance;
      EXPECT_LE(kept, clearance);
      if (std::isfinite(clearance)) {
        EXPECT_GT(kept + ClearanceChunk::kStep, std::min(clearance, nearest + ClearanceChunk::kBeside));
      }
      exact += kept == clearance;
    }
  EXPECT_GT(exact, 700 * pairs.pairs() / 3);
}

TEST(ClearanceStore, RangesMatchFrameByFrame) {
  const StoredPairs pairs = storedPairs(5, 2, 3, 1500);
  const ClearanceStore store = pairs.store();
  std::mt19937 random(2);
  for (int n = 0; n < 3000; ++n) {
    const std::size_t part = random() % 2, begin = random() % 1500;
    const std::size_t end = begin + 1 + random() % (n % 3 ? 40 : 900);
    ClearanceStore::Look expected;
    expected.unknown = end > 1500;
    std::size_t least = begin;
    for (std::size_t i = begin; i < std::min<std::size_t>(end, 1500); ++i) {
      const ClearanceChunk::Nearest nearest = store.nearest(part, i);
      if (nearest.unknown)
        expected.unknown = true;
      else
        expected.least = std::min(expected.least, nearest.clearance);
      if (nearest.clearance < store.nearest(part, least).clearance) least = i;
    }
    const ClearanceStore::Look look = store.look(part, begin, end);
    EXPECT_EQ(look.least, expected.least);
    EXPECT_EQ(look.unknown, expected.unknown);
    if (end <= 1500) {
      EXPECT_EQ(store.leastFrame(part, begin, end), least);
    }
  }
}

TEST(ClearanceStore, FindsFramesByTime) {
  const ClearanceStore store = storedPairs(5, 1, 1, 600).store();
  EXPECT_EQ(store.frameAt(-1.0), 0u);
  EXPECT_EQ(store.frameAt(3.0), 300u);
  EXPECT_EQ(store.frameAt(3.0099), 300u);
  EXPECT_EQ(store.frameAt(99.0), 599u);
}

TEST(ClearanceStore, NeedsFewBytesPerFrame) {
  // Four for the clearance, two for each other number, and one where something was not seen; the link is the
  // same in all frames. A quarter more for what each chunk has once.
  const StoredPairs pairs = storedPairs(8, 28, 1, 2560);
  EXPECT_LT(static_cast<double>(pairs.store().bytes()), 1.25 * 15.0 * 28.0 * 2560.0);
}

}  // namespace clearance_store_test
}  // namespace abstand::margin
