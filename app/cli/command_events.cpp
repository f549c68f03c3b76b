// abstand events: events at a margin, from results of `tune --out`.
#include <cmath>

#include "app/cli/command_line.hpp"
#include "app/cli/json_values.hpp"
#include "app/cli/tune_texts.hpp"
#include "app/tune/margin_events.hpp"
#include "app/tune/tune_answer.hpp"

namespace abstand::cli {
namespace {

using Json = nlohmann::ordered_json;

struct EventArguments {
  std::vector<std::string> folders;
  std::string margin, part, fail_on;
};

/// Condition of `--fail-on`.
bool fails(const std::string& on, const tune::MarginEvent& event) {
  if (on == "missed") return event.missed;
  return on == "intrusion";
}

const char* kindOf(const tune::MarginEvent& event) {
  return event.kind == tune::MarginEvent::Kind::kIntrusion ? "intrusion" : "between_frames";
}

Json eventJson(const tune::MarginEvent& e) {
  const tune::PassResult& pass = e.recording->pass;
  return {{"kind", kindOf(e)},
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
}

std::string eventText(const tune::MarginEvent& e) {
  const tune::PassResult& pass = e.recording->pass;
  const std::string what = e.kind == tune::MarginEvent::Kind::kBetweenFrames ? "between frames, nobody told"
                           : e.missed                                        ? "missed stop"
                           : e.false_stop                                    ? "false stop"
                                                                             : "stop in time";
  const std::string nearest =
      std::isinf(e.min_clearance) ? std::string("not known") : format("%.1f mm", 1e3 * e.min_clearance);
  return format("%9.3f to %9.3f s  %-14s %-20s %12s  %s\n", e.t0, e.t1, pass.parts[e.part].part.c_str(),
                pass.links[e.link].c_str(), nearest.c_str(), what.c_str());
}

int runEvents(const CommandLine& line, const EventArguments& args) {
  const double margin = numberWithin(args.margin, "--margin", 0.0, 10.0, "m");
  if (!args.part.empty()) bodyPart(args.part, "--part");
  const tune::TuneAnswer answer = tune::mergedAnswer({args.folders.begin(), args.folders.end()});
  Json document{{"recordings", answer.recordings.size()},
                {"margin", margin},
                {"limit", answer.options.pass.limit},
                {"events", Json::array()},
                {"approaches", Json::array()}};
  std::string text;
  std::size_t count = 0, missed = 0, false_stops = 0, failing = 0;
  for (const tune::TunedRecording& recording : answer.recordings) {
    const auto events = tune::marginEvents(recording, margin, answer.options.margins(), args.part);
    if (!events.empty()) text += recording.recording + "\n";
    count += events.size();
    for (const tune::MarginEvent& e : events) {
      document["events"].push_back(eventJson(e));
      text += eventText(e);
      missed += e.missed;
      false_stops += e.false_stop;
      failing += fails(args.fail_on, e);
    }
  }
  for (const tune::RankedApproach& r : tune::rankedApproaches(answer))
    if (args.part.empty() || r.recording->pass.parts[r.approach->part].part == args.part)
      document["approaches"].push_back(approachJson(r));
  text += format("%zu events at a margin of %.0f mm in %zu runs: %zu false stops, %zu missed\n", count,
                 1e3 * margin, answer.recordings.size(), false_stops, missed);
  line.print(document, text);
  return failing > 0 ? kLimitBroken : kDone;
}

}  // namespace

void addEvents(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "events", "results of tune: when a margin was broken, by what, and how it ended",
                 "abstand events results --margin 0.2");
  auto args = std::make_shared<EventArguments>();
  command->add_option("FOLDER", args->folders, "folders of `tune --out`")->required();
  command->add_option("--margin", args->margin, "metres")->required();
  command->add_option("--part", args->part, "of this body part only, such as hand_left");
  command->add_option("--fail-on", args->fail_on, "exit 1 for a missed stop, or for any intrusion")
      ->check(CLI::IsMember({"missed", "intrusion"}));
  command->callback([&line, args] { line.run = [&line, args] { return runEvents(line, *args); }; });
}

}  // namespace abstand::cli
