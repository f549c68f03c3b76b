// Bodies of a percentile.
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "humanmodel/anthropometry.hpp"
#include "humanmodel/enclosed_share.hpp"
#include "humanmodel/girth_spread.hpp"
#include "humanmodel/normal_distribution.hpp"
#include "humanmodel/population.hpp"

namespace abstand::humanmodel {
namespace percentile_test {

constexpr double kRounding = 1e-12;
constexpr std::optional<Sex> kSexes[] = {{}, {Sex::kFemale}, {Sex::kMale}};

HumanModel of(double percentile, std::optional<Sex> sex, std::optional<double> height = {},
              std::optional<double> mass = {}) {
  HumanOptions options;
  options.percentile = percentile;
  options.sex = sex;
  options.height = height;
  options.mass = mass;
  return makeHuman(options);
}

HumanModel meanOf(double height, std::optional<Sex> sex, std::optional<double> mass = {}) {
  HumanOptions options;
  options.height = height;
  options.sex = sex;
  options.mass = mass;
  return makeHuman(options);
}

/// girth / stature of people of one stature, at a score of the percentile: mean m, deviation s, correlation
/// rho with stature, whose score is z.
double ratio(double m, double s, double rho, double z, double score, double by_mass = 0.0) {
  return m + rho * s * z + score * s * std::sqrt(1.0 - by_mass - rho * rho);
}

TEST(Percentile, LargeManMatchesClosedForm) {
  // Relative to the mean man of that stature, whose girths are a smaller share of it than those of all men.
  const HumanModel large = of(95.0, Sex::kMale), usual = of(50.0, Sex::kMale, 1.870);
  EXPECT_NEAR(large.height, 1.870, kRounding);
  EXPECT_NEAR(large.mass, 110.7, 1e-9);
  constexpr double kStated = 0.001;  // m, the documents state millimetres
  const auto side = [&](BodyPart part) {
    return 0.5 * (large.part(part).breadth - usual.part(part).breadth);
  };
  const auto front = [&](BodyPart part) { return 0.5 * (large.part(part).depth - usual.part(part).depth); };
  const double thigh = normalScore(.95) * .033 * std::sqrt(1.0 - .165 * .165) * 1.870 / (2.0 * kPi);
  EXPECT_NEAR(side(BodyPart::kThighLeft), thigh, kRounding);
  EXPECT_NEAR(side(BodyPart::kThighLeft), 0.016, kStated);
  // The hips are broadest, the chest is deepest.
  const double hip = normalScore(.95) * .042 * std::sqrt(1.0 - .201 * .201) * 1.870 * .197 / .581;
  EXPECT_NEAR(side(BodyPart::kTorso), 0.5 * hip, kRounding);
  EXPECT_NEAR(side(BodyPart::kTorso), 0.021, kStated);
  const double chest = normalScore(.95) * .049 * std::sqrt(1.0 - .266 * .266) * 1.870 * .145 / .603;
  // The line in the body mass index gives .6036 instead of .603 for the mean chest.
  EXPECT_NEAR(front(BodyPart::kTorso), 0.5 * chest, 2e-4);
  EXPECT_NEAR(front(BodyPart::kTorso), 0.017, kStated);
  // Lengths are means.
  for (std::size_t i = 0; i < kBodyPartCount; ++i) {
    EXPECT_EQ(large.parts[i].length, usual.parts[i].length);
    EXPECT_GT(large.parts[i].contour, usual.parts[i].contour);
  }
}

TEST(Percentile, EnclosesStatedShareAtItsStature) {
  // The torso is the largest of three places in breadth and in depth: there the share may be larger.
  for (const std::optional<Sex> sex : kSexes)
    for (const double percentile : {1.0, 5.0, 25.0, 50.0, 75.0, 95.0, 99.0})
      for (const std::optional<double> height : {std::optional<double>{}, {1.55}, {1.95}}) {
        const HumanModel m = of(percentile, sex, height);
        const auto shares = enclosedShare(m, sex);
        for (const HumanPart& p : m.parts) {
          const double share = shares[index(p.part)].at_stature;
          if (p.part == BodyPart::kTorso)
            EXPECT_GE(share, 0.01 * percentile - 1e-9);
          else
            EXPECT_NEAR(share, 0.01 * percentile, 1e-9) << partName(p.part) << " " << m.height;
        }
      }
}

TEST(Percentile, GirthsMatchClosedForm) {
  const BodySections mean = meanSections(1.8, {}, Sex::kFemale);
  const BodySections large = sectionsOfPercentile(90.0, 1.8, {}, Sex::kFemale);
  const double score = normalScore(0.9), z = (1.8 - 1.6285) / .0642;
  const auto of_mean = [](const BodySections& s, GirthPlace place) { return s[place].girth / 1.8; };
  EXPECT_NEAR(large[GirthPlace::kThigh].girth,
              1.8 * ratio(of_mean(mean, GirthPlace::kThigh), .033, -.165, z, score), kRounding);
  EXPECT_NEAR(large[GirthPlace::kHead].girth, 1.8 * ratio(.345, .015, -.722, z, score), kRounding);
  const Section &waist = large[GirthPlace::kWaist], &usual = mean[GirthPlace::kWaist];
  EXPECT_NEAR(waist.girth, 1.8 * ratio(of_mean(mean, GirthPlace::kWaist), .060, -.185, z, score), kRounding);
  EXPECT_NEAR(waist.breadth / waist.girth, usual.breadth / usual.girth, kRounding);
  EXPECT_NEAR(waist.depth / waist.girth, usual.depth / usual.girth, kRounding);
  // A known mass explains r^2 of the variance, .79 of a woman's thigh, beside the stature's share.
  const BodySections heavy = meanSections(1.8, 90.0, Sex::kFemale);
  const BodySections wide = sectionsOfPercentile(90.0, 1.8, 90.0, Sex::kFemale);
  EXPECT_NEAR(wide[GirthPlace::kThigh].girth,
              1.8 * ratio(of_mean(heavy, GirthPlace::kThigh), .033, -.165, z, score, .79), kRounding);
  EXPECT_NEAR(wide[GirthPlace::kCalf].girth,
              1.8 * ratio(of_mean(heavy, GirthPlace::kCalf), .017, -.264, z, score), kRounding);
  // Farther than three standard deviations from the mean stature, proportions no longer change.
  for (const auto& [height, limit] : {std::pair{2.0, 3.0}, std::pair{1.3, -3.0}})
    EXPECT_NEAR(sectionsOfPercentile(90.0, height, {}, Sex::kFemale)[GirthPlace::kHead].girth,
                height * ratio(.345, .015, -.722, limit, score), kRounding);
}

TEST(Percentile, GrowsWithPercentile) {
  for (const std::optional<Sex> sex : kSexes)
    for (double p = 1.0; p < 99.0; p += 1.0) {
      const HumanModel small = of(p, sex), large = of(p + 1.0, sex);
      EXPECT_GT(large.height, small.height);
      EXPECT_GT(large.mass, small.mass);
      for (std::size_t i = 0; i < kBodyPartCount; ++i) {
        const HumanPart &a = small.parts[i], &b = large.parts[i];
        EXPECT_GT(b.contour, a.contour) << partName(a.part) << " " << p;
        EXPECT_GT(b.breadth, a.breadth) << partName(a.part) << " " << p;
        EXPECT_GT(b.depth, a.depth) << partName(a.part) << " " << p;
      }
    }
}

TEST(Percentile, FiftyIsMeanPerson) {
  for (const Sex sex : {Sex::kFemale, Sex::kMale}) {
    const HumanModel half = of(50.0, sex), usual = meanOf(half.height, sex);
    // Median statures are up to 2.5 mm below means, which raises girths by up to 0.12 % (women's heads).
    for (std::size_t i = 0; i < kBodyPartCount; ++i) {
      EXPECT_NEAR(half.parts[i].contour / usual.parts[i].contour, 1.0, 0.0013);
      EXPECT_NEAR(half.parts[i].length, usual.parts[i].length, kRounding);
    }
    // Medians of mass lie below means, by 1.5 % at most.
    EXPECT_LT(half.mass, usual.mass);
    EXPECT_NEAR(half.mass, usual.mass, 0.015 * usual.mass);
  }
  // Without sex parts also enclose where women and men differ in proportions: 1.5 % of a torso's contour.
  const HumanModel half = of(50.0, {}), usual = meanOf(half.height, {});
  EXPECT_NEAR(half.height, 0.5 * (1.755 + 1.626), 0.005);
  EXPECT_NEAR(half.mass, usual.mass, 0.015 * usual.mass);
  for (std::size_t i = 0; i < kBodyPartCount; ++i)
    EXPECT_NEAR(half.parts[i].contour / usual.parts[i].contour, 1.0, 0.016) << partName(half.parts[i].part);
}

TEST(Percentile, FiftyFollowsStature) {
  // Half of the people of a stature: heads of tall people are a smaller share of it, those of short people a
  // larger one. Without a percentile the share is that of the mean person.
  for (const auto& [height, z] : {std::pair{1.5562, -200.0 / 68.6}, std::pair{1.9, 143.8 / 68.6}})
    EXPECT_NEAR(of(50.0, Sex::kMale, height).part(BodyPart::kHead).contour,
                height * ratio(.327, .013, -.722, z, 0.0), kRounding);
}

TEST(Percentile, StatureAndMassOverridePercentile) {
  const HumanModel m = of(95.0, Sex::kMale, 1.7);
  EXPECT_EQ(m.height, 1.7);
  EXPECT_NEAR(m.mass, 110.7 * std::pow(1.7 / 1.870, 2), 1e-9);
  const double thigh = meanOf(1.7, Sex::kMale).part(BodyPart::kThighLeft).contour / 1.7;
  EXPECT_NEAR(m.part(BodyPart::kThighLeft).contour,
              1.7 * ratio(thigh, .033, -.165, (1.7 - 1.7562) / .0686, normalScore(.95)), kRounding);
  const HumanModel lean = of(95.0, Sex::kMale, {}, 70.0);
  EXPECT_NEAR(lean.height, 1.870, kRounding);
  EXPECT_EQ(lean.mass, 70.0);
  EXPECT_LT(lean.part(BodyPart::kThighLeft).contour, of(95.0, Sex::kMale).part(BodyPart::kThighLeft).contour);
  EXPECT_GT(lean.part(BodyPart::kThighLeft).contour,
            meanOf(1.870, Sex::kMale, 70.0).part(BodyPart::kThighLeft).contour);
}

TEST(Percentile, MassKeepsBodyMassIndexAtGivenStature) {
  for (const std::optional<Sex> sex : kSexes)
    for (const double percentile : {1.0, 5.0, 50.0, 95.0, 99.0}) {
      const HumanModel own = of(percentile, sex);
      EXPECT_EQ(own.mass, massOfPercentile(percentile, sex));
      const double bmi = own.mass / (own.height * own.height);
      for (const double height : {0.6, 1.5, 1.95, 2.4})
        EXPECT_NEAR(of(percentile, sex, height).mass, bmi * height * height, 1e-9) << percentile;
      EXPECT_NEAR(of(percentile, sex, own.height).mass, own.mass, 1e-9);
    }
  EXPECT_NEAR(of(95.0, Sex::kMale, 1.6).mass, 81.04, 0.005);
  EXPECT_NEAR(of(5.0, Sex::kFemale, 1.95).mass, 83.88, 0.005);
}

TEST(Percentile, ExtremesStandFromFloorToStature) {
  for (const std::optional<Sex> sex : kSexes)
    for (const double percentile : {1.0, 99.0}) {
      const HumanModel m = of(percentile, sex);
      double mass = 0.0;
      for (const HumanPart& p : m.parts) {
        mass += p.mass;
        if (kindOf(p.part) != PartKind::kFoot) continue;
        EXPECT_NEAR((m.rest[p.proximal] - p.p_proximal).z() - 0.5 * p.depth, 0.0, kRounding);
      }
      EXPECT_NEAR(mass, m.mass, kRounding * m.mass);
      EXPECT_NEAR(m.rest[Joint::kHeadTop].z(), m.height, kRounding);
    }
}

TEST(Percentile, RejectsOutOfRangeValues) {
  for (const double p : {0.0, 0.99, 99.01, 100.0, -5.0, kNaN, kInfinity})
    EXPECT_THROW(of(p, Sex::kMale), UsageError) << p;
  EXPECT_THROW(of(95.0, Sex::kMale, 0.4), UsageError) << "0.4 m";
  EXPECT_THROW(of(95.0, Sex::kMale, 0.9, 110.7), UsageError) << "110.7 kg at 0.9 m";
  EXPECT_THROW(of(95.0, Sex::kMale, {}, 20.0), UsageError) << "20 kg at 1.87 m";
  HumanOptions thesis;
  thesis.percentile = 50.0;
  thesis.preset = HumanPreset::kThesis;
  EXPECT_THROW(makeHuman(thesis), UsageError);
}

}  // namespace percentile_test
}  // namespace abstand::humanmodel
