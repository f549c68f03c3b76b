// abstand serve: the live loop over the network.
#include <unistd.h>

#include <iostream>

#include "app/cli/command_line.hpp"
#include "app/cli/robot_texts.hpp"
#include "app/depth/open_session.hpp"
#include "app/serve/layout.hpp"
#include "app/serve/serve_loop.hpp"
#include "app/viewer/viewer_host.hpp"
#include "core/base/error.hpp"
#include "core/base/standard_output.hpp"
#include "core/base/text_file.hpp"
#include "core/config/yaml_document.hpp"
#include "core/control/reaction_reader.hpp"

namespace abstand::cli {
namespace {

using namespace serve;

struct ServeArguments {
  std::string scene, reaction, stale, resume, rate, duration, bind{"127.0.0.1:4780"};
  std::size_t nearest{8};
  std::size_t viewers{viewer::HostOptions().viewers};
  int threads{1};
  robot_file::PackagePaths packages;
  bool layout{false}, from_stdin{false};
};

control::ReactionDescription reactionOf(const ServeArguments& args) {
  control::ReactionDescription reaction = serve::usualReaction();
  if (!args.reaction.empty()) {
    constexpr std::size_t kMaxBytes = 1u << 20;
    const config::YamlNode document = config::parseYaml(readFile(args.reaction, kMaxBytes), args.reaction);
    reaction = control::readReaction(document, args.reaction);
  }
  if (args.reaction.empty() || !args.stale.empty()) {
    const double stale = args.stale.empty() ? 0.1 : numberWithin(args.stale, "--stale", 0.001, 3600.0, "s");
    reaction.watch.input_age = reaction.watch.person_age = stale;
  }
  if (!args.resume.empty())
    reaction.stop.resume_after = numberWithin(args.resume, "--resume", 0.0, 3600.0, "s");
  return reaction;
}

nlohmann::ordered_json layoutJson(const serve::Layout& layout) {
  auto packets = nlohmann::ordered_json::array();
  for (const auto& packet : layout.packets) {
    auto fields = nlohmann::ordered_json::array();
    for (const auto& f : packet.fields)
      fields.push_back({{"offset", f.offset}, {"type", f.type}, {"meaning", f.meaning}});
    packets.push_back({{"packet", packet.title}, {"bytes", packet.bytes}, {"fields", fields}});
  }
  return {{"packets", packets},
          {"states", layout.states},
          {"reasons", layout.reasons},
          {"groups", layout.groups},
          {"objects", layout.objects}};
}

nlohmann::ordered_json stopsJson(const serve::ServedScene& scene) {
  auto list = nlohmann::ordered_json::array();
  for (std::size_t m = 0; m < scene.robots().size(); ++m) {
    const safety::StopLog& log = scene.robots()[m]->stops();
    for (std::size_t i = 0; i < log.kept(); ++i) {
      const safety::StopEntry& e = log.entry(i);
      list.push_back({{"mechanism", scene.format().mechanisms[m].name},
                      {"t", e.t},
                      {"from", safety::stateName(e.from)},
                      {"to", safety::stateName(e.to)},
                      {"reason", safety::reasonName(e.cause.reason)}});
    }
  }
  return list;
}

/// Violations of robot limits by received joint values.
std::vector<run::JointLimitReport> limitsOf(const serve::ServedScene& scene) {
  std::vector<run::JointLimitReport> all;
  for (std::size_t m = 0; m < scene.robots().size(); ++m) {
    const auto own =
        run::reportsOf(scene.format().mechanisms[m].name, scene.session().mechanisms()[m]->mechanism(),
                       scene.robots()[m]->limits().breaches(), false);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

/// Null: without viewers.
nlohmann::ordered_json viewersJson(const viewer::ViewerHost* host) {
  if (!host) return nullptr;
  const viewer::HostCounts& c = host->counts();
  return {{"accepted", c.accepted}, {"refused", c.refused}, {"expired", c.expired},
          {"bad", c.bad},           {"sent", c.sent},       {"left_out", c.left_out}};
}

nlohmann::ordered_json summaryJson(const serve::ServeSummary& s, const serve::ServedScene& scene,
                                   const viewer::ViewerHost* host) {
  nlohmann::ordered_json faults;
  for (std::size_t i = 1; i < serve::kPacketFaults; ++i)
    faults[std::string(serve::faultName(static_cast<serve::PacketFault>(i)))] = s.faults[i];
  faults["foreign"] = s.streams.foreign;
  return {
      {"seconds", s.seconds},
      {"packets", s.packets},
      {"lines", s.lines},
      {"joints", s.joints},
      {"skeletons", s.skeletons},
      {"controls", s.controls},
      {"answered", s.answered},
      {"unasked", s.unasked},
      {"unsent", s.unsent},
      {"bad", s.bad},
      {"bad_by_reason", faults},
      {"late", s.streams.late},
      {"lost", s.streams.lost},
      {"duplicates", s.streams.duplicates},
      {"cycle_us",
       {{"median", 1e6 * s.cycles.median()}, {"p99", 1e6 * s.cycles.p99()}, {"max", 1e6 * s.cycles.max()}}},
      {"stops", stopsJson(scene)},
      {"viewers", viewersJson(host)},
      {"joint_limits", jointLimitsJson(limitsOf(scene))},
      {"interrupted", s.interrupted}};
}

std::string summaryText(const serve::ServeSummary& s, const serve::ServedScene& scene) {
  std::string text = format("%.1f s: %ld packets, %ld of joints, %ld skeletons; %ld answered, %ld unasked\n",
                            s.seconds, s.packets, s.joints, s.skeletons, s.answered, s.unasked);
  text += format("dropped: %ld bad, %ld late, %ld duplicates; %ld lost\n", s.bad, s.streams.late,
                 s.streams.duplicates, s.streams.lost);
  text += format("cycle: median %.0f us, p99 %.0f, max %.0f\n", 1e6 * s.cycles.median(), 1e6 * s.cycles.p99(),
                 1e6 * s.cycles.max());
  for (std::size_t m = 0; m < scene.robots().size(); ++m) {
    const safety::StopLog& log = scene.robots()[m]->stops();
    for (std::size_t i = 0; i < log.kept(); ++i)
      text += scene.format().mechanisms[m].name + ": " + safety::describe(log.entry(i)) + "\n";
  }
  return text + jointLimitsText(limitsOf(scene));
}

/// Null if there are to be none, or if their port is taken: the loop is more important.
std::unique_ptr<viewer::ViewerHost> hostFor(const CommandLine& line, const ServeArguments& args,
                                            const serve::Address& address, serve::ServedScene& scene) {
  if (args.viewers == 0) return nullptr;
  try {
    return std::make_unique<viewer::ViewerHost>(address, viewer::cardOf(scene), scene,
                                                viewer::HostOptions{args.viewers});
  } catch (const std::exception& e) {
    line.warn(std::string("no viewers: ") + e.what());
    return nullptr;
  }
}

int runServe(const CommandLine& line, const ServeArguments& args) {
  // Checks the whole command line before expensive work.
  const serve::Address bind = serve::parseAddress(args.bind, "--bind");
  serve::ServedOptions served{
      .reaction = reactionOf(args), .nearest = args.nearest, .scene_first = args.reaction.empty()};
  serve::ServeOptions options;
  options.stale = served.reaction.watch.input_age;
  options.interrupted = interrupted;
  if (args.from_stdin) options.lines_from = STDIN_FILENO;
  if (!args.rate.empty()) options.rate = numberWithin(args.rate, "--rate", 0.1, 1e5, "Hz");
  if (!args.duration.empty()) options.duration = numberWithin(args.duration, "--duration", 0.0, 1e9, "s");
  session::SessionOptions session;
  session.threads = args.threads;
  session.cache = line.cache;
  session.monitor = buildMonitor(line);
  session.remember = true;
  // Culling relies on speed bounds of the scene file, which apply to its own motion only.
  session.rest = 0.0;
  serve::ServedScene scene(depth::openSession(scene_file::loadScene(args.scene, args.packages), session),
                           served);
  for (const auto& remark : scene.remarks()) line.warn(remark);
  if (args.layout) {
    if (line.json)
      line.print(layoutJson(serve::layoutOf(scene.format(), scene.names(), scene.report())), "");
    else
      writeStandardOutput(serve::describeLayout(scene.format(), scene.names(), scene.report()));
    return kDone;
  }
  serve::UdpSocket socket(bind);
  const auto host = hostFor(line, args, socket.address(), scene);
  options.observer = host.get();
  serve::ServeLoop loop(scene, socket, options);
  if (!line.quiet) std::cerr << "serve: listening on " << serve::describe(socket.address()) << std::endl;
  loop.run();
  if (host) host->stop();
  line.print(summaryJson(loop.summary(), scene, host.get()), summaryText(loop.summary(), scene));
  return loop.summary().interrupted ? kInterrupted : kDone;
}

}  // namespace

void addServe(CLI::App& root, CommandLine& line) {
  auto* command = addCommand(root, line, "serve",
                             "serves a scene over UDP: receives joint values and skeletons, sends distances, "
                             "forces, torques and stops",
                             "abstand serve data/scenes/hug_boxing.yaml --bind 127.0.0.1:4780");
  auto args = std::make_shared<ServeArguments>();
  command->add_option("SCENE", args->scene, "scene file")->required();
  command->add_option("--bind", args->bind,
                      "address and port; port 0: the system chooses (default 127.0.0.1:4780)");
  command->add_option("--stale", args->stale,
                      "s after which input is stale and robots stop (default 0.1, or as set by --reaction)");
  command->add_option("--resume", args->resume,
                      "time in s without a cause after which a protective stop ends automatically (default: "
                      "it waits for a reset)");
  command->add_option("--reaction", args->reaction,
                      "YAML of a reaction (docs/control.md), of all mechanisms (default: the scene's)");
  command->add_option("--rate", args->rate,
                      "Hz: cycles and answers at this rate instead of one for each packet");
  command->add_option("--duration", args->duration, "duration in s (default: until Ctrl-C)");
  command->add_option("--nearest", args->nearest, "nearest pairs that an answer lists (default 8)")
      ->check(CLI::Range(0, 256));
  command
      ->add_option("--viewers", args->viewers,
                   "viewers that may connect over TCP at the same port (default 4; 0: none)")
      ->check(CLI::Range(std::size_t{0}, viewer::HostOptions::kMaxViewers));
  command->add_option("--threads", args->threads, "threads of a cycle (0: all cores; default 1)")
      ->check(CLI::Range(0, 256));
  command->add_flag("--stdin", args->from_stdin,
                    "also read skeletons as JSON lines from standard input (docs/serve.md)");
  command->add_flag("--layout", args->layout, "print the layout of all packets of the scene and exit");
  addPackagePath(command, args->packages);
  addCacheFlag(command, line);
  command->callback([&line, args] { line.run = [&line, args] { return runServe(line, *args); }; });
}

}  // namespace abstand::cli
