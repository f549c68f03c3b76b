#include "app/tune/separation.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tune {

void takeSeparation(PartSeparation& part, const SeparationMoment& moment,
                    const safety::SeparationOptions& options) {
  const SeparationMoment& m = moment;
  if (!(m.robot_speed > 0.0)) return;
  const double approach = options.person_acceleration > 0.0 ? m.person_speed : kNaN;
  const safety::ProtectiveDistance needed =
      safety::protectiveDistance(options, m.robot_speed, approach, m.clearance);
  const double missing = needed.sum() - m.clearance;
  const auto permitted = [&] {
    return safety::permittedSpeed(options, m.robot_speed, approach, m.clearance);
  };
  if (missing > part.missing.back()) {
    const double worst = part.worst ? part.worst->needed.sum() - part.worst->clearance : 0.0;
    part.missing.back() = missing;
    if (missing > worst) {
      part.worst = m;
      part.worst->needed = needed;
      part.worst->permitted_speed = permitted();
    }
  }
  if (missing > 0.0) part.speed_scale.back() = std::min(part.speed_scale.back(), permitted() / m.robot_speed);
}

}  // namespace abstand::tune
