// The correlation of girth / stature with stature, and what it makes of girths over all statures.
#include "humanmodel/girth_spread.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/transform.hpp"
#include "humanmodel/normal_distribution.hpp"
#include "humanmodel/population.hpp"

namespace abstand::humanmodel {
namespace girth_spread_test {

/// ANSUR II: girth / stature, mean and standard deviation, and a percentile of the girth, mm.
struct Measured {
  double men, men_sd, women, women_sd, women_5, men_95;
};
// In the order of GirthPlace.
constexpr std::array<Measured, kGirthPlaceCount> kMeasured{{{.603, .049, .582, .050, 824, 1207},
                                                            {.536, .063, .529, .060, 710, 1131},
                                                            {.581, .042, .627, .044, 901, 1149},
                                                            {.327, .013, .345, .015, 532, 601},
                                                            {.227, .016, .203, .012, 302, 443},
                                                            {.204, .020, .188, .019, 259, 418},
                                                            {.177, .012, .162, .011, 235, 348},
                                                            {.121, .006, .115, .005, 173, 230},
                                                            {.356, .033, .379, .033, 527, 723},
                                                            {.224, .017, .229, .017, 328, 443},
                                                            {.144, .007, .140, .007, 209, 273}}};

/// Correlation of girth / stature with stature, from the 5th or 95th percentile of the girth (m).
double correlation(double mean, double deviation, double percentile, Sex sex) {
  const StatureSpread stature = statureSpread(sex);
  const double girth = mean * stature.mean;
  const double cv_girth = std::abs(percentile - girth) / normalScore(0.95) / girth;
  const double cv_stature = stature.deviation / stature.mean, cv_ratio = deviation / mean;
  const double with_girth =
      (cv_girth * cv_girth + cv_stature * cv_stature - cv_ratio * cv_ratio) / (2.0 * cv_girth * cv_stature);
  return (with_girth * cv_girth - cv_stature) / cv_ratio;
}

/// Share of a sex whose girth is below `girth` (m): midpoint rule over the score of stature.
double shareBelow(GirthPlace place, double mean, double girth, Sex sex) {
  constexpr int kSteps = 4000;
  constexpr double kEnd = 8.0;
  const StatureSpread stature = statureSpread(sex);
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double score = kEnd * (2.0 * (i + 0.5) / kSteps - 1.0);
    const double height = stature.mean + stature.deviation * score;
    const double ratio_score =
        (girth / height - mean - girthShift(place, height, sex)) / girthDeviation(place, sex, false);
    sum += std::exp(-0.5 * score * score) * normalShare(ratio_score);
  }
  return sum * 2.0 * kEnd / kSteps / std::sqrt(2.0 * kPi);
}

TEST(GirthSpread, CorrelationFollowsFromPercentiles) {
  constexpr double kRounded = 0.0006;  // three decimals
  for (std::size_t i = 0; i < kGirthPlaceCount; ++i) {
    const Measured& m = kMeasured[i];
    const double men = correlation(m.men, m.men_sd, unit::mm(m.men_95), Sex::kMale),
                 women = correlation(m.women, m.women_sd, unit::mm(m.women_5), Sex::kFemale);
    EXPECT_NEAR(girthCorrelation(static_cast<GirthPlace>(i)), 0.5 * (men + women), kRounded) << i;
    EXPECT_LT(men, 0.0) << i;
    EXPECT_LT(women, 0.0) << i;
  }
}

TEST(GirthSpread, MarginalPercentilesMatchTable) {
  // The correlation is the mean of both sexes, which differ where girths are skewed: 1.2 % (waist, women).
  constexpr double kMeanOfSexes = 0.0125;
  for (std::size_t i = 0; i < kGirthPlaceCount; ++i) {
    const auto place = static_cast<GirthPlace>(i);
    const Measured& m = kMeasured[i];
    const double man = unit::mm(m.men_95), woman = unit::mm(m.women_5);
    EXPECT_GT(shareBelow(place, m.men, man * (1.0 + kMeanOfSexes), Sex::kMale), 0.95) << i;
    EXPECT_LT(shareBelow(place, m.men, man * (1.0 - kMeanOfSexes), Sex::kMale), 0.95) << i;
    EXPECT_GT(shareBelow(place, m.women, woman * (1.0 + kMeanOfSexes), Sex::kFemale), 0.05) << i;
    EXPECT_LT(shareBelow(place, m.women, woman * (1.0 - kMeanOfSexes), Sex::kFemale), 0.05) << i;
  }
}

TEST(GirthSpread, ShiftAndDeviationSumToMeasuredVariance) {
  // Over all statures rho^2 + (1 - rho^2) = 1; a known mass takes its part from the second term.
  for (std::size_t i = 0; i < kGirthPlaceCount; ++i)
    for (const Sex sex : {Sex::kFemale, Sex::kMale}) {
      const auto place = static_cast<GirthPlace>(i);
      const double s = sex == Sex::kMale ? kMeasured[i].men_sd : kMeasured[i].women_sd;
      const StatureSpread stature = statureSpread(sex);
      EXPECT_NEAR(std::hypot(girthShift(place, stature.mean + stature.deviation, sex),
                             girthDeviation(place, sex, false)),
                  s, 1e-12);
      EXPECT_LE(girthDeviation(place, sex, true), girthDeviation(place, sex, false));
      EXPECT_GT(girthDeviation(place, sex, true), 0.2 * s);
    }
}

}  // namespace girth_spread_test
}  // namespace abstand::humanmodel
