#include "core/math/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/math/transform.hpp"

namespace abstand {
namespace {

double atPlace(std::vector<double>& values, std::size_t place) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::min(place, values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

double lowerQuantile(std::vector<double> values, double share) {
  if (values.empty()) return kNaN;
  const auto number = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return atPlace(values, std::max<std::size_t>(number, 1) - 1);
}

double upperQuantile(std::vector<double> values, double share) {
  if (values.empty()) return kNaN;
  return atPlace(values, static_cast<std::size_t>(share * static_cast<double>(values.size())));
}

double nearestQuantile(std::vector<double> values, double share) {
  if (values.empty()) return kNaN;
  return atPlace(values, static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5));
}

}  // namespace abstand
