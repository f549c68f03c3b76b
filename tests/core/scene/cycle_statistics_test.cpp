#include "core/scene/cycle_statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/math/transform.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::scene {
namespace cycle_statistics_test {

// Half a bin of 1 %, with room for rounding of the bin's edge.
constexpr double kBinTolerance = 0.00505;

TEST(CycleStatistics, EmptyIsZero) {
  const CycleStatistics s(1e-3);
  EXPECT_EQ(s.median(), 0.0);
  EXPECT_EQ(s.max(), 0.0);
  EXPECT_EQ(s.mean(), 0.0);
  EXPECT_EQ(s.overruns(), 0);
}

TEST(CycleStatistics, QuantilesMatchSortedTimes) {
  CycleStatistics s(1e-3);
  std::vector<double> times;
  for (std::uint64_t i = 0; i < 20000; ++i)
    times.push_back(std::pow(10.0, -7.5 + 6.0 * testing::randomUnit(i, 3)));  // 32 ns to 32 ms
  for (const double t : times) s.add(t);
  std::sort(times.begin(), times.end());
  for (const double share : {0.01, 0.1, 0.5, 0.9, 0.99, 0.999}) {
    const double expected = times[static_cast<std::size_t>(share * 20000.0 - 0.5)];
    EXPECT_NEAR(s.quantile(share) / expected, 1.0, kBinTolerance) << share;
  }
  EXPECT_EQ(s.max(), times.back());
  EXPECT_EQ(s.quantile(1.0), times.back());
  EXPECT_EQ(s.min(), times.front());
  EXPECT_EQ(s.count(), 20000);
  EXPECT_EQ(s.overruns(), std::count_if(times.begin(), times.end(), [](double t) { return t > 1e-3; }));
}

TEST(CycleStatistics, OutliersStayInside) {
  CycleStatistics s(kInfinity);
  for (const double t : {-1.0, 0.0, kNaN, 1e-12, 1e9}) s.add(t);
  EXPECT_EQ(s.count(), 5);
  EXPECT_EQ(s.max(), 1e9);
  EXPECT_EQ(s.min(), 0.0);
  EXPECT_LE(s.median(), 1.01e-8);
  EXPECT_EQ(s.overruns(), 0);
  s.clear();
  EXPECT_EQ(s.count(), 0);
  EXPECT_EQ(s.p99(), 0.0);
}

TEST(CycleStatistics, OneTimeIsExact) {
  CycleStatistics s(1e-4);
  s.add(1.0e-4);
  s.add(1.0e-4);
  EXPECT_EQ(s.median(), 1.0e-4);
  EXPECT_EQ(s.p999(), 1.0e-4);
  EXPECT_EQ(s.overruns(), 0) << "the period itself is no overrun";
}

TEST(CycleStatistics, AddAllocatesNothing) {
  CycleStatistics s(1e-3);
  const testing::NoAlloc guard;
  for (int i = 1; i < 1000; ++i) s.add(i * 1e-6);
  EXPECT_EQ(guard.count(), 0);
}

TEST(CycleStatistics, PeriodMustBePositive) {
  for (const double period : {0.0, -1.0, kNaN}) EXPECT_THROW(CycleStatistics{period}, UsageError) << period;
}

}  // namespace cycle_statistics_test
}  // namespace abstand::scene
