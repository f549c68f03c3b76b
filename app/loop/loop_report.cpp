#include "app/loop/loop_report.hpp"

#include <cmath>

#include "app/session/robot_mass.hpp"

namespace abstand::loop {

std::vector<ReactionReport> reportOf(const ClosedLoop& loop) {
  const scene::Scene& scene = loop.session().scene();
  const auto nameOf = [&](ObjectId id) { return scene.object(id).spec.name; };
  const auto extreme = [&](const RobotRecord::Moment& m) -> std::optional<ReactionReport::Extreme> {
    if (std::isnan(m.value)) return std::nullopt;
    const scene::Pair& pair = scene.pairs()[m.pair.index()];
    return ReactionReport::Extreme{nameOf(pair.a), nameOf(pair.b), m.t, m.value};
  };
  safety::StopNames names;
  names.pair = [&](int i) {
    const scene::Pair& pair = scene.pairs()[static_cast<std::size_t>(i)];
    return nameOf(pair.a) + " - " + nameOf(pair.b);
  };
  std::vector<ReactionReport> reports;
  for (std::size_t m = 0; m < loop.robots().size(); ++m) {
    if (!loop.robots()[m]) continue;
    const ReactingRobot& robot = *loop.robots()[m];
    ReactionReport& r = reports.emplace_back();
    r.name = loop.session().description().mechanisms[m].name;
    r.positioned = robot.positioned();
    r.remark = session::massRemark(r.name, robot.driver().mechanism(),
                                   *loop.session().description().mechanisms[m].reaction);
    r.record = robot.record();
    r.nearest = extreme(r.record.nearest);
    r.nearest_person = extreme(r.record.nearest_person);
    const safety::StopLog& log = robot.stops().log();
    r.stop_count = log.count();
    r.state = robot.stops().state();
    for (std::size_t i = 0; i < log.kept(); ++i) {
      r.stops.push_back(log.entry(i));
      r.lines.push_back(safety::describe(log.entry(i), names));
    }
  }
  return reports;
}

}  // namespace abstand::loop
