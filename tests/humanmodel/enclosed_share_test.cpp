// How many people fit into a model: closed form, chance, and counts of real people.
#include "humanmodel/enclosed_share.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "humanmodel/normal_distribution.hpp"
#include "humanmodel/population.hpp"

namespace abstand::humanmodel {
namespace enclosed_share_test {

HumanModel human(std::optional<double> height, std::optional<Sex> sex, std::optional<double> percentile = {},
                 HumanPreset preset = HumanPreset::kAnthropometric) {
  HumanOptions options;
  options.height = height;
  options.sex = sex;
  options.percentile = percentile;
  options.preset = preset;
  return makeHuman(options);
}

EnclosedShare share(const HumanModel& model, std::optional<Sex> sex, BodyPart part) {
  return enclosedShare(model, sex)[index(part)];
}

TEST(EnclosedShare, CalfMatchesClosedForm) {
  HumanModel m = human(1.8, Sex::kMale);
  for (const double girth : {0.35, 0.40, 0.45}) {
    HumanPart& calf = m.parts[index(BodyPart::kCalfLeft)];
    calf.breadth = calf.depth = girth / kPi;
    calf.contour = girth;
    // Mean, deviation and correlation with stature, whose scores are 0.64 and 2.67.
    const auto below = [&](double mean, double score) {
      const double rho = -.264;
      return normalShare((girth / 1.8 - mean - rho * .017 * score) / (.017 * std::sqrt(1.0 - rho * rho)));
    };
    const double men = below(.224, (1.8 - 1.7562) / .0686), women = below(.229, (1.8 - 1.6285) / .0642);
    EXPECT_NEAR(share(m, Sex::kMale, BodyPart::kCalfLeft).at_stature, men, 1e-12);
    const double share_of_women = shareOfSexAt(1.8, Sex::kFemale);
    EXPECT_NEAR(share(m, {}, BodyPart::kCalfLeft).at_stature,
                share_of_women * women + (1.0 - share_of_women) * men, 1e-12);
  }
}

TEST(EnclosedShare, AllStaturesMatchMonteCarlo) {
  // The normal model of the formula, people drawn one by one. Four standard errors of a share of 0.5.
  constexpr int kPeople = 200000;
  const double tolerance = 4.0 * 0.5 / std::sqrt(kPeople);
  struct Limb {
    BodyPart part;
    double men, men_sd, women, women_sd, rho;
  };
  // Girth / stature of limbs whose mean does not go by the lines in the body mass index (ANSUR II), and its
  // correlation with stature.
  const Limb limbs[] = {{BodyPart::kHead, .327, .013, .345, .015, -.722},
                        {BodyPart::kForearmLeft, .177, .012, .162, .011, -.243},
                        {BodyPart::kCalfRight, .224, .017, .229, .017, -.264}};
  for (const std::optional<double> percentile : {std::optional<double>{}, {20.0}, {95.0}})
    for (const std::optional<Sex> sex : {std::optional<Sex>{}, {Sex::kFemale}, {Sex::kMale}}) {
      // One sex: the head of a person without sex has proportions of its own.
      const HumanModel m =
          human(percentile ? std::optional<double>{} : 1.7, sex.value_or(Sex::kMale), percentile);
      for (const Limb& limb : limbs) {
        if (!sex && limb.part == BodyPart::kHead) continue;
        std::mt19937_64 random(7);
        std::normal_distribution<double> normal;
        int inside = 0;
        for (int i = 0; i < kPeople; ++i) {
          const Sex who = sex ? *sex : (i % 2 == 0 ? Sex::kFemale : Sex::kMale);
          const StatureSpread statures = statureSpread(who);
          const double score = normal(random);
          const double stature = statures.mean + statures.deviation * score;
          const double mean = who == Sex::kMale ? limb.men : limb.women;
          const double deviation = who == Sex::kMale ? limb.men_sd : limb.women_sd;
          const double ratio_score =
              limb.rho * std::clamp(score, -3.0, 3.0) + std::sqrt(1.0 - limb.rho * limb.rho) * normal(random);
          inside += stature * (mean + deviation * ratio_score) <= m.part(limb.part).contour ? 1 : 0;
        }
        EXPECT_NEAR(share(m, sex, limb.part).all_statures, inside / static_cast<double>(kPeople), tolerance)
            << partName(limb.part);
      }
    }
}

TEST(EnclosedShare, ThesisLimbsMatchCountedShares) {
  // Share of ANSUR II's people whose girth / stature exceeds table B.1, per cent. The people are counted, the
  // model is normal, and judged at the mean stature of each sex: 2.5 points apart at most.
  constexpr double kSkew = 0.025;
  struct Row {
    BodyPart part;
    double men, women;
  };
  const Row counted[] = {{BodyPart::kThighLeft, 32.5, 58.5},
                         {BodyPart::kCalfLeft, 15.7, 24.2},
                         {BodyPart::kBicepsLeft, 4.0, 0.7},
                         {BodyPart::kForearmLeft, 3.2, 0.1}};
  const HumanModel man = human(statureSpread(Sex::kMale).mean, {}, {}, HumanPreset::kThesis),
                   woman = human(statureSpread(Sex::kFemale).mean, {}, {}, HumanPreset::kThesis);
  for (const Row& row : counted) {
    EXPECT_NEAR(share(man, Sex::kMale, row.part).at_stature, 1.0 - 0.01 * row.men, kSkew)
        << partName(row.part);
    EXPECT_NEAR(share(woman, Sex::kFemale, row.part).at_stature, 1.0 - 0.01 * row.women, kSkew)
        << partName(row.part);
  }
  EXPECT_LT(share(man, Sex::kMale, BodyPart::kHandLeft).at_stature, 0.02) << "98 % of men have thicker hands";
}

TEST(EnclosedShare, MarginalGirthsMatchTable) {
  // The 95th percentiles of men's girths, mm, measured. The correlation with stature is the mean of both
  // sexes: up to 0.8 % apart.
  constexpr double kMeanOfSexes = 0.01;
  struct Row {
    BodyPart part;
    double girth;
  };
  const Row measured[] = {{BodyPart::kThighLeft, 723},   {BodyPart::kBicepsLeft, 418},
                          {BodyPart::kForearmLeft, 348}, {BodyPart::kCalfLeft, 443},
                          {BodyPart::kHandLeft, 230},    {BodyPart::kHead, 601}};
  for (const Row& row : measured) {
    HumanModel m = human(1.7562, Sex::kMale);
    HumanPart& part = m.parts[index(row.part)];
    const auto shareOf = [&](double girth) {
      HumanModel scaled = m;
      HumanPart& p = scaled.parts[index(row.part)];
      p.breadth *= girth / part.contour;
      p.depth *= girth / part.contour;
      return share(scaled, Sex::kMale, row.part).all_statures;
    };
    EXPECT_GE(shareOf(unit::mm(row.girth) * (1.0 + kMeanOfSexes)), 0.95) << partName(row.part);
    EXPECT_LE(shareOf(unit::mm(row.girth) * (1.0 - kMeanOfSexes)), 0.95) << partName(row.part);
  }
}

TEST(EnclosedShare, MeanPersonEnclosesHalf) {
  for (const Sex sex : {Sex::kFemale, Sex::kMale}) {
    const HumanModel m = human(statureSpread(sex).mean, sex);
    const auto shares = enclosedShare(m, sex);
    for (const HumanPart& p : m.parts)
      EXPECT_NEAR(shares[index(p.part)].at_stature, 0.5, 1e-9) << partName(p.part);
  }
  // Proportions of the mean person: too large a head for most tall people, too small for most short ones.
  for (const double z : {-1.5, 1.5}) {
    const HumanModel m = human(1.7562 + z * .0686, Sex::kMale);
    EXPECT_NEAR(share(m, Sex::kMale, BodyPart::kHead).at_stature,
                normalShare(.722 * z / std::sqrt(1.0 - .722 * .722)), 1e-9);
  }
}

TEST(EnclosedShare, TightestSectionOfTrunkDecides) {
  HumanModel m = human(statureSpread(Sex::kMale).mean, Sex::kMale);
  HumanPart& torso = m.parts[index(BodyPart::kTorso)];
  torso.depth *= 10.0;
  // Now only the breadth is tight, and the hips are broadest.
  EXPECT_NEAR(share(m, Sex::kMale, BodyPart::kTorso).at_stature, 0.5, 1e-9);
  torso.breadth *= 0.9;
  EXPECT_NEAR(share(m, Sex::kMale, BodyPart::kTorso).at_stature,
              normalShare(-0.1 * .581 / (.042 * std::sqrt(1.0 - .201 * .201))), 1e-9);
}

}  // namespace enclosed_share_test
}  // namespace abstand::humanmodel
