// abstand diff: compares two studies of `tune --out`.
#include <cmath>

#include "app/cli/command_line.hpp"
#include "app/cli/tune_arguments.hpp"
#include "app/tune/tune_answer.hpp"

namespace abstand::cli {
namespace {

using Json = nlohmann::ordered_json;

struct DiffArguments {
  std::string before, after, margins{"0:0.5:0.05"};
};

/// Answer of one of the two studies.
tune::TuneAnswer sideOf(const std::string& folder, const std::vector<double>& margins) {
  tune::TuneAnswer side = tune::mergedAnswer({folder});
  side.table = tune::marginTable(side.recordings, margins, side.options);
  return side;
}

std::string millimetres(double v) { return std::isinf(v) ? "none would do" : format("%.0f mm", 1e3 * v); }

int runDiff(const CommandLine& line, const DiffArguments& args) {
  const std::vector<double> margins = marginList(args.margins);
  const tune::TuneAnswer before = sideOf(args.before, margins), after = sideOf(args.after, margins);
  Json document{{"recordings", {before.recordings.size(), after.recordings.size()}},
                {"proposed", Json::array()},
                {"margins", Json::array()}};
  std::string text = format("%-14s %14s %14s\n", "part", "before", "after");
  for (const tune::ProposedMargin& b : before.table.proposed)
    for (const tune::ProposedMargin& a : after.table.proposed) {
      if (a.part != b.part) continue;
      document["proposed"].push_back({{"part", b.part}, {"before", b.margin}, {"after", a.margin}});
      text += format("%-14s %14s %14s%s\n", b.part.c_str(), millimetres(b.margin).c_str(),
                     millimetres(a.margin).c_str(),
                     a.margin > b.margin   ? "  larger"
                     : a.margin < b.margin ? "  smaller"
                                           : "");
    }
  text += format("\n%-14s %22s %22s\n", "margin", "stopped before, after", "missed before, after");
  std::map<std::pair<std::string, double>, const margin::MarginOutcome*> outcome_after;
  for (const tune::MarginRow& a : after.table.rows) outcome_after[{a.part, a.margin}] = &a.outcome;
  for (const tune::MarginRow& row : before.table.rows) {
    const auto found = outcome_after.find({row.part, row.margin});
    if (found == outcome_after.end()) continue;
    const margin::MarginOutcome &b = row.outcome, &a = *found->second;
    document["margins"].push_back({{"part", row.part},
                                   {"margin", row.margin},
                                   {"stopped_share", {b.stoppedShare(), a.stoppedShare()}},
                                   {"false_stops", {b.false_stops, a.false_stops}},
                                   {"missed_stops", {b.missed_stops, a.missed_stops}}});
    if (row.part == tune::kWholeBody)
      text += format("%-14s %10.1f %% %8.1f %% %10ld %10ld\n", millimetres(row.margin).c_str(),
                     100.0 * b.stoppedShare(), 100.0 * a.stoppedShare(), b.missed_stops, a.missed_stops);
  }
  line.print(document, text);
  return kDone;
}

}  // namespace

void addDiff(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "diff", "two studies of tune beside each other: proposed margins, stops",
                 "abstand diff before after");
  auto args = std::make_shared<DiffArguments>();
  command->add_option("BEFORE", args->before, "folder of `tune --out`")->required();
  command->add_option("AFTER", args->after, "another one")->required();
  command->add_option("--margins", args->margins, "FROM:TO:STEP in metres (default: 0:0.5:0.05)");
  command->callback([&line, args] { line.run = [&line, args] { return runDiff(line, *args); }; });
}

}  // namespace abstand::cli
