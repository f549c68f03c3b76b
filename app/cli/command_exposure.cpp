// abstand exposure: who was near what, for how long and where, from results of `tune --out`.
#include "app/cli/command_line.hpp"
#include "app/cli/exposure_texts.hpp"
#include "app/cli/tune_arguments.hpp"
#include "app/cli/version.hpp"
#include "app/report/body_heat_picture.hpp"
#include "app/report/exposure_section.hpp"
#include "app/report/room_heat_picture.hpp"
#include "core/base/output_file.hpp"

namespace abstand::cli {
namespace {

struct ExposureArguments {
  std::vector<std::string> folders;
  std::string segment, html, csv, room, body;
};

int runExposure(const CommandLine& line, const ExposureArguments& args) {
  const double segment = segmentLength(args.segment);
  tune::TuneAnswer answer = tune::mergedAnswer({args.folders.begin(), args.folders.end()});
  answer.exposure = tune::exposureTable(answer.recordings, segment, answer.options.pass.near);
  if (!args.html.empty())
    report::writeExposurePage(answer.exposure, {kVersion, answer.recordings.size()}, args.html);
  if (!args.csv.empty()) {
    OutputFile out(args.csv);
    writeExposureCsv(answer.exposure, out.stream());
    out.commit();
  }
  if (!args.room.empty()) mesh_file::savePly(report::roomHeatMesh(answer.exposure), args.room);
  if (!args.body.empty()) mesh_file::savePly(report::bodyHeatMesh(answer.exposure), args.body);
  line.print(exposureJson(answer), exposureText(answer));
  return kDone;
}

}  // namespace

void addExposure(CLI::App& root, CommandLine& line) {
  auto* command = addCommand(root, line, "exposure",
                             "evaluates tune results: time near each robot, per body part and place",
                             "abstand exposure results --html exposure.html --body body.ply");
  auto args = std::make_shared<ExposureArguments>();
  command->add_option("FOLDER", args->folders, "folders of `tune --out`")->required();
  command->add_option("--segment", args->segment, "length of the program segments in s (default: 1)");
  line.output(command->add_option("--html", args->html, "HTML report with exposure maps of body and room"));
  line.output(
      command->add_option("--csv", args->csv, "table: one row per part, link, pair and program segment"));
  line.output(command->add_option("--room", args->room, "PLY mesh of the floor, coloured by exposure"));
  line.output(command->add_option("--body", args->body, "PLY mesh of a person, coloured by exposure"));
  command->callback([&line, args] { line.run = [&line, args] { return runExposure(line, *args); }; });
}

}  // namespace abstand::cli
