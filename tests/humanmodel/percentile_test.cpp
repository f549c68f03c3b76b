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

TEST(Percentile, LargeManMatchesClosedForm) {
  const HumanModel large = of(95.0, Sex::kMale), usual = meanOf(1.870, Sex::kMale);
  EXPECT_NEAR(large.height, 1.870, kRounding);
  EXPECT_NEAR(large.mass, 110.7, 1e-9);
  const auto side = [&](BodyPart part) {
    const double breadth = large.part(part).breadth - usual.part(part).breadth;
    const double depth = large.part(part).depth - usual.part(part).depth;
    return 0.25 * (breadth + depth);
  };
  // 1.645 x .033 x 1.870 m / 2 pi: +16 mm. Of the trunk, breadth and depth together: +21 mm.
  EXPECT_NEAR(side(BodyPart::kThighLeft), 0.016, 0.0005);
  EXPECT_NEAR(side(BodyPart::kTorso), 0.021, 0.0005);
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

TEST(Percentile, GirthsAreMeanPlusScoreTimesDeviation) {
  const BodySections mean = meanSections(1.8, {}, Sex::kFemale);
  const BodySections large = sectionsOfPercentile(90.0, 1.8, {}, Sex::kFemale);
  const double score = normalScore(0.9);
  EXPECT_NEAR(large[GirthPlace::kThigh].girth, mean[GirthPlace::kThigh].girth + score * 1.8 * .033,
              kRounding);
  EXPECT_NEAR(large[GirthPlace::kHead].girth, mean[GirthPlace::kHead].girth + score * 1.8 * .015, kRounding);
  const Section &waist = large[GirthPlace::kWaist], &usual = mean[GirthPlace::kWaist];
  EXPECT_NEAR(waist.girth, usual.girth + score * 1.8 * .060, kRounding);
  EXPECT_NEAR(waist.breadth / waist.girth, usual.breadth / usual.girth, kRounding);
  EXPECT_NEAR(waist.depth / waist.girth, usual.depth / usual.girth, kRounding);
  // A known mass explains r^2 of the variance: .79 of a woman's thigh.
  const BodySections heavy = meanSections(1.8, 90.0, Sex::kFemale);
  const BodySections wide = sectionsOfPercentile(90.0, 1.8, 90.0, Sex::kFemale);
  EXPECT_NEAR(wide[GirthPlace::kThigh].girth,
              heavy[GirthPlace::kThigh].girth + score * 1.8 * .033 * std::sqrt(1.0 - .79), kRounding);
  EXPECT_NEAR(wide[GirthPlace::kCalf].girth, heavy[GirthPlace::kCalf].girth + score * 1.8 * .017, kRounding);
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
    for (std::size_t i = 0; i < kBodyPartCount; ++i) {
      EXPECT_NEAR(half.parts[i].contour, usual.parts[i].contour, kRounding);
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

TEST(Percentile, StatureAndMassOverridePercentile) {
  const HumanModel m = of(95.0, Sex::kMale, 1.7);
  EXPECT_EQ(m.height, 1.7);
  EXPECT_NEAR(m.mass, 110.7, 1e-9);
  const double thigh = meanOf(1.7, Sex::kMale).part(BodyPart::kThighLeft).contour;
  EXPECT_NEAR(m.part(BodyPart::kThighLeft).contour, thigh + normalScore(.95) * 1.7 * .033, kRounding);
  const HumanModel lean = of(95.0, Sex::kMale, {}, 70.0);
  EXPECT_NEAR(lean.height, 1.870, kRounding);
  EXPECT_EQ(lean.mass, 70.0);
  EXPECT_LT(lean.part(BodyPart::kThighLeft).contour, of(95.0, Sex::kMale).part(BodyPart::kThighLeft).contour);
  EXPECT_GT(lean.part(BodyPart::kThighLeft).contour,
            meanOf(1.870, Sex::kMale, 70.0).part(BodyPart::kThighLeft).contour);
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
  EXPECT_THROW(of(95.0, Sex::kMale, 0.9), UsageError) << "110.7 kg at 0.9 m";
  EXPECT_THROW(of(95.0, Sex::kMale, {}, 20.0), UsageError) << "20 kg at 1.87 m";
  HumanOptions thesis;
  thesis.percentile = 50.0;
  thesis.preset = HumanPreset::kThesis;
  EXPECT_THROW(makeHuman(thesis), UsageError);
}

}  // namespace percentile_test
}  // namespace abstand::humanmodel
