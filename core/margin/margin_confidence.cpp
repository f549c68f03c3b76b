#include "core/margin/margin_confidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace abstand::margin {
namespace {

constexpr std::size_t kMinValues = 5;

}  // namespace

double unseenShare(std::size_t count, double confidence) {
  if (count == 0) return 1.0;
  return 1.0 - std::pow(1.0 - confidence, 1.0 / static_cast<double>(count));
}

double GumbelFit::quantile(double probability) const {
  return location - scale * std::log(-std::log(probability));
}

double GumbelFit::probability(double value) const { return std::exp(-std::exp(-(value - location) / scale)); }

std::optional<GumbelFit> fitGumbel(std::span<const double> values) {
  std::vector<double> x;
  for (const double v : values)
    if (std::isfinite(v)) x.push_back(v);
  if (x.size() < kMinValues) return std::nullopt;
  std::sort(x.begin(), x.end());
  if (x.front() == x.back()) return std::nullopt;
  const double n = static_cast<double>(x.size());
  double b0 = 0.0, b1 = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    b0 += x[i] / n;
    b1 += static_cast<double>(i) / (n - 1.0) * x[i] / n;
  }
  GumbelFit fit;
  fit.scale = (2.0 * b1 - b0) / std::numbers::ln2;
  fit.location = b0 - std::numbers::egamma * fit.scale;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double p = fit.probability(x[i]), below = static_cast<double>(i) / n;
    fit.misfit = std::max({fit.misfit, p - below, below + 1.0 / n - p});
  }
  return fit;
}

}  // namespace abstand::margin
