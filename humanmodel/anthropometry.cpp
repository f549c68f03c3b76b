// Tables of ANSUR II, and scaling with body mass.
#include "humanmodel/anthropometry.hpp"

#include <cmath>

namespace abstand::humanmodel {
namespace {

/// Mean values of men and of women.
struct Pair {
  double men, women;
  double at(std::optional<Sex> sex) const {
    if (!sex) return 0.5 * (men + women);
    return *sex == Sex::kMale ? men : women;
  }
};

/// Girth as a share of stature = a + b BMI, least squares over ANSUR II.
struct Line {
  Pair a, b;
  double at(double bmi, std::optional<Sex> sex) const { return a.at(sex) + b.at(sex) * bmi; }
};

// ANSUR II, mean mass (kg) and mean stature (m).
constexpr Pair kMeanMass{85.5, 67.8};
constexpr Pair kMeanStature{1.7562, 1.6285};

// The four girths best explained by mass (r^2 0.66 to 0.83).
constexpr Line kChestGirth{{.2976, .2820}, {.01104, .01176}};
constexpr Line kWaistGirth{{.1458, .1528}, {.01409, .01475}};
constexpr Line kThighGirth{{.1544, .1655}, {.00729, .00835}};
constexpr Line kBicepsGirth{{.0938, .0706}, {.00398, .00459}};

// No regression for other parts. The cube root of the body mass index puts the 5th percentile woman and the
// 95th percentile man within 3 % of their measured forearm, calf, chest breadth and hip breadth.
constexpr double kMildGrowth = 1.0 / 3.0;

// Means, as shares of stature.
constexpr Pair kButtockGirth{.581, .627};
constexpr Pair kChestBreadth{.165, .166}, kWaistBreadth{.186, .184}, kHipBreadth{.197, .217};
constexpr Pair kChestDepth{.145, .152}, kWaistDepth{.136, .131}, kButtockDepth{.140, .143};
constexpr Pair kHeadGirth{.327, .345}, kHeadBreadth{.088, .091}, kHeadDepth{.114, .117},
    kNeckGirth{.227, .203};
constexpr Pair kForearmGirth{.177, .162}, kHandGirth{.121, .115}, kHandBreadth{.050, .048};
constexpr Pair kCalfGirth{.224, .229};
constexpr Pair kFootLength{.154, .151}, kFootBreadth{.058, .057}, kBallGirth{.144, .140};
constexpr Pair kHeadAndNeck{.136, .143};  // stature less cervicale height
constexpr Pair kAcromialHeight{.820, .820}, kCrotchHeight{.482, .480};
constexpr Pair kAcromionTrochanter{.307, .301}, kTrochanterEpicondyle{.233, .233},
    kEpicondyleMalleolus{.238, .248};
constexpr Pair kAcromionRadiale{.191, .191}, kRadialeStylion{.153, .148}, kHandLength{.110, .111};
constexpr Pair kBiacromialBreadth{.237, .224};

}  // namespace

double meanBodyMassIndex(std::optional<Sex> sex) {
  const auto index_of = [](double mass, double stature) { return mass / (stature * stature); };
  return Pair{index_of(kMeanMass.men, kMeanStature.men), index_of(kMeanMass.women, kMeanStature.women)}.at(
      sex);
}

BodyMeasures measuresOf(double height, double mass, std::optional<Sex> sex) {
  const double bmi = mass / (height * height), mean_bmi = meanBodyMassIndex(sex);
  // Growth of a girth relative to the mean person of the same stature.
  const auto growth = [&](const Line& line) { return line.at(bmi, sex) / line.at(mean_bmi, sex); };
  const double chest = growth(kChestGirth), waist = growth(kWaistGirth), thigh = growth(kThighGirth);
  const double mild = std::pow(bmi / mean_bmi, kMildGrowth);
  const auto share = [&](const Pair& mean) { return height * mean.at(sex); };

  BodyMeasures m{};
  m.chest_girth = height * kChestGirth.at(bmi, sex);
  m.waist_girth = height * kWaistGirth.at(bmi, sex);
  m.buttock_girth = share(kButtockGirth) * thigh;
  m.chest_breadth = share(kChestBreadth) * mild;
  m.waist_breadth = share(kWaistBreadth) * waist;
  m.hip_breadth = share(kHipBreadth) * mild;
  m.chest_depth = share(kChestDepth) * chest;
  m.waist_depth = share(kWaistDepth) * waist;
  m.buttock_depth = share(kButtockDepth) * thigh;
  m.head_girth = share(kHeadGirth);
  m.head_breadth = share(kHeadBreadth);
  m.head_depth = share(kHeadDepth);
  m.neck_girth = share(kNeckGirth);
  m.biceps_girth = height * kBicepsGirth.at(bmi, sex);
  m.forearm_girth = share(kForearmGirth) * mild;
  m.hand_girth = share(kHandGirth);
  m.hand_breadth = share(kHandBreadth);
  m.thigh_girth = height * kThighGirth.at(bmi, sex);
  m.calf_girth = share(kCalfGirth) * mild;
  m.foot_length = share(kFootLength);
  m.foot_breadth = share(kFootBreadth);
  m.ball_girth = share(kBallGirth);
  m.cervicale_height = height - share(kHeadAndNeck);
  m.acromial_height = share(kAcromialHeight);
  m.crotch_height = share(kCrotchHeight);
  m.acromion_trochanter = share(kAcromionTrochanter);
  m.trochanter_epicondyle = share(kTrochanterEpicondyle);
  m.epicondyle_malleolus = share(kEpicondyleMalleolus);
  m.acromion_radiale = share(kAcromionRadiale);
  m.radiale_stylion = share(kRadialeStylion);
  m.hand_length = share(kHandLength);
  m.biacromial_breadth = share(kBiacromialBreadth);
  return m;
}

}  // namespace abstand::humanmodel
