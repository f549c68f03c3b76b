// abstand diff: compares two studies of `tune --out`.
#include <cmath>
#include <set>

#include "app/cli/command_line.hpp"
#include "app/cli/tune_arguments.hpp"
#include "app/tune/margin_strategy.hpp"
#include "app/tune/tune_answer.hpp"

namespace abstand::cli {
namespace {

using Json = nlohmann::ordered_json;

struct DiffArguments {
  std::string before, after, margins{"0:0.5:0.05"};
  std::vector<std::string> margin_sets;
};

/// The answers of one or two studies.
struct Sides {
  std::vector<tune::TuneAnswer> of;
  bool two() const { return of.size() == 2; }
};

Sides sidesOf(const DiffArguments& args) {
  const std::vector<double> margins = marginList(args.margins);
  Sides sides;
  for (const std::string& folder : {args.before, args.after}) {
    if (folder.empty()) continue;
    sides.of.push_back(tune::mergedAnswer({folder}));
    tune::TuneAnswer& side = sides.of.back();
    side.table = tune::marginTable(side.recordings, margins, side.options);
  }
  return sides;
}

std::string millimetres(double v) {
  return std::isinf(v) ? "no margin suffices" : format("%.0f mm", 1e3 * v);
}

void addProposed(const tune::TuneAnswer& before, const tune::TuneAnswer& after, Json& document,
                 std::string& text) {
  text += format("%-14s %14s %14s\n", "part", "before", "after");
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
}

void addMargins(const tune::TuneAnswer& before, const tune::TuneAnswer& after, Json& document,
                std::string& text) {
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
}

/// Every set over each side.
void addSets(const Sides& sides, const std::vector<tune::MarginRules>& sets, Json& document,
             std::string& text) {
  std::vector<std::vector<tune::StrategyOutcome>> outcomes;
  for (const tune::TuneAnswer& side : sides.of)
    outcomes.push_back(tune::strategyOutcomes(side.recordings, sets, side.options.margins()));
  text += format("%s%-30s %10s %10s %10s %10s\n", sides.two() ? "\n" : "", "margins", "stops", "false",
                 "missed", "stopped");
  for (std::size_t s = 0; s < sets.size(); ++s) {
    Json row{{"name", sets[s].name}};
    for (const char* key : {"stops", "stopped_share", "false_stops", "missed_stops", "unseen"})
      row[key] = Json::array();
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      const margin::MarginOutcome& o = outcomes[i][s].outcome;
      row["stops"].push_back(o.stops);
      row["stopped_share"].push_back(o.stoppedShare());
      row["false_stops"].push_back(o.false_stops);
      row["missed_stops"].push_back(o.missed_stops);
      row["unseen"].push_back(o.unseen);
      const std::string name = sets[s].name + (sides.two() ? i == 0 ? ", before" : ", after" : "");
      text += format("%-30s %10ld %10ld %10ld %8.1f %%\n", name.c_str(), o.stops, o.false_stops,
                     o.missed_stops, 100.0 * o.stoppedShare());
    }
    document["margin_sets"].push_back(std::move(row));
  }
}

Json marginJson(const margin::PairMargin& m) {
  return {{"margin", m.margin}, {"robot_time", m.robot_time}, {"person_time", m.person_time}};
}

/// Pairs of the first study for which two sets do not say the same.
void addDifferences(const tune::TuneAnswer& study, const tune::MarginRules& a, const tune::MarginRules& b,
                    Json& document, std::string& text) {
  std::set<std::pair<std::string, std::string>> pairs;
  for (const tune::TunedRecording& r : study.recordings)
    for (const tune::PassResult::PairOfNames& pair : r.pass.pairs)
      pairs.insert({r.pass.parts[pair.part].part, r.pass.links[pair.link]});
  const auto text_of = [](const margin::PairMargin& m) {
    std::string s = millimetres(m.margin);
    if (m.robot_time > 0.0) s += format(" + %g s robot", m.robot_time);
    if (m.person_time > 0.0) s += format(" + %g s person", m.person_time);
    return s;
  };
  std::size_t count = 0;
  text += "\npairs with another margin in " + b.name + "\n";
  for (const auto& [part, link] : pairs) {
    const auto of_a = a.of(part, link), of_b = b.of(part, link);
    if (!of_a || !of_b || *of_a == *of_b) continue;
    document["differences"].push_back(
        {{"part", part}, {"link", link}, {"margins", {marginJson(*of_a), marginJson(*of_b)}}});
    text += format("%-14s %-20s %s -> %s\n", part.c_str(), link.c_str(), text_of(*of_a).c_str(),
                   text_of(*of_b).c_str());
    ++count;
  }
  text += format("%zu of %zu pairs\n", count, pairs.size());
}

int runDiff(const CommandLine& line, const DiffArguments& args) {
  if (args.after.empty() && args.margin_sets.size() < 2)
    throw UsageError("found one folder and " + std::to_string(args.margin_sets.size()) +
                     " --margin-set, expected two folders, or two margin sets to evaluate over one");
  std::vector<tune::MarginRules> sets;
  for (const std::string& file : args.margin_sets) sets.push_back(tune::loadMarginRules(file));
  const Sides sides = sidesOf(args);
  Json document{{"recordings", Json::array()},
                {"proposed", Json::array()},
                {"margins", Json::array()},
                {"margin_sets", Json::array()},
                {"differences", Json::array()}};
  for (const tune::TuneAnswer& side : sides.of) document["recordings"].push_back(side.recordings.size());
  std::string text;
  if (sides.two()) {
    addProposed(sides.of[0], sides.of[1], document, text);
    addMargins(sides.of[0], sides.of[1], document, text);
  }
  if (!sets.empty()) addSets(sides, sets, document, text);
  if (sets.size() == 2) addDifferences(sides.of[0], sets[0], sets[1], document, text);
  line.print(document, text);
  return kDone;
}

}  // namespace

void addDiff(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "diff",
                 "compares two tune studies, or two margin sets over one study: proposed margins and stops",
                 "abstand diff before after");
  auto args = std::make_shared<DiffArguments>();
  command->add_option("BEFORE", args->before, "folder of `tune --out`")->required();
  command->add_option("AFTER", args->after, "another one");
  command->add_option(
      "--margin-set", args->margin_sets,
      "file of margins for parts, links and pairs, evaluated for each folder; may be repeated");
  command->add_option("--margins", args->margins, "FROM:TO:STEP in metres (default: 0:0.5:0.05)");
  command->callback([&line, args] { line.run = [&line, args] { return runDiff(line, *args); }; });
}

}  // namespace abstand::cli
