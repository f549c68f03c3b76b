// abstand coverage: what a planned depth camera would not see of the people of a recording.
#include <chrono>

#include "app/cli/command_line.hpp"
#include "app/cli/csv_field.hpp"
#include "app/cli/json_values.hpp"
#include "app/coverage/summary.hpp"
#include "app/depth/open_session.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"

namespace abstand::cli {
namespace {

using coverage::Cause;

struct CoverageArguments {
  std::filesystem::path scene, recording, camera, csv;
  std::string sensor, pose, eye, look, nearest, farthest, rate{"10"}, start, end;
  int columns{coverage::CoverageOptions{}.columns};
  robot_file::PackagePaths packages;
};

Transform poseOf(const CoverageArguments& args) {
  if (args.pose.empty()) return tracking::lookingAt(point(args.eye, "--eye"), point(args.look, "--look"));
  const std::vector<double> p = numberList(args.pose, "--pose");
  if (p.size() != 6)
    throw UsageError("--pose: found '" + args.pose +
                     "', expected X,Y,Z,ROLL,PITCH,YAW in metres and radians");
  return fromXyzRpy({p[0], p[1], p[2]}, {p[3], p[4], p[5]});
}

coverage::Sensor sensorOf(const CoverageArguments& args) {
  if (!args.sensor.empty() && !args.camera.empty())
    throw UsageError("--sensor: found together with --camera, expected one of them");
  if (args.eye.empty() != args.look.empty())
    throw UsageError("found one of --eye and --look, expected both or none");
  if (!args.pose.empty() && !args.eye.empty())
    throw UsageError("--pose: found together with --eye and --look, expected one of them");
  const bool placed = !args.pose.empty() || !args.eye.empty();
  if (!placed && args.camera.empty())
    throw UsageError("found no pose of the sensor, expected --pose, --eye with --look, or --camera");
  coverage::Sensor sensor =
      args.camera.empty()
          ? coverage::sensorNamed(args.sensor.empty() ? coverage::sensorNames().front() : args.sensor)
          : coverage::sensorOfFile(args.camera);
  if (placed) sensor.camera.X_WC = poseOf(args);
  if (!args.nearest.empty()) sensor.nearest = number(args.nearest, "--nearest");
  if (!args.farthest.empty()) sensor.farthest = number(args.farthest, "--farthest");
  return sensor;
}

nlohmann::ordered_json sharesJson(const coverage::Shares& shares) {
  nlohmann::ordered_json json;
  for (std::size_t k = 0; k < coverage::kCauses; ++k) json[std::string(coverage::kCauseNames[k])] = shares[k];
  return json;
}

std::string nameOf(Cause cause) {
  return std::string(coverage::kCauseNames[static_cast<std::size_t>(cause)]);
}

nlohmann::ordered_json spanJson(const coverage::HiddenSpan& span) {
  return {{"t0", span.t0}, {"t1", span.t1}, {"cause", nameOf(span.cause)}};
}

nlohmann::ordered_json partJson(const coverage::PartCoverage& part, const coverage::PartSummary& summary) {
  nlohmann::ordered_json spans = nlohmann::ordered_json::array();
  for (const coverage::HiddenSpan& span : summary.spans) spans.push_back(spanJson(span));
  const coverage::HiddenSpan* longest = summary.longest();
  return {{"part", part.name},
          {"seen", coverage::shareOf(summary.times, Cause::kSeen)},
          {"times", sharesJson(summary.times)},
          {"surface", sharesJson(summary.surface)},
          {"longest_hidden", longest ? spanJson(*longest) : nlohmann::ordered_json(nullptr)},
          {"spans", spans}};
}

std::string partLine(const coverage::PartCoverage& part, const coverage::PartSummary& summary) {
  std::string text = format("%-28s seen %5.1f %%", part.name.c_str(),
                            100.0 * static_cast<double>(coverage::shareOf(summary.times, Cause::kSeen)));
  for (std::size_t k = 1; k < coverage::kCauses; ++k)
    if (summary.times[k] > 0.0f)
      text += format(", %s %.1f %%", std::string(coverage::kCauseNames[k]).c_str(),
                     100.0 * static_cast<double>(summary.times[k]));
  if (const coverage::HiddenSpan* longest = summary.longest())
    text += format("; longest hidden %.2f s from %.2f s", longest->t1 - longest->t0, longest->t0);
  return text + '\n';
}

/// One row per part and time.
void writeCoverageCsv(const coverage::Coverage& coverage, const std::filesystem::path& file) {
  OutputFile out(file);
  std::string text = "part,t_s";
  for (const std::string_view name : coverage::kCauseNames) text += "," + std::string(name);
  for (const coverage::PartCoverage& part : coverage.parts)
    for (std::size_t i = 0; i < part.shares.size(); ++i) {
      text += '\n' + csvField(part.name) + ',' + formatDouble(coverage.times[i]);
      for (const float share : part.shares[i]) text += ',' + formatDouble(static_cast<double>(share));
    }
  out.stream() << text << '\n';
  out.commit();
}

int runCoverage(const CommandLine& line, const CoverageArguments& args) {
  coverage::CoverageOptions options;
  options.sensor = sensorOf(args);
  options.rate = number(args.rate, "--rate");
  if (!args.start.empty()) options.start = number(args.start, "--start");
  if (!args.end.empty()) options.end = number(args.end, "--end");
  options.columns = args.columns;
  options.progress = progressBar(line, "times");
  options.interrupted = interrupted;
  session::SessionOptions session_options;
  session_options.recording = args.recording;
  session_options.cache = line.cache;
  session_options.monitor = buildMonitor(line);
  const auto session = depth::openSession(scene_file::loadScene(args.scene, args.packages), session_options);

  const auto begin = std::chrono::steady_clock::now();
  const coverage::Coverage result = coverage::evaluateCoverage(*session, options);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!args.csv.empty()) writeCoverageCsv(result, args.csv);

