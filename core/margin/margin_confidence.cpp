#include "core/margin/margin_confidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::margin {
namespace {

constexpr std::size_t kMinValues = 5;
// The quantile of the misfit is 0.356 for 5 values, 0.269 for 10, 0.196 for 20, 0.0903 for 100, 0.0294 for
// 1,000 (simulated, 40,000 samples each; 4,000 of the largest): these numbers follow it within 3 %.
constexpr double kMisfitScale = 0.92, kMisfitOffset = 0.3;

}  // namespace

double unseenShare(std::size_t count, double confidence) {
  if (count == 0) return 1.0;
  return 1.0 - std::pow(1.0 - confidence, 1.0 / static_cast<double>(count));
}

double unseenRate(double time, double confidence) {
  return time > 0.0 ? -std::log(1.0 - confidence) / time : kInfinity;
}

double unseenTimeShare(double time, double confidence) {
  return 1.0 - std::exp(-unseenRate(time, confidence));
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
  fit.count = x.size();
  fit.scale = (2.0 * b1 - b0) / std::numbers::ln2;
  fit.location = b0 - std::numbers::egamma * fit.scale;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double p = fit.probability(x[i]), below = static_cast<double>(i) / n;
    fit.misfit = std::max({fit.misfit, p - below, below + 1.0 / n - p});
  }
  return fit;
}

double criticalMisfit(std::size_t count) {
  return kMisfitScale / (std::sqrt(static_cast<double>(count)) + kMisfitOffset);
}

}  // namespace abstand::margin
