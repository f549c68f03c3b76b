#include "app/tune/stop_term.hpp"

#include "app/tune/separation_table.hpp"

namespace abstand::tune {

std::optional<StopTerm> stopTerm(const MarginEvent& event, const safety::SeparationOptions& options) {
  if (event.kind != MarginEvent::Kind::kIntrusion || !(event.told_robot_speed > 0.0)) return std::nullopt;
  // As takeSeparation().
  const double approach = options.person_acceleration > 0.0 ? event.told_person_speed : kNaN;
  StopTerm term;
  term.clearance = event.told_clearance;
  term.needed = safety::protectiveDistance(options, event.told_robot_speed, approach, event.told_clearance);
  term.largest = largestTerm(term.needed);
  return term;
}

}  // namespace abstand::tune
