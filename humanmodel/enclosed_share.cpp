#include "humanmodel/enclosed_share.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/math/transform.hpp"
#include "humanmodel/girth_spread.hpp"
#include "humanmodel/normal_distribution.hpp"
#include "humanmodel/population.hpp"

namespace abstand::humanmodel {
namespace {

std::span<const GirthPlace> placesOf(PartKind kind) {
  using enum GirthPlace;
  static constexpr GirthPlace kTrunk[] = {kChest, kWaist, kButtock};
  // In the order of PartKind after the torso.
  static constexpr GirthPlace kOthers[] = {kHead, kBiceps, kForearm, kHand, kThigh, kCalf, kFoot};
  if (kind == PartKind::kTorso) return kTrunk;
  return {&kOthers[index(kind) - 1], 1};
}

/// Distribution of girth / stature for one place and sex.
struct GirthLaw {
  GirthPlace place;
  Sex sex;
  double mean;  ///< over all statures
  /// Share of people of a stature (m) whose girth is below `girth` (m).
  double below(double girth, double stature) const {
    return normalShare((girth / stature - mean - girthShift(place, stature, sex)) /
                       girthDeviation(place, sex, false));
  }
};

/// below() averaged over all statures of a sex: Simpson's rule over the score of stature.
double belowAtAllStatures(const GirthLaw& law, double girth) {
  constexpr int kSteps = 320;   // the kinks of the law, at scores of -3 and 3, are ends of a pair of steps
  constexpr double kEnd = 8.0;  // standard deviations; 1e-15 of the people are outside
  const StatureSpread statures = statureSpread(law.sex);
  const double step = 2.0 * kEnd / kSteps;
  double sum = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double score = -kEnd + step * i;
    const double density = std::exp(-0.5 * score * score) / std::sqrt(2.0 * kPi);
    const double weight = i == 0 || i == kSteps ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * density * law.below(girth, statures.mean + statures.deviation * score);
  }
  return sum * step / 3.0;
}

/// One sex of a population: its mean sections at 1 m, and its shares of the counted people.
struct CountedSex {
  Sex sex;
  BodySections mean;
  double share_at_stature, share;
};

EnclosedShare enclosedBy(const HumanPart& part, GirthPlace place, double stature,
                         std::span<const CountedSex> people) {
  EnclosedShare sum;
  for (const CountedSex& p : people) {
    const Section& mean = p.mean[place];
    const GirthLaw law{place, p.sex, mean.girth};
    const double girth = largestGirthInside({part.breadth, part.depth, part.contour}, mean);
    sum.at_stature += p.share_at_stature * law.below(girth, stature);
    sum.all_statures += p.share * belowAtAllStatures(law, girth);
  }
  return sum;
}

}  // namespace

std::array<EnclosedShare, kBodyPartCount> enclosedShare(const HumanModel& model, std::optional<Sex> sex) {
  std::vector<CountedSex> people;
  for (const Sex s : {Sex::kFemale, Sex::kMale}) {
    if (sex && *sex != s) continue;
    people.push_back(
        {s, meanSections(1.0, {}, s), sex ? 1.0 : shareOfSexAt(model.height, s), sex ? 1.0 : 0.5});
  }
  std::array<EnclosedShare, kBodyPartCount> shares;
  for (const HumanPart& part : model.parts) {
    EnclosedShare& smallest = shares[index(part.part)];
    smallest = {1.0, 1.0};
    for (const GirthPlace place : placesOf(kindOf(part.part))) {
      const EnclosedShare here = enclosedBy(part, place, model.height, people);
      smallest = {std::min(smallest.at_stature, here.at_stature),
                  std::min(smallest.all_statures, here.all_statures)};
    }
  }
  return shares;
}

}  // namespace abstand::humanmodel
