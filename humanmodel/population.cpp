// Percentiles of ANSUR II and their interpolation.
#include "humanmodel/population.hpp"

#include <algorithm>
#include <cmath>

#include "humanmodel/normal_distribution.hpp"

namespace abstand::humanmodel {
namespace {

constexpr std::size_t kKnots = 7;
constexpr std::array<double, kKnots> kKnotPercentiles{1.0, 2.5, 5.0, 50.0, 95.0, 97.5, 99.0};
using Knots = std::array<double, kKnots>;

/// Percentiles of one measure of women and of men.
struct Percentiles {
  Knots women, men;
  const Knots& of(Sex sex) const { return sex == Sex::kFemale ? women : men; }
};

// m
constexpr Percentiles kStatures{{1.483, 1.504, 1.525, 1.626, 1.740, 1.758, 1.778},
                                {1.602, 1.627, 1.648, 1.755, 1.870, 1.897, 1.927}};
// kg
constexpr Percentiles kMasses{{46.7, 48.9, 51.3, 66.8, 87.1, 92.4, 97.5},
                              {57.8, 60.8, 64.4, 84.6, 110.7, 116.4, 124.2}};

const Knots& knotScores() {
  static const Knots scores = [] {
    Knots all{};
    for (std::size_t i = 0; i < kKnots; ++i) all[i] = normalScore(0.01 * kKnotPercentiles[i]);
    return all;
  }();
  return scores;
}

/// Piecewise linear interpolation of points (x, y), x increasing, with linear extrapolation.
double interpolated(const Knots& x, const Knots& y, double at) {
  const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, at);
  const auto i = static_cast<std::size_t>(above - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

double valueOfPercentile(const Percentiles& table, double percentile, std::optional<Sex> sex) {
  const double share = 0.01 * percentile;
  if (sex) return interpolated(knotScores(), table.of(*sex), normalScore(share));
  const auto below = [&](double value) {
    return 0.5 * (normalShare(interpolated(table.women, knotScores(), value)) +
                  normalShare(interpolated(table.men, knotScores(), value)));
  };
  double low = 0.0, high = 2.0 * table.men.back();
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) return middle;
    (below(middle) < share ? low : high) = middle;
  }
}

}  // namespace

double statureOfPercentile(double percentile, std::optional<Sex> sex) {
  return valueOfPercentile(kStatures, percentile, sex);
}

double massOfPercentile(double percentile, std::optional<Sex> sex) {
  return valueOfPercentile(kMasses, percentile, sex);
}

StatureSpread statureSpread(Sex sex) {
  return sex == Sex::kFemale ? StatureSpread{1.6285, 0.0642} : StatureSpread{1.7562, 0.0686};
}

double shareOfSexAt(double stature, Sex sex) {
  const auto log_density = [&](Sex s) {
    const StatureSpread spread = statureSpread(s);
    const double score = (stature - spread.mean) / spread.deviation;
    return -0.5 * score * score - std::log(spread.deviation);
  };
  const Sex other = sex == Sex::kFemale ? Sex::kMale : Sex::kFemale;
  return 1.0 / (1.0 + std::exp(log_density(other) - log_density(sex)));
}

}  // namespace abstand::humanmodel
