// Statures and masses of ANSUR II.
#include "humanmodel/population.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "humanmodel/normal_distribution.hpp"

namespace abstand::humanmodel {
namespace population_test {

constexpr double kRounding = 1e-12;
constexpr std::optional<Sex> kBoth{};

TEST(NormalDistribution, ShareAndScoreAreInverse) {
  EXPECT_EQ(normalShare(0.0), 0.5);
  EXPECT_NEAR(normalShare(1.0), 0.841344746068543, 1e-15);
  EXPECT_NEAR(normalScore(0.95), 1.6448536269514722, 1e-14);
  EXPECT_NEAR(normalScore(0.01), -2.3263478740408408, 1e-14);
  for (double share = 0.01; share < 1.0; share += 0.01)
    EXPECT_NEAR(normalShare(normalScore(share)), share, 1e-15);
}

TEST(Population, PercentilesMatchTable) {
  struct Row {
    double percentile, man, woman, man_kg, woman_kg;
  };
  const Row table[] = {{1.0, 1602, 1483, 57.8, 46.7},   {2.5, 1627, 1504, 60.8, 48.9},
                       {5.0, 1648, 1525, 64.4, 51.3},   {50.0, 1755, 1626, 84.6, 66.8},
                       {95.0, 1870, 1740, 110.7, 87.1}, {97.5, 1897, 1758, 116.4, 92.4},
                       {99.0, 1927, 1778, 124.2, 97.5}};
  for (const Row& row : table) {
    EXPECT_NEAR(statureOfPercentile(row.percentile, Sex::kMale), unit::mm(row.man), kRounding);
    EXPECT_NEAR(statureOfPercentile(row.percentile, Sex::kFemale), unit::mm(row.woman), kRounding);
    EXPECT_NEAR(massOfPercentile(row.percentile, Sex::kMale), row.man_kg, 100.0 * kRounding);
    EXPECT_NEAR(massOfPercentile(row.percentile, Sex::kFemale), row.woman_kg, 100.0 * kRounding);
  }
  // Statures are nearly normal: the tables of percentiles and of means stay within 6 mm (women at 95 %).
  for (double p = 5.0; p <= 95.0; p += 1.0)
    for (const Sex sex : {Sex::kFemale, Sex::kMale}) {
      const StatureSpread s = statureSpread(sex);
      EXPECT_NEAR(statureOfPercentile(p, sex), s.mean + s.deviation * normalScore(0.01 * p), 0.006) << p;
    }
}

TEST(Population, GrowsWithPercentile) {
  for (const std::optional<Sex> sex : {kBoth, {Sex::kFemale}, {Sex::kMale}})
    for (double p = 1.0; p < 99.0; p += 0.5) {
      EXPECT_LT(statureOfPercentile(p, sex), statureOfPercentile(p + 0.5, sex)) << p;
      EXPECT_LT(massOfPercentile(p, sex), massOfPercentile(p + 0.5, sex)) << p;
    }
}

TEST(Population, UnspecifiedSexIsHalfWomenHalfMen) {
  for (double p = 1.0; p <= 99.0; p += 7.0) {
    const double stature = statureOfPercentile(p, kBoth);
    EXPECT_GE(stature, statureOfPercentile(p, Sex::kFemale));
    EXPECT_LE(stature, statureOfPercentile(p, Sex::kMale));
    // The share of both below it, from the shares of each sex, which are searched for here.
    double below = 0.0;
    for (const Sex sex : {Sex::kFemale, Sex::kMale}) {
      double low = 1e-6, high = 100.0 - 1e-6;
      for (int i = 0; i < 60; ++i)
        (statureOfPercentile(0.5 * (low + high), sex) < stature ? low : high) = 0.5 * (low + high);
      below += 0.5 * low;
    }
    EXPECT_NEAR(below, p, 1e-5);
  }
}

TEST(Population, SexSharesAtStatureSumToOne) {
  for (const double h : {0.5, 1.3, 1.6, 1.7, 1.8, 2.0, 2.5})
    EXPECT_NEAR(shareOfSexAt(h, Sex::kFemale) + shareOfSexAt(h, Sex::kMale), 1.0, kRounding);
  EXPECT_GT(shareOfSexAt(1.5, Sex::kFemale), 0.9);
  EXPECT_GT(shareOfSexAt(1.9, Sex::kMale), 0.9);
  const auto density = [](double h, const StatureSpread& s) {
    return std::exp(-0.5 * std::pow((h - s.mean) / s.deviation, 2)) / s.deviation;
  };
  const double women = density(1.68, statureSpread(Sex::kFemale)),
               men = density(1.68, statureSpread(Sex::kMale));
  EXPECT_NEAR(shareOfSexAt(1.68, Sex::kFemale), women / (women + men), kRounding);
}

}  // namespace population_test
}  // namespace abstand::humanmodel
