// Statistics of values.
#include "core/verify/statistics.hpp"

#include <cmath>

#include "core/base/error.hpp"
#include "core/math/transform.hpp"

namespace abstand::verify {

double rms(const std::vector<double>& values) {
  if (values.empty()) return kNaN;
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double logSlope(const std::vector<double>& x, const std::vector<double>& y) {
  ABSTAND_CHECK(x.size() == y.size() && x.size() >= 2);
  double mean_x = 0.0, mean_y = 0.0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    ABSTAND_CHECK(x[i] > 0.0 && y[i] > 0.0);
    mean_x += std::log(x[i]) / n;
    mean_y += std::log(y[i]) / n;
  }
  double along = 0.0, across = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = std::log(x[i]) - mean_x;
    along += dx * (std::log(y[i]) - mean_y);
    across += dx * dx;
  }
  return along / across;
}

}  // namespace abstand::verify
