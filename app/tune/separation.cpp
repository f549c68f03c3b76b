#include "app/tune/separation.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tune {

void takeSeparation(PartSeparation& part, const SeparationMoment& moment,
                    const safety::SeparationOptions& options) {
  if (!(moment.robot_speed > 0.0)) return;
  SeparationMoment m = moment;
  const double approach = options.person_acceleration > 0.0 ? m.person_speed : kNaN;
  m.needed = safety::protectiveDistance(options, m.robot_speed, approach, m.clearance);
  const double missing = m.needed.sum() - m.clearance;
  if (missing > part.missing.back()) {
    const double worst = part.worst ? part.worst->needed.sum() - part.worst->clearance : 0.0;
    part.missing.back() = missing;
    if (missing > worst) {
      m.permitted_speed = safety::permittedSpeed(options, m.robot_speed, approach, m.clearance);
      part.worst = m;
    }
  }
  if (missing > 0.0)
    part.speed_scale.back() =
        std::min(part.speed_scale.back(),
                 safety::permittedSpeed(options, m.robot_speed, approach, m.clearance) / m.robot_speed);
}

}  // namespace abstand::tune
