// abstand events: events at a margin, from results of `tune --out`.
#include <cmath>

#include "app/cli/command_line.hpp"
#include "app/cli/json_values.hpp"
#include "app/cli/tune_texts.hpp"
#include "app/tune/margin_strategy.hpp"
#include "app/tune/set_events.hpp"
#include "app/tune/stop_term.hpp"
#include "app/tune/tune_answer.hpp"

namespace abstand::cli {
namespace {

using Json = nlohmann::ordered_json;

struct EventArguments {
  std::vector<std::string> folders;
  std::string margin, margin_set, part, fail_on;
};

/// One margin for each part by itself, or a set for all pairs together.
struct AskedEvents {
  std::optional<double> margin;  ///< m
  std::optional<tune::MarginRules> rules;

  std::vector<tune::MarginEvent> of(const tune::TunedRecording& recording,
                                    const margin::MarginOptions& options, const std::string& part) const {
    if (!rules) return tune::marginEvents(recording, *margin, options, part);
    std::vector<tune::MarginEvent> events = tune::setEvents(recording, *rules, options);
    std::erase_if(events, [&](const tune::MarginEvent& e) {
      return !part.empty() && recording.pass.parts[e.told_part].part != part;
    });
    return events;
  }
  std::string text() const {
    return rules ? "the margins of " + rules->name : format("a margin of %.0f mm", 1e3 * *margin);
  }
};

AskedEvents askedFor(const EventArguments& args) {
  if (args.margin.empty() == args.margin_set.empty())
    throw UsageError(std::string("found ") + (args.margin.empty() ? "neither" : "both") +
                     " --margin and --margin-set, expected one of them");
  if (!args.margin_set.empty()) return {{}, tune::loadMarginRules(args.margin_set)};
  return {numberWithin(args.margin, "--margin", 0.0, 10.0, "m"), {}};
}

/// What `--fail-on` says.
bool fails(const std::string& on, const tune::MarginEvent& event) {
  if (on == "missed") return event.missed;
  return on == "intrusion";
}

const char* kindOf(const tune::MarginEvent& event) {
  return event.kind == tune::MarginEvent::Kind::kIntrusion ? "intrusion" : "between_frames";
}

Json toldJson(const tune::MarginEvent& e) {
  const tune::PassResult& pass = e.recording->pass;
  return {
      {"part", pass.parts[e.told_part].part}, {"link", pass.links[e.told_link]}, {"margin", e.told_margin}};
}

/// S_p at the beginning of a stop; null: the link does not move towards the part.
Json termJson(const tune::MarginEvent& e, const safety::SeparationOptions& options) {
  const auto term = tune::stopTerm(e, options);
  if (!term) return nullptr;
  return {{"needed", term->needed.sum()},
          {"person", term->needed.person},
          {"reaction", term->needed.reaction},
          {"stopping", term->needed.stopping},
          {"constant", term->needed.constant},
          {"largest", term->largest},
          {"clearance", numberOrNull(term->clearance)},
          {"robot_speed", e.told_robot_speed},
          {"violated", term->violated()}};
}

std::string termText(const tune::MarginEvent& e, const safety::SeparationOptions& options) {
  const auto term = tune::stopTerm(e, options);
  return term ? format("; S_p %.0f mm, largest term: %s", 1e3 * term->needed.sum(), term->largest)
              : std::string();
}

/// `by_pair`: the margins differ, so that it matters which one stopped the robot.
Json eventJson(const tune::MarginEvent& e, bool by_pair, const safety::SeparationOptions& options) {
  const tune::PassResult& pass = e.recording->pass;
  Json event{{"kind", kindOf(e)},
             {"recording", e.recording->recording},
             {"part", pass.parts[e.part].part},
             {"link", pass.links[e.link]},
             {"t0", e.t0},
             {"t1", e.t1},
             {"t_nearest", e.t_nearest},
             {"min_clearance", e.min_clearance},
             {"braking_clearance", e.braking},
             {"false_stop", e.false_stop},
             {"missed_stop", e.missed},
             {"lead_time", orNull(e.lead_time)}};
  event["separation"] = termJson(e, options);
  if (by_pair) event["told_by"] = e.kind == tune::MarginEvent::Kind::kIntrusion ? toldJson(e) : Json();
  return event;
}

std::string eventText(const tune::MarginEvent& e, bool by_pair, const safety::SeparationOptions& options) {
  const tune::PassResult& pass = e.recording->pass;
  const std::string what = e.kind == tune::MarginEvent::Kind::kBetweenFrames ? "between frames, not detected"
                           : e.missed                                        ? "missed stop"
                           : e.false_stop                                    ? "false stop"
                                                                             : "stop in time";
  const std::string nearest =
      std::isinf(e.min_clearance) ? std::string("unknown") : format("%.1f mm", 1e3 * e.min_clearance);
  const bool told = by_pair && e.kind == tune::MarginEvent::Kind::kIntrusion;
  const std::string by =
      told ? format(", stopped by %s and %s (%.0f mm)", pass.parts[e.told_part].part.c_str(),
                    pass.links[e.told_link].c_str(), 1e3 * e.told_margin)
           : std::string();
  return format("%9.3f to %9.3f s  %-14s %-20s %12s  %s%s%s\n", e.t0, e.t1, pass.parts[e.part].part.c_str(),
                pass.links[e.link].c_str(), nearest.c_str(), what.c_str(), by.c_str(),
                termText(e, options).c_str());
}

int runEvents(const CommandLine& line, const EventArguments& args) {
  const AskedEvents asked = askedFor(args);
  if (!args.part.empty()) bodyPart(args.part, "--part");
  const tune::TuneAnswer answer = tune::mergedAnswer({args.folders.begin(), args.folders.end()});
  if (asked.rules) tune::checkNames(answer.recordings, *asked.rules);
  Json document{{"recordings", answer.recordings.size()},
                {"margin", orNull(asked.margin)},
                {"margin_set", asked.rules ? Json(asked.rules->name) : Json()},
                {"limit", answer.options.pass.limit},
                {"events", Json::array()},
                {"approaches", Json::array()}};
  const safety::SeparationOptions& separation = answer.options.pass.separation;
  std::string text;
  std::size_t count = 0, missed = 0, false_stops = 0, failing = 0;
  for (const tune::TunedRecording& recording : answer.recordings) {
    const auto events = asked.of(recording, answer.options.margins(), args.part);
    if (!events.empty()) text += recording.recording + "\n";
    count += events.size();
    for (const tune::MarginEvent& e : events) {
      document["events"].push_back(eventJson(e, asked.rules.has_value(), separation));
      text += eventText(e, asked.rules.has_value(), separation);
      missed += e.missed;
      false_stops += e.false_stop;
      failing += fails(args.fail_on, e);
    }
  }
  for (const tune::RankedApproach& r : tune::rankedApproaches(answer))
    if (args.part.empty() || r.recording->pass.parts[r.approach->part].part == args.part)
      document["approaches"].push_back(approachJson(r));
  text += format("%zu events at %s in %zu runs: %zu false stops, %zu missed\n", count, asked.text().c_str(),
                 answer.recordings.size(), false_stops, missed);
  line.print(document, text);
  return failing > 0 ? kLimitBroken : kDone;
}

}  // namespace

void addEvents(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "events", "lists the margin violations in tune results: time, pair and outcome",
                 "abstand events results --margin 0.2");
  auto args = std::make_shared<EventArguments>();
  command->add_option("FOLDER", args->folders, "folders of `tune --out`")->required();
  command->add_option("--margin", args->margin, "margin in metres, for each body part separately");
  command->add_option("--margin-set", args->margin_set,
                      "margins file for parts, links and pairs, evaluated together");
  command->add_option("--part", args->part, "only stops caused by this body part, such as hand_left");
  command->add_option("--fail-on", args->fail_on, "exit 1 for a missed stop, or for any intrusion")
      ->check(CLI::IsMember({"missed", "intrusion"}));
  command->callback([&line, args] { line.run = [&line, args] { return runEvents(line, *args); }; });
}

}  // namespace abstand::cli
