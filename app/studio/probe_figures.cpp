#include "app/studio/probe_figures.hpp"

#include <cmath>

#include "core/math/quantile.hpp"

namespace abstand::studio {

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

QJsonObject spread(const std::vector<double>& values, double factor) {
  const auto at = [&](double q) {
    return values.empty() ? std::nan("") : rounded(factor * nearestQuantile(values, q));
  };
  return {{"median", at(0.5)}, {"p99", at(0.99)}, {"max", at(1.0)}};
}

}  // namespace abstand::studio
