// The least value of a function that is sampled: never missed, and found.
#include "core/safety/swept_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "core/math/random.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::safety {
namespace swept_distance_test {

// Ways are rounded up by a part of 10^12.
constexpr double kRounding = 1e-11;

/// A sum of sines with its exact bound on the slope, and errors of the samples.
struct Wave {
  double offset, size[3], rate[3], phase[3];
  explicit Wave(Random& random) : offset(random.between(-0.5, 1.0)) {
    for (int i = 0; i < 3; ++i) {
      size[i] = random.between(0.0, 0.5);
      rate[i] = random.between(0.5, 20.0);
      phase[i] = random.between(0.0, 2 * kPi);
    }
  }
  double at(double t) const {
    double sum = offset;
    for (int i = 0; i < 3; ++i) sum += size[i] * std::sin(rate[i] * t + phase[i]);
    return sum;
  }
  double slope() const { return size[0] * rate[0] + size[1] * rate[1] + size[2] * rate[2]; }
};

TEST(SweptDistance, IsNeverAboveMinimumAndConverges) {
  constexpr double kTolerance = 1e-3;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(11, seed);
    const Wave wave(random);
    const double duration = random.between(0.05, 1.0), error = random.chance(0.5) ? 2e-4 : 0.0;
    double least = kInfinity;
    for (int i = 0; i <= 20000; ++i) least = std::min(least, wave.at(duration * i / 20000));
    const auto sample = [&](double t) { return DistanceSample{wave.at(t) - error, wave.at(t)}; };
    const auto rate = [&](double, double) { return wave.slope(); };

    // However few samples there are.
    double before = -kInfinity;
    for (const int most : {2, 4, 8, 16, 512}) {
      const SweptResult r =
          sweptDistance(duration, sample, rate, {.tolerance = kTolerance, .max_samples = most});
      ASSERT_LE(r.lower, least + kRounding) << most;
      // 20000 samples may miss the least by slope * step / 2.
      ASSERT_GE(r.upper, least - 0.5 * wave.slope() * duration / 20000 - kRounding);
      ASSERT_NEAR(r.upper, wave.at(r.t), kRounding);
      ASSERT_LE(r.samples, most);
      ASSERT_GE(r.lower, before - kRounding) << "more samples never prove less";
      before = r.lower;
      if (most == 512) {
        ASSERT_TRUE(r.done);
        ASSERT_LE(r.upper - r.lower, kTolerance + error + kRounding);
      }
    }
  }
}

TEST(SweptDistance, ConstantDistanceNeedsTwoSamples) {
  const SweptResult r = sweptDistance(
      1.0,
      [](double) {
        return DistanceSample{0.3, 0.3};
      },
      [](double, double) { return 0.0; }, {});
  EXPECT_EQ(r.samples, 2);
  EXPECT_TRUE(r.done);
  EXPECT_NEAR(r.lower, 0.3, kRounding);
}

TEST(SweptDistance, StopsEarlyOnceDecided) {
  const auto away = [](double t) { return DistanceSample{1.0 + t, 1.0 + t}; };
  const auto rate = [](double, double) { return 1.5; };
  const SweptResult far = sweptDistance(1.0, away, rate, {.enough = 0.5});
  EXPECT_TRUE(far.done);
  EXPECT_EQ(far.samples, 2);
  EXPECT_GE(far.lower, 0.5);
  const auto through = [](double t) { return DistanceSample{0.5 - t, 0.5 - t}; };
  const SweptResult hit = sweptDistance(1.0, through, rate, {.tolerance = 0.0, .hit = 0.0});
  EXPECT_TRUE(hit.done);
  EXPECT_EQ(hit.samples, 2);
  EXPECT_EQ(hit.upper, -0.5);
}

TEST(SweptDistance, UnboundedSpeedIsNeverCertain) {
  const SweptResult r = sweptDistance(
      1.0,
      [](double) {
        return DistanceSample{1.0, 1.0};
      },
      [](double, double) { return kInfinity; }, {.max_samples = 16});
  EXPECT_FALSE(r.done);
  EXPECT_EQ(r.lower, -kInfinity);
  EXPECT_EQ(r.samples, 16);
}

TEST(SweptDistance, ZeroDurationIsTheSample) {
  const SweptResult r = sweptDistance(
      0.0,
      [](double) {
        return DistanceSample{0.9, 1.0};
      },
      [](double, double) { return kInfinity; }, {});
  EXPECT_EQ(r.lower, 0.9);
  EXPECT_EQ(r.upper, 1.0);
  EXPECT_TRUE(r.done);
}

TEST(MinBetween, MatchesClosedForm) {
  // Down from 1 and from 0.8 at 1 m/s for 1 s: they meet at 0.4.
  EXPECT_NEAR(minBetween(1.0, 0.8, 1.0, 1.0), 0.4, kRounding);
  // An end that is worse than the other one allows is lifted by it.
  EXPECT_NEAR(minBetween(1.0, -5.0, 1.0, 1.0), 0.0, kRounding);
  EXPECT_NEAR(minBetween(1.0, 0.8, 0.0, 1.0), 1.0, kRounding);
  EXPECT_EQ(minBetween(0.7, 0.7, kInfinity, 0.0), 0.7);
}

TEST(SweptDistance, AllocatesNothing) {
  Random random(1, 1);
  const Wave wave(random);
  const testing::NoAlloc guard;
  const SweptResult r = sweptDistance(
      1.0,
      [&](double t) {
        return DistanceSample{wave.at(t), wave.at(t)};
      },
      [&](double, double) { return wave.slope(); }, {.max_samples = 512});
  EXPECT_EQ(guard.count(), 0);
  EXPECT_GT(r.samples, 2);
}

TEST(SweptOptions, RejectOutOfRangeValues) {
  SweptOptions o;
  o.validate();
  o.max_samples = 1;
  EXPECT_THROW(o.validate(), UsageError);
  o = {.tolerance = -1.0};
  EXPECT_THROW(o.validate(), UsageError);
}

}  // namespace swept_distance_test
}  // namespace abstand::safety
