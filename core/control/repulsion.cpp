#include "core/control/repulsion.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand::control {
namespace {

// J: below this the link counts as at rest. 2 kg at 1 mm/s; rounding and the return from a push must not
// trigger.
constexpr double kStanding = 1e-6;

}  // namespace

void RepulsionOptions::validate() const {
  config::requireNumbers(*this);
  if (stop_distance >= range)
    throw UsageError("repulsion.stop_distance " + formatDouble(stop_distance) +
                     ": expected less than the range, " + formatDouble(range) + " m");
}

Repulsion::Repulsion(const RepulsionOptions& options) : o_(options) { options.validate(); }

double Repulsion::potential(double distance) const noexcept {
  const double e = std::clamp(o_.range - distance, 0.0, o_.range);
  const double inside = distance < 0.0 ? -distance : 0.0;
  return o_.force * (e * e * e / (3.0 * o_.range * o_.range) + inside);
}

double Repulsion::force(double distance) const noexcept {
  const double e = std::clamp(o_.range - distance, 0.0, o_.range) / o_.range;
  return o_.force * e * e;
}

double Repulsion::stiffness(double distance) const noexcept {
  const double e = std::clamp(o_.range - distance, 0.0, o_.range) / o_.range;
  return 2.0 * o_.force * e / o_.range;
}

RepulsionResult Repulsion::update(double distance, double rate, double own_rate, double mass) const noexcept {
  RepulsionResult r;
  const double d = std::isnan(distance) ? 0.0 : distance;
  if (d >= o_.range) return r;
  const double damping = 2.0 * o_.damping * std::sqrt(stiffness(d) * mass);
  r.force = std::max(0.0, force(d) - damping * rate);
  r.kinetic = own_rate < 0.0 ? 0.5 * mass * own_rate * own_rate : 0.0;
  r.available = std::max(0.0, potential(o_.stop_distance) - potential(d));
  r.stop = r.kinetic > std::max(kStanding, o_.stop_share * r.available);
  return r;
}

}  // namespace abstand::control
