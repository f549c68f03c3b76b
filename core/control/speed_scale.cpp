#include "core/control/speed_scale.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::control {

SpeedScale::SpeedScale(const SpeedScaleOptions& options) : o_(options) { options.validate(); }

double SpeedScale::update(std::span<const Approach> pairs, double dt) noexcept {
  double allowed = 1.0;
  slowest_ = -1;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Approach& p = pairs[i];
    if (p.robot <= 0.0) continue;  // it recedes or is at rest
    // Only needs to be evaluated up to the share that earlier pairs allow.
    const double wanted = allowed * p.robot;
    const bool known = !std::isnan(p.robot) && !std::isnan(p.distance);
    const double permitted =
        known ? safety::permittedSpeed(o_.separation, wanted, p.person, p.distance) : 0.0;
    if (known && permitted >= wanted) continue;
    allowed = known ? permitted / p.robot : 0.0;
    slowest_ = static_cast<int>(i);
    permitted_ = permitted;
    planned_ = p.robot;
    if (allowed == 0.0) break;
  }
  if (allowed < o_.min_scale) allowed = 0.0;
  scale_ = std::min(allowed, scale_ + o_.release * std::max(0.0, dt));
  return scale_;
}

}  // namespace abstand::control
