#include "app/tune/separation.hpp"

#include <algorithm>

namespace abstand::tune {

std::optional<SeparationMoment> separationMoment(const SeparationMoment& pair,
                                                 const safety::SeparationOptions& options) {
  if (!(pair.robot_speed > 0.0)) return std::nullopt;
  const double approach = options.person_acceleration > 0.0 ? pair.person_speed : kNaN;
  SeparationMoment moment = pair;
  moment.needed = safety::protectiveDistance(options, pair.robot_speed, approach, pair.clearance);
  moment.permitted_speed = moment.missing() > 0.0
                               ? safety::permittedSpeed(options, pair.robot_speed, approach, pair.clearance)
                               : pair.robot_speed;
  return moment;
}

void takeSeparation(PartSeparation& part, const SeparationMoment& pair,
                    const safety::SeparationOptions& options) {
  const std::optional<SeparationMoment> moment = separationMoment(pair, options);
  if (!moment) return;
  const double missing = moment->missing();
  if (missing > part.missing.back()) {
    part.missing.back() = missing;
    if (missing > (part.worst ? part.worst->missing() : 0.0)) part.worst = moment;
  }
  if (missing > 0.0)
    part.speed_scale.back() = std::min(part.speed_scale.back(), moment->permitted_speed / pair.robot_speed);
}

}  // namespace abstand::tune