  nlohmann::ordered_json parts = nlohmann::ordered_json::array();
  std::string text;
  for (const coverage::PartCoverage& part : result.parts) {
    const coverage::PartSummary summary = coverage::summarize(result.times, part.shares);
    parts.push_back(partJson(part, summary));
    text += partLine(part, summary);
  }
  const tracking::DepthCamera& camera = options.sensor.camera;
  const double span = result.times.empty() ? 0.0 : result.times.back() - result.times.front();
  const nlohmann::ordered_json document{
      {"pose", toJson(camera.X_WC)},
      {"sensor",
       {{"width", camera.width},
        {"height", camera.height},
        {"fx", camera.fx},
        {"fy", camera.fy},
        {"nearest", options.sensor.nearest},
        {"farthest", options.sensor.farthest}}},
      {"rate", options.rate},
      {"columns", result.columns},
      {"rows", result.rows},
      {"times", result.times.size()},
      {"t0", numberOrNull(result.times.empty() ? kNaN : result.times.front())},
      {"t1", numberOrNull(result.times.empty() ? kNaN : result.times.back())},
      {"seen_share", coverage::kSeenShare},
      {"parts", parts},
      {"remarks", session->remarks()},
      {"times_real_time", span / seconds},
      {"interrupted", result.interrupted}};
  line.print(document,
             text + format("%zu times of %.2f s, occluders in %d x %d pixels; %.0f times real time\n",
                           result.times.size(), span, result.columns, result.rows, span / seconds));
  return result.interrupted ? kInterrupted : kDone;
}

}  // namespace

void addCoverage(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "coverage", "finds what a planned depth camera would not see of people, and why",
                 "abstand coverage data/scenes/hug_boxing.yaml --eye 3,0,1.5 --look 0.7,0,1.1");
  auto args = std::make_shared<CoverageArguments>();
  command->add_option("SCENE", args->scene, "scene file (.yaml)")->required();
  command->add_option("--recording", args->recording,
                      "recording that moves every person, instead of the scene's");
  command
      ->add_option("--sensor", args->sensor,
                   "lens, image size and range; kinect (default): a Kinect v1; kinect_v2: a Kinect v2")
      ->check(CLI::IsMember(coverage::sensorNames()));
  command->add_option("--camera", args->camera,
                      "camera file, instead of --sensor; its pose holds unless another is given");
  command->add_option("--pose", args->pose,
                      "X,Y,Z,ROLL,PITCH,YAW of the optical frame (x right, y down, z forward), m and rad");
  command->add_option("--eye", args->eye, "X,Y,Z, m: where the sensor is, with --look");
  command->add_option("--look", args->look, "X,Y,Z, m: what it looks at");
  command->add_option("--nearest", args->nearest, "smallest measured depth in m, instead of the sensor's");
  command->add_option("--farthest", args->farthest, "largest measured depth in m, instead of the sensor's");
  command->add_option("--rate", args->rate, "sampled times per second (10)");
  command->add_option("--columns", args->columns,
                      "columns of the images in which occluders are drawn, at most");
  command->add_option("--start", args->start, "s");
  command->add_option("--end", args->end, "s");
  line.output(command->add_option("--csv", args->csv, "table: one row per part and time, shares by cause"));
  addPackagePath(command, args->packages);
  addCacheFlag(command, line);
  command->callback([&line, args] { line.run = [&line, args] { return runCoverage(line, *args); }; });
}

}  // namespace abstand::cli
