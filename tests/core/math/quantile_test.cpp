#include "core/math/quantile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace abstand {
namespace quantile_test {

TEST(Quantile, DefinitionsDifferForFourValues) {
  const std::vector<double> values{3, 1, 2, 4};
  EXPECT_EQ(lowerQuantile(values, 0.5), 2.0);
  EXPECT_EQ(upperQuantile(values, 0.5), 3.0);
  EXPECT_EQ(nearestQuantile(values, 0.5), 3.0);
  EXPECT_EQ(nearestQuantile(values, 0.4), 2.0);
}

TEST(Quantile, MedianOfFiveIsSameInAllDefinitions) {
  for (const auto quantile : {lowerQuantile, upperQuantile, nearestQuantile})
    EXPECT_EQ(quantile({5, 1, 4, 2, 3}, 0.5), 3.0);
}

TEST(Quantile, EndsAreMinimumAndMaximum) {
  for (const auto quantile : {lowerQuantile, upperQuantile, nearestQuantile}) {
    EXPECT_EQ(quantile({7, 5, 9}, 0.0), 5.0);
    EXPECT_EQ(quantile({7, 5, 9}, 1.0), 9.0);
    EXPECT_EQ(quantile({7}, 0.3), 7.0);
    EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
  }
}

TEST(Quantile, MatchesCounting) {
  for (int n = 1; n <= 12; ++n) {
    std::vector<double> values(static_cast<std::size_t>(n));
    std::iota(values.begin(), values.end(), 1.0);
    const std::vector<double> sorted = values;
    std::reverse(values.begin(), values.end());
    for (int eighth = 0; eighth <= 8; ++eighth) {
      SCOPED_TRACE(testing::Message() << eighth << "/8 of " << n);
      // Sixty-fourths of whole numbers are exact.
      const double share = eighth / 8.0;
      const auto notAbove = [&](double v) {
        return static_cast<double>(std::upper_bound(sorted.begin(), sorted.end(), v) - sorted.begin());
      };
      const auto least =
          *std::find_if(sorted.begin(), sorted.end(), [&](double v) { return notAbove(v) >= share * n; });
      const auto above =
          std::find_if(sorted.begin(), sorted.end(), [&](double v) { return notAbove(v) > share * n; });
      EXPECT_EQ(lowerQuantile(values, share), least);
      EXPECT_EQ(upperQuantile(values, share), above == sorted.end() ? sorted.back() : *above);
    }
  }
}

}  // namespace quantile_test
}  // namespace abstand
