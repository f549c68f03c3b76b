// abstand results: lists the results in a folder of `tune --out`.
#include <cmath>

#include "app/cli/command_line.hpp"
#include "app/cli/json_values.hpp"
#include "app/results/result_index.hpp"

namespace abstand::cli {
namespace {

using Json = nlohmann::ordered_json;

Json runJson(const results::IndexedRun& run) {
  return {{"recording", run.recording},
          {"key", run.key},
          {"file", run.file},
          {"frames", run.frames},
          {"seconds", run.seconds},
          {"not_judged", run.not_judged},
          {"min_clearance", numberOrNull(run.min_clearance)},
          {"part", run.part},
          {"link", run.link},
          {"t", numberOrNull(run.t)},
          {"proposed", numberOrNull(run.proposed)},
          {"proposed_part", run.proposed_part}};
}

std::string runText(const results::IndexedRun& run) {
  const std::string clearance =
      std::isinf(run.min_clearance) ? std::string("not seen") : format("%.1f mm", 1e3 * run.min_clearance);
  const std::string proposed =
      std::isinf(run.proposed) ? std::string("no margin suffices") : format("%.0f mm", 1e3 * run.proposed);
  return format("%12s  %-14s %-16s %9.3f s %13s  %-14s %8.2f s  %s\n", clearance.c_str(), run.part.c_str(),
                run.link.c_str(), run.t, proposed.c_str(), run.proposed_part.c_str(), run.seconds,
                run.recording.c_str());
}

int runResults(const CommandLine& line, const std::string& folder) {
  const results::ResultIndex index = results::resultIndex(folder);
  Json document{{"rebuilt", index.rebuilt}, {"runs", Json::array()}, {"unreadable", Json::array()}};
  std::string text = format("%12s  %-14s %-16s %11s %13s  %-14s %10s  %s\n", "clearance", "part", "link",
                            "at", "needed", "by", "length", "run");
  for (const results::IndexedRun& run : index.runs) {
    document["runs"].push_back(runJson(run));
    text += runText(run);
  }
  for (const results::UnreadableResult& bad : index.unreadable) {
    document["unreadable"].push_back({{"file", bad.file}, {"error", bad.error}});
    line.warn(bad.file + ": " + bad.error);
  }
  if (!index.not_written.empty()) line.warn("the index could not be written: " + index.not_written);
  line.print(document, text);
  return index.unreadable.empty() ? kDone : kPartly;
}

}  // namespace

void addResults(CLI::App& root, CommandLine& line) {
  auto* command = addCommand(root, line, "results",
                             "lists the runs in a folder of `tune --out`, smallest clearance first",
                             "abstand results results");
  auto folder = std::make_shared<std::string>();
  command->add_option("FOLDER", *folder, "folder of `tune --out`")->required();
  command->callback([&line, folder] { line.run = [&line, folder] { return runResults(line, *folder); }; });
}

}  // namespace abstand::cli
