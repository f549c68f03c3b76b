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

TEST(UnseenRate, MatchesClosedForm) {
  EXPECT_EQ(unseenRate(0.0), INFINITY);
  EXPECT_EQ(unseenTimeShare(0.0), 1.0);
  EXPECT_NEAR(unseenRate(1.0), -std::log(0.05), 1e-12);
  EXPECT_NEAR(unseenRate(1000.0), 3.0 / 1000.0, 0.01 * 3.0 / 1000.0) << "the rule of three";
  // The same number of whole units as of independent recordings.
  EXPECT_NEAR(unseenTimeShare(12.0), unseenShare(12), 1e-12);
  EXPECT_NEAR(unseenTimeShare(0.5), 1.0 - 0.05 * 0.05, 1e-12);
  // Nothing in twice the time halves the rate, whatever the unit.
  EXPECT_DOUBLE_EQ(unseenRate(60.0 * 7.3) * 60.0, unseenRate(7.3));
  EXPECT_GT(unseenRate(3.0, 0.99), unseenRate(3.0, 0.95));
}

TEST(UnseenRate, HoldsForMaximumOfPoissonProcess) {
  // Stretches come as a Poisson process and need margins that are uniform in 0 to 1. The rate of those that
  // need more than the largest of T minutes exceeds the limit in 5 % of all recordings of T minutes; and the
  // share of unseen minutes with such a stretch, counted in further minutes, exceeds its limit on average in
  // no more.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  constexpr int kSamples = 20000;
  constexpr double kMinutes = 7.3, kRate = 2.0;
  std::poisson_distribution<int> recorded(kRate * kMinutes), in_a_minute(kRate);
  int broken = 0;
  for (int s = 0; s < kSamples; ++s) {
    double largest = 0.0;
    for (int i = recorded(random); i > 0; --i) largest = std::max(largest, uniform(random));
    broken += kRate * (1.0 - largest) > unseenRate(kMinutes);
  }
  // Three standard deviations of a share of 5 %.
  const double tolerance = 3.0 * std::sqrt(0.05 * 0.95 / kSamples);
  EXPECT_NEAR(static_cast<double>(broken) / kSamples, 0.05, tolerance);
  // A margin at the limit itself: the share of minutes with a violation is the one stated.
  const double margin = 1.0 - unseenRate(kMinutes) / kRate;
  int violated = 0;
  for (int s = 0; s < kSamples; ++s) {
    bool over = false;
    for (int i = in_a_minute(random); i > 0; --i) over = uniform(random) > margin || over;
    violated += over;
  }
  const double share = unseenTimeShare(kMinutes);
  EXPECT_NEAR(static_cast<double>(violated) / kSamples, share,
              3.0 * std::sqrt(share * (1 - share) / kSamples));
}

TEST(GumbelFit, CriticalMisfitIsExceededByOneSampleInTwenty) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const GumbelFit truth{0.3, 0.05, 0.0};
  for (const std::size_t count : {5u, 7u, 12u, 30u, 100u, 300u}) {
    constexpr int kSamples = 4000;
    int above = 0;
    std::vector<double> values(count);
    for (int s = 0; s < kSamples; ++s) {
      for (double& v : values) v = truth.quantile(uniform(random));
      above += fitGumbel(values)->misfit > criticalMisfit(count);
    }
    // The approximation of the critical misfit within 3 % moves the share of 5 % by about 1.5 %.
    EXPECT_NEAR(static_cast<double>(above) / kSamples, 0.05, 0.025) << count;
  }
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
