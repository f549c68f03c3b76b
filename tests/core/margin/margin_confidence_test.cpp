#include "core/margin/margin_confidence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace abstand::margin {
namespace margin_confidence_test {

TEST(UnseenShare, MatchesRuleOfThree) {
  EXPECT_EQ(unseenShare(0), 1.0);
  EXPECT_NEAR(unseenShare(1), 0.95, 1e-12);
  EXPECT_NEAR(unseenShare(1000), 3.0 / 1000.0, 0.01 * 3.0 / 1000.0);
  EXPECT_LT(unseenShare(20, 0.9), unseenShare(20, 0.95));
}

TEST(UnseenShare, HoldsForMaximumOfSamples) {
  // The largest of n uniform values is exceeded by a share 1 - max of unseen ones, which is larger than the
  // bound in 5 % of all samples.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  constexpr int kSamples = 20000, kCount = 12;
  int broken = 0;
  for (int s = 0; s < kSamples; ++s) {
    double most = 0.0;
    for (int i = 0; i < kCount; ++i) most = std::max(most, uniform(random));
    broken += 1.0 - most > unseenShare(kCount);
  }
  // Three standard deviations of a share of 5 %.
  EXPECT_NEAR(static_cast<double>(broken) / kSamples, 0.05, 3.0 * std::sqrt(0.05 * 0.95 / kSamples));
}

TEST(GumbelFit, RecoversSampledDistribution) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const GumbelFit truth{0.3, 0.05, 0.0};
  std::vector<double> values;
  for (int i = 0; i < 5000; ++i) values.push_back(truth.quantile(uniform(random)));
  const auto fit = fitGumbel(values);
  ASSERT_TRUE(fit);
  // About four standard deviations of the estimates from 5,000 values.
  EXPECT_NEAR(fit->location, truth.location, 0.004);
  EXPECT_NEAR(fit->scale, truth.scale, 0.004);
  EXPECT_LT(fit->misfit, 0.03);
  EXPECT_NEAR(fit->probability(fit->quantile(0.99)), 0.99, 1e-12);
}

TEST(GumbelFit, RequiresDifferentValues) {
  EXPECT_FALSE(fitGumbel(std::vector<double>{0.1, 0.2, 0.3, 0.4}));
  EXPECT_FALSE(fitGumbel(std::vector<double>{0.1, 0.1, 0.1, 0.1, 0.1, 0.1}));
  EXPECT_FALSE(fitGumbel(std::vector<double>{0.1, 0.2, 0.3, 0.4, INFINITY}));
}

}  // namespace margin_confidence_test
}  // namespace abstand::margin
