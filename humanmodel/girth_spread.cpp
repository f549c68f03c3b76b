// Standard deviations and correlations of ANSUR II, and sections that enclose a share of the people.
#include "humanmodel/girth_spread.hpp"

#include <algorithm>
#include <cmath>

#include "humanmodel/normal_distribution.hpp"
#include "humanmodel/population.hpp"

namespace abstand::humanmodel {
namespace {

/// Values of men and of women.
struct Spread {
  double men, women;
  double of(Sex sex) const { return sex == Sex::kMale ? men : women; }
};

// Standard deviations of girths as shares of stature (ANSUR II), in the order of GirthPlace.
constexpr std::array<Spread, kGirthPlaceCount> kDeviations{{{.049, .050},
                                                            {.063, .060},
                                                            {.042, .044},
                                                            {.013, .015},
                                                            {.016, .012},
                                                            {.020, .019},
                                                            {.012, .011},
                                                            {.006, .005},
                                                            {.033, .033},
                                                            {.017, .017},
                                                            {.007, .007}}};

// Of girth / stature with stature, mean of men and women, in the order of GirthPlace; derived as
// girthCorrelation says.
constexpr std::array<double, kGirthPlaceCount> kCorrelations{-.266, -.185, -.201, -.722, -.420, -.244,
                                                             -.243, -.380, -.165, -.264, -.393};

// 99.7 % of the people.
constexpr double kLargestScore = 3.0;

/// r^2 of girth / stature with the body mass index (ANSUR II); 0: unknown.
Spread explainedByMass(GirthPlace place) {
  switch (place) {
    case GirthPlace::kChest:
      return {.81, .67};
    case GirthPlace::kWaist:
      return {.83, .73};
    case GirthPlace::kThigh:
      return {.82, .79};
    case GirthPlace::kBiceps:
      return {.66, .75};
    default:
      return {0.0, 0.0};
  }
}

/// People of one sex: share of the population, and parameters of the section to scale.
struct Half {
  double share, mean_scale, deviation_scale;
};

/// Factor by which a section must be scaled to enclose `share` of both sexes.
double scaleFor(const std::array<Half, 2>& halves, double share) {
  double low = 0.0, high = 10.0;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) return high;
    double inside = 0.0;
    for (const Half& h : halves) inside += h.share * normalShare((middle - h.mean_scale) / h.deviation_scale);
    (inside < share ? low : high) = middle;
  }
}

}  // namespace

double girthCorrelation(GirthPlace place) { return kCorrelations[static_cast<std::size_t>(place)]; }

double girthStatureScore(double height, Sex sex) {
  const StatureSpread spread = statureSpread(sex);
  return std::clamp((height - spread.mean) / spread.deviation, -kLargestScore, kLargestScore);
}

double girthShift(GirthPlace place, double height, Sex sex) {
  return girthCorrelation(place) * kDeviations[static_cast<std::size_t>(place)].of(sex) *
         girthStatureScore(height, sex);
}

double girthDeviation(GirthPlace place, Sex sex, bool mass_known) {
  const double rho = girthCorrelation(place);
  const double by_mass = mass_known ? explainedByMass(place).of(sex) : 0.0;
  return kDeviations[static_cast<std::size_t>(place)].of(sex) * std::sqrt(1.0 - by_mass - rho * rho);
}

BodySections sectionsOfPercentile(double percentile, double height, std::optional<double> mass,
                                  std::optional<Sex> sex) {
  BodySections made = meanSections(height, mass, sex);
  const BodySections women = sex ? made : meanSections(height, mass, Sex::kFemale);
  const BodySections men = sex ? made : meanSections(height, mass, Sex::kMale);
  const double score = normalScore(0.01 * percentile);
  for (std::size_t i = 0; i < kGirthPlaceCount; ++i) {
    const auto place = static_cast<GirthPlace>(i);
    Section& section = made[place];
    const auto half = [&](Sex s) {
      const Section& mean = s == Sex::kFemale ? women[place] : men[place];
      const double inside = largestGirthInside(section, mean);
      return Half{shareOfSexAt(height, s), (mean.girth + height * girthShift(place, height, s)) / inside,
                  height * girthDeviation(place, s, mass.has_value()) / inside};
    };
    double scale = 0.0;
    if (sex) {
      const Half people = half(*sex);
      scale = people.mean_scale + score * people.deviation_scale;
    } else {
      scale = scaleFor({half(Sex::kFemale), half(Sex::kMale)}, 0.01 * percentile);
    }
    section = {scale * section.breadth, scale * section.depth, scale * section.girth};
  }
  return made;
}

}  // namespace abstand::humanmodel
