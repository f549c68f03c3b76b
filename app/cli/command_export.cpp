// abstand export: exports results of `tune --out`.
#include "app/cli/command_line.hpp"
#include "app/cli/contact_csv.hpp"
#include "app/cli/csv_field.hpp"
#include "app/cli/pair_csv.hpp"
#include "app/cli/separation_csv.hpp"
#include "app/cli/version.hpp"
#include "app/results/mcap_results.hpp"
#include "app/tune/part_frames.hpp"
#include "app/tune/tune_answer.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"

namespace abstand::cli {
namespace {

struct ExportArguments {
  std::vector<std::string> folders;
  std::string csv, pairs_csv, separation_csv, contact_csv, mcap, margin;
};

/// Returns the number of rows.
std::size_t writeClearances(const tune::TuneAnswer& answer, const std::filesystem::path& file) {
  OutputFile out(file);
  out.stream() << "recording,t,part,link,distance,bound,uncertainty,clearance,robot_speed,person_speed\n";
  std::size_t rows = 0;
  for (const tune::TunedRecording& r : answer.recordings) {
    const tune::PartFrames frames(r);
    for (std::size_t i = 0; i < r.frames; ++i)
      for (const tune::PartClearance& p : frames.parts()) {
        out.stream() << csvField(r.recording) << ',' << formatDouble(p.track.t[i]) << ',' << p.part << ','
                     << csvField(r.pass.links[p.link[i]]);
        for (const double v : {p.distance[i], p.bound[i], p.uncertainty[i], p.track.clearance[i],
                               p.robot_speed[i], p.person_speed[i]})
          out.stream() << ',' << formatDouble(v);
        out.stream() << '\n';
        ++rows;
      }
  }
  out.commit();
  return rows;
}

int runExport(const CommandLine& line, const ExportArguments& args) {
  if (args.csv.empty() && args.pairs_csv.empty() && args.separation_csv.empty() && args.contact_csv.empty() &&
      args.mcap.empty())
    throw UsageError(
        "found none of --csv, --pairs-csv, --separation-csv, --contact-csv and --mcap, expected a file to "
        "write");
  if (!args.margin.empty() && args.mcap.empty())
    throw UsageError(
        "--margin: found without --mcap, expected --mcap, which writes the events at that margin");
  results::McapOptions options{std::string("abstand ") + kVersion, {}};
  if (!args.margin.empty()) options.margin = numberWithin(args.margin, "--margin", 0.0, 10.0, "m");
  const tune::TuneAnswer answer = tune::mergedAnswer({args.folders.begin(), args.folders.end()});
  nlohmann::ordered_json document{{"recordings", answer.recordings.size()}};
  std::string text;
  if (!args.csv.empty()) {
    const std::size_t rows = writeClearances(answer, args.csv);
    document["rows"] = rows;
    text += format("%zu rows of %zu recordings\n", rows, answer.recordings.size());
  }
  if (!args.pairs_csv.empty()) {
    const std::size_t rows = writePairTable(answer.recordings, args.pairs_csv);
    document["pair_rows"] = rows;
    text += format("%zu rows of pairs of %zu recordings\n", rows, answer.recordings.size());
  }
  if (!args.separation_csv.empty()) {
    const std::size_t rows = writeSeparationTable(answer, args.separation_csv);
    document["separation_rows"] = rows;
    text += format("%zu rows of protective distances of %zu recordings\n", rows, answer.recordings.size());
  }
  if (!args.contact_csv.empty()) {
    const std::size_t rows = writeContactTable(answer, args.contact_csv);
    document["contact_rows"] = rows;
    text += format("%zu rows of predicted contacts of %zu recordings\n", rows, answer.recordings.size());
  }
  if (!args.mcap.empty()) {
    const results::McapCounts counts = results::writeMcap(answer, options, args.mcap);
    document["topics"] = counts.topics;
    document["messages"] = counts.messages;
    text += format("%zu messages in %zu topics of %zu recordings\n", counts.messages, counts.topics,
                   answer.recordings.size());
  }
  line.print(document, text);
  return kDone;
}

}  // namespace

void addExport(CLI::App& root, CommandLine& line) {
  auto* command = addCommand(root, line, "export",
                             "exports tune results as a table, and as messages for Foxglove and PlotJuggler",
                             "abstand export results --csv clearances.csv --mcap clearances.mcap");
  auto args = std::make_shared<ExportArguments>();
  command->add_option("FOLDER", args->folders, "folders of `tune --out`")->required();
  line.output(command->add_option("--csv", args->csv, "table to write: one row per frame and body part"));
  line.output(command->add_option("--pairs-csv", args->pairs_csv,
                                  "table to write: one row per frame and pair of body part and link"));
  line.output(command->add_option("--separation-csv", args->separation_csv,
                                  "table to write: one row per frame and body part with the terms of the "
                                  "protective distance"));
  line.output(
      command->add_option("--contact-csv", args->contact_csv,
                          "table to write: one row per frame and body part with the hardest contact that "
                          "could occur"));
  line.output(command->add_option(
      "--mcap", args->mcap, "MCAP file to write: one topic per recording and body part (docs/margins.md)"));
  command->add_option("--margin", args->margin,
                      "margin in m: --mcap also gets a topic with the events at this margin");
  command->callback([&line, args] { line.run = [&line, args] { return runExport(line, *args); }; });
}

}  // namespace abstand::cli
