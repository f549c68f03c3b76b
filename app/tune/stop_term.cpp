#include "app/tune/stop_term.hpp"

#include "app/tune/separation_table.hpp"

namespace abstand::tune {

std::optional<StopTerm> stopTerm(const MarginEvent& event, const safety::SeparationOptions& options) {
  if (event.kind != MarginEvent::Kind::kIntrusion) return std::nullopt;
  SeparationMoment pair;
  pair.clearance = event.told_clearance;
  pair.robot_speed = event.told_robot_speed;
  pair.person_speed = event.told_person_speed;
  const std::optional<SeparationMoment> moment = separationMoment(pair, options);
  if (!moment) return std::nullopt;
  return StopTerm{moment->needed, moment->clearance, largestTerm(moment->needed)};
}

}  // namespace abstand::tune
