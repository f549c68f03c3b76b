#include <nlohmann/json.hpp>

#include "app/serve/json_line.hpp"
#include "app/serve/state_packet.hpp"

namespace abstand::serve {
namespace {

void writePair(JsonLine& out, const PairReport& p, const StateNames& names) {
  constexpr std::array<std::string_view, 3> kTrust{"\"none\"", "\"inferred\"", "\"fresh\""};
  const auto object = [&](int i) -> std::string_view {
    return i < 0 ? std::string_view("null") : std::string_view(names.objects[static_cast<std::size_t>(i)]);
  };
  out.text("\"a\":").text(object(p.a)).text(",\"b\":").text(object(p.b));
  out.text(",\"trust\":").text(kTrust[static_cast<std::size_t>(p.trust)]);
  out.text(",\"distance\":").number(p.distance);
  out.text(",\"bound\":").number(p.bound);
  out.text(",\"witness_a\":").vector(p.witness_a);
  out.text(",\"witness_b\":").vector(p.witness_b);
}

void writeRobot(JsonLine& out, const RobotReport& r, std::string_view name) {
  out.text("{\"name\":").text(name);
  out.text(",\"speed_scale\":").number(r.speed_scale);
  out.text(",\"input_age\":").number(r.input_age);
  out.text(",\"since\":").number(r.since);
  out.text(",\"state\":\"").text(safety::stateName(r.state)).text("\",\"reason\":");
  if (r.has_reason)
    out.text("\"").text(safety::reasonName(r.reason)).text("\"");
  else
    out.text("null");
  if (r.refusal != safety::ResetRefusal::kNone)
    out.text(",\"reset_refused\":\"").text(safety::refusalName(r.refusal)).text("\"");
  out.text("}");
}

std::string quote(const std::string& name) {
  return nlohmann::json(name).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

PacketFormat quoted(PacketFormat format) {
  for (auto& m : format.mechanisms) m.name = quote(m.name);
  for (auto* names : {&format.people, &format.groups, &format.objects})
    for (auto& name : *names) name = quote(name);
  return format;
}

StateNames quoted(StateNames names) {
  for (auto* list : {&names.links, &names.objects})
    for (auto& name : *list) name = quote(name);
  return names;
}

std::size_t writeStateJson(const StateReport& r, const ReplyTo& to, const PacketFormat& format,
                           const StateNames& names, std::span<std::byte> into) noexcept {
  JsonLine out(into);
  out.text("{\"type\":\"state\",\"seq\":").number(to.sequence);
  out.text(",\"time_us\":").number(to.time_us);
  out.text(",\"unasked\":").text(to.unasked ? "true" : "false");
  out.text(",\"server_us\":").number(r.time_us);
  out.text(",\"cycle_us\":").number(r.cycle_us);
  out.text(",\"bad\":").number(r.bad);
  out.text(",\"late\":").number(r.late);
  out.text(",\"lost\":").number(r.lost);
  out.text(",\"duplicates\":").number(r.duplicates);
  out.text(",\"torques_on\":").text(r.torques_on ? "true" : "false");
  out.text(",\"not_checked\":").number(r.not_checked);
  out.text(",\"people\":").list(r.person_age.size(), [&](std::size_t i) {
    out.text("{\"name\":").text(format.people[i]).text(",\"age\":").number(r.person_age[i]).text("}");
  });
  out.text(",\"mechanisms\":").list(r.robots.size(), [&](std::size_t i) {
    writeRobot(out, r.robots[i], format.mechanisms[i].name);
  });
  out.text(",\"torque\":").list(r.torque.size(), [&](std::size_t i) { out.number(r.torque[i]); });
  out.text(",\"links\":").list(r.links.size(), [&](std::size_t i) {
    out.text("{\"name\":").text(names.links[i]).text(",\"force\":").vector(r.links[i].force);
    out.text(",\"torque\":").vector(r.links[i].torque).text("}");
  });
  out.text(",\"separation\":").list(r.separation.size(), [&](std::size_t i) {
    out.text("{\"person\":").text(format.people[i / r.robots.size()]);
    out.text(",\"mechanism\":").text(format.mechanisms[i % r.robots.size()].name).text(",");
    writePair(out, r.separation[i], names);
    out.text("}");
  });
  out.text(",\"nearest\":").list(r.nearest.size(), [&](std::size_t i) {
    out.text("{");
    writePair(out, r.nearest[i], names);
    out.text("}");
  });
  if (!r.offset.empty())
    out.text(",\"offset\":").list(r.offset.size(), [&](std::size_t i) { out.number(r.offset[i]); });
  return out.text("}\n").size();
}

}  // namespace abstand::serve
