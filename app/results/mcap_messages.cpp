#include "app/results/mcap_messages.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/number.hpp"

namespace abstand::results {

const char* const kClearanceSchema =
    R"({"$schema":"https://json-schema.org/draft/2020-12/schema","title":"abstand.Clearance","type":"object","properties":{
"t":{"type":"number","description":"s, of the recording"},
"seen":{"type":"boolean","description":"false: the part's position and clearance are unknown"},
"clearance":{"type":"number","description":"m, certified: distance - bound - uncertainty of the nearest link"},
"distance":{"type":"number","description":"m, measured"},
"bound":{"type":"number","description":"m: the true distance is never below distance - bound"},
"uncertainty":{"type":"number","description":"m, of the person's pose"},
"robot_speed":{"type":"number","description":"m/s, of the link's nearest point towards the part"},
"person_speed":{"type":"number","description":"m/s, of the part's nearest point towards the link"},
"link":{"type":"string","description":"nearest link"}},"required":["t","seen","link"]})";

const char* const kApproachSchema =
    R"({"$schema":"https://json-schema.org/draft/2020-12/schema","title":"abstand.Approach","type":"object","properties":{
"t":{"type":"number","description":"s, of the recording: local minimum of the clearance"},
"recording":{"type":"string"},"part":{"type":"string"},"link":{"type":"string"},
"clearance":{"type":"number","description":"m, certified"},
"distance":{"type":"number","description":"m, measured"},
"closing_speed":{"type":"number","description":"m/s, of both"},
"robot_speed":{"type":"number","description":"m/s"},
"person_speed":{"type":"number","description":"m/s"},
"robot_mass":{"type":"number","description":"kg, effective; omitted: unknown, or a wall"},
"region":{"type":"string","description":"of the body, of the hardest contact of the approach; omitted: not evaluated"},
"kind":{"type":"string","description":"transient, or quasi-static: the part may be clamped"},
"excluded":{"type":"boolean","description":"contact with this region is excluded"},
"force":{"type":"number","description":"N"},
"force_share":{"type":"number","description":"of its limit; omitted: excluded"},
"pressure":{"type":"number","description":"Pa"},
"pressure_share":{"type":"number","description":"of its limit"}},
"required":["t","recording","part","link"]})";

const char* const kEventSchema =
    R"({"$schema":"https://json-schema.org/draft/2020-12/schema","title":"abstand.Event","type":"object","properties":{
"t":{"type":"number","description":"s, of the recording: the first frame below the margin"},
"t1":{"type":"number","description":"s, the end"},
"t_nearest":{"type":"number","description":"s, of the smallest clearance"},
"recording":{"type":"string"},"part":{"type":"string"},"link":{"type":"string"},
"kind":{"type":"string","description":"intrusion, or between_frames: no stop was triggered"},
"min_clearance":{"type":"number","description":"m, certified, without a stop; omitted: unknown"},
"braking_clearance":{"type":"number","description":"m, certified, until the robot is at standstill"},
"false_stop":{"type":"boolean"},"missed_stop":{"type":"boolean"},
"lead_time":{"type":"number","description":"s, until the limit would have been reached; omitted: never"}},
"required":["t","t1","t_nearest","recording","part","link","kind","false_stop","missed_stop"]})";

namespace {

/// Builds one JSON object on one line.
class MessageText {
 public:
  MessageText& number(const char* key, double value) {
    return std::isfinite(value) ? add(key, formatDouble(value)) : *this;
  }
  MessageText& text(const char* key, const std::string& value) {
    return add(key, nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  MessageText& flag(const char* key, bool value) { return add(key, value ? "true" : "false"); }
  std::string done() const { return json_ + "}"; }

 private:
  MessageText& add(const char* key, const std::string& value) {
    json_ += std::string(json_.size() > 1 ? ",\"" : "\"") + key + "\":" + value;
    return *this;
  }
  std::string json_{"{"};
};

}  // namespace

std::string clearanceMessage(const tune::TunedRecording& recording, const tune::PartClearance& part,
                             std::size_t frame) {
  return MessageText()
      .number("t", part.track.t[frame])
      .flag("seen", std::isfinite(part.track.clearance[frame]))
      .number("clearance", part.track.clearance[frame])
      .number("distance", part.distance[frame])
      .number("bound", part.bound[frame])
      .number("uncertainty", part.uncertainty[frame])
      .number("robot_speed", part.robot_speed[frame])
      .number("person_speed", part.person_speed[frame])
      .text("link", recording.pass.links[part.link[frame]])
      .done();
}

std::string approachMessage(const tune::RankedApproach& ranked) {
  const tune::Approach& a = *ranked.approach;
  const tune::PassResult& pass = ranked.recording->pass;
  MessageText message;
  message.number("t", a.t)
      .text("recording", ranked.recording->recording)
      .text("part", pass.parts[a.part].part)
      .text("link", pass.links[a.link])
      .number("clearance", a.clearance)
      .number("distance", a.distance)
      .number("closing_speed", a.motion.closing())
      .number("robot_speed", a.motion.robot_speed)
      .number("person_speed", a.motion.person_speed)
      .number("robot_mass", a.motion.robot_mass);
  if (a.contact.region.empty()) return message.done();
  message.text("region", a.contact.region)
      .text("kind", std::string(contact::kindText(a.contact.kind)))
      .flag("excluded", a.contact.excluded)
      .number("force", a.contact.force)
      .number("force_share", a.contact.share);
  if (!a.contact.excluded)
    message.number("pressure", a.contact.pressure).number("pressure_share", a.contact.pressure_share);
  return message.done();
}

std::string eventMessage(const tune::MarginEvent& e) {
  const tune::PassResult& pass = e.recording->pass;
  return MessageText()
      .number("t", e.t0)
      .number("t1", e.t1)
      .number("t_nearest", e.t_nearest)
      .text("recording", e.recording->recording)
      .text("part", pass.parts[e.part].part)
      .text("link", pass.links[e.link])
      .text("kind", e.kind == tune::MarginEvent::Kind::kIntrusion ? "intrusion" : "between_frames")
      .number("min_clearance", e.min_clearance)
      .number("braking_clearance", e.braking)
      .flag("false_stop", e.false_stop)
      .flag("missed_stop", e.missed)
      .number("lead_time", e.lead_time.value_or(kInfinity))
      .done();
}

}  // namespace abstand::results
