#include "app/cli/robot_texts.hpp"

#include <cmath>

#include "app/cli/command_line.hpp"
#include "app/cli/json_values.hpp"

namespace abstand::cli {
namespace {

nlohmann::ordered_json extremeJson(const std::optional<loop::ReactionReport::Extreme>& e) {
  if (!e) return nullptr;
  return {{"a", e->a}, {"b", e->b}, {"t", e->t}, {"value", e->value}};
}

/// Penetration depth, m; 0 without contact.
double depthOf(const std::optional<loop::ReactionReport::Extreme>& e) {
  return e ? std::max(0.0, -e->value) : 0.0;
}

nlohmann::ordered_json robotJson(const loop::ReactionReport& r) {
  auto stops = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < r.stops.size(); ++i) {
    const safety::StopEntry& e = r.stops[i];
    stops.push_back({{"t", e.t},
                     {"from", safety::stateName(e.from)},
                     {"to", safety::stateName(e.to)},
                     {"reason", safety::reasonName(e.cause.reason)},
                     {"text", r.lines[i]}});
  }
  return {{"mechanism", r.name},
          {"control", r.positioned ? "position" : "torque"},
          {"min_distance", extremeJson(r.nearest)},
          {"min_distance_person", extremeJson(r.nearest_person)},
          {"deepest_person", depthOf(r.nearest_person)},
          {"peak_torque", r.record.max_torque},
          {"most_off_plan", r.record.max_off_plan},
          {"behind_plan", r.record.lost_time},
          {"slowed", r.record.slowed},
          {"stopped", r.record.stopped},
          {"state", safety::stateName(r.state)},
          {"constant_mass", !r.remark.empty()},
          {"stop_count", r.stop_count},
          {"stops", stops}};
}

std::string robotText(const loop::ReactionReport& r) {
  std::string text = r.name + ": ";
  if (r.nearest_person)
    text += format("minimum distance to a person %.1f mm, %s to %s at %.3f s; maximum penetration %.1f mm\n",
                   1e3 * r.nearest_person->value, r.nearest_person->a.c_str(), r.nearest_person->b.c_str(),
                   r.nearest_person->t, 1e3 * depthOf(r.nearest_person));
  else if (r.nearest)
    text += format("minimum distance %.1f mm, %s to %s at %.3f s\n", 1e3 * r.nearest->value,
                   r.nearest->a.c_str(), r.nearest->b.c_str(), r.nearest->t);
  text += format(
      "  maximum deviation from the planned motion %.3f, maximum torque %.1f; slowed %.2f s, stopped %.2f s, "
      "%zu changes of "
      "state\n",
      r.record.max_off_plan, r.record.max_torque, r.record.slowed, r.record.stopped, r.stop_count);
  if (!r.remark.empty()) text += "  " + r.remark + "\n";
  for (const auto& line : r.lines) text += "  " + line + "\n";
  return text;
}

}  // namespace

nlohmann::ordered_json jointLimitsJson(const std::vector<run::JointLimitReport>& reports) {
  auto list = nlohmann::ordered_json::array();
  for (const run::JointLimitReport& r : reports) {
    nlohmann::ordered_json j;
    if (!r.mechanism.empty()) j["mechanism"] = r.mechanism;
    j["joint"] = r.joint;
    j["kind"] = mechanism::limitName(r.worst.kind);
    j["value"] = numberOrNull(r.worst.value);
    j["limit"] = numberOrNull(r.worst.limit);
    j["t"] = numberOrNull(r.worst.t);
    j["since"] = numberOrNull(r.worst.since);
    j["samples"] = r.worst.count;
    j["planned"] = r.planned;
    list.push_back(std::move(j));
  }
  return list;
}

std::string jointLimitsText(const std::vector<run::JointLimitReport>& reports) {
  std::string text;
  for (const run::JointLimitReport& r : reports) text += "joint limit exceeded: " + run::describe(r) + "\n";
  return text;
}

nlohmann::ordered_json robotsJson(const std::vector<loop::ReactionReport>& robots) {
  auto list = nlohmann::ordered_json::array();
  for (const loop::ReactionReport& r : robots) list.push_back(robotJson(r));
  return list;
}

std::string robotsText(const std::vector<loop::ReactionReport>& robots) {
  std::string text;
  for (const loop::ReactionReport& r : robots) text += robotText(r);
  return text;
}

}  // namespace abstand::cli
