#include "core/margin/threshold_masks.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::margin {
namespace threshold_masks_test {

TEST(ThresholdMasks, MatchComparisonWithEachValue) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> step(-3, 20);  // coarse: values repeat, and thresholds hit them
  for (std::size_t count : {0, 1, 2, 31, 32, 33, 63, 64})
    for (int round = 0; round < 20; ++round) {
      std::vector<double> values;
      for (std::size_t i = 0; i < count; ++i) {
        const int s = step(random);
        values.push_back(s == -3 ? -kInfinity : s == -2 ? kInfinity : 0.1 * s);
      }
      const ThresholdMasks masks(values);
      for (double threshold : {-kInfinity, -1.0, 0.0, 0.1, 0.3, 0.1 * 7, 0.75, 1.9, 2.0, 5.0, kInfinity}) {
        std::uint64_t expected = 0;
        for (std::size_t i = 0; i < count; ++i) expected |= std::uint64_t{values[i] < threshold} << i;
        EXPECT_EQ(masks.below(threshold), expected) << count << " values, threshold " << threshold;
      }
    }
}

}  // namespace threshold_masks_test
}  // namespace abstand::margin
