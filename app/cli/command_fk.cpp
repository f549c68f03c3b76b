// abstand fk: forward kinematics of a mechanism file.
#include <algorithm>
#include <chrono>

#include "app/cli/command_line.hpp"
#include "app/cli/robot_texts.hpp"
#include "core/base/error.hpp"
#include "core/robot_file/robot.hpp"
#include "core/scene/cycle_statistics.hpp"

namespace abstand::cli {
namespace {

struct FkArguments {
  std::string mechanism, q;
  std::vector<std::string> wrenches;
  int repeat{0};
  robot_file::PackagePaths packages;  ///< accepted by all commands; frames need no meshes
};

/// Parses FRAME:fx,fy,fz,tx,ty,tz and adds the joint efforts of the wrench.
void addWrench(const mechanism::Mechanism& mechanism, const mechanism::MechanismState& state,
               const std::string& text, std::vector<double>& efforts) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos)
    throw UsageError("--wrench: found '" + text + "', expected FRAME:fx,fy,fz,tx,ty,tz");
  const std::string name = text.substr(0, colon);
  const auto v = numberList(text.substr(colon + 1), "--wrench");
  if (v.size() != 6)
    throw UsageError("--wrench: found " + std::to_string(v.size()) + " numbers, expected six");
  for (std::size_t i = 0; i < mechanism.frames.size(); ++i) {
    if (mechanism.frames[i].name != name) continue;
    mechanism::addJointEfforts(mechanism, state, static_cast<int>(i), state.X_BF[i].translation(),
                               {Vector3d(v[0], v[1], v[2]), Vector3d(v[3], v[4], v[5])}, efforts);
    return;
  }
  throw UsageError("--wrench: the mechanism has no frame '" + name + "'");
}

nlohmann::ordered_json timings(const mechanism::Mechanism& mechanism, const std::vector<double>& q,
                               int repeat) {
  using Steady = std::chrono::steady_clock;
  mechanism::MechanismState state;
  mechanism::forward(mechanism, q, state);
  // A call is shorter than the clock's resolution, so a sample is the mean of a hundred.
  constexpr int kBatch = 100;
  scene::CycleStatistics statistics(kInfinity);
  for (int i = 0; i < repeat; ++i) {
    const auto begin = Steady::now();
    for (int k = 0; k < kBatch; ++k) mechanism::forward(mechanism, q, state);
    statistics.add(std::chrono::duration<double>(Steady::now() - begin).count() / kBatch);
  }
  return {{"median", 1e6 * statistics.median()},
          {"p99", 1e6 * statistics.p99()},
          {"max", 1e6 * statistics.max()}};
}

int runFk(const CommandLine& line, const FkArguments& args) {
  const robot_file::Robot robot = robot_file::loadRobot(args.mechanism);
  for (const auto& warning : robot.warnings) line.warn(warning);
  const mechanism::Mechanism& mechanism = robot.mechanism;
  std::vector<double> q(static_cast<std::size_t>(mechanism.dof), 0.0);
  if (!args.q.empty()) q = numberList(args.q, "--q");
  if (q.size() != static_cast<std::size_t>(mechanism.dof))
    throw UsageError("--q: found " + std::to_string(q.size()) + " values, expected " +
                     std::to_string(mechanism.dof));
  mechanism::MechanismState state;
  mechanism::forward(mechanism, q, state);
  std::vector<double> efforts(q.size(), 0.0);
  for (const auto& w : args.wrenches) addWrench(mechanism, state, w, efforts);

  nlohmann::ordered_json document{{"dof", mechanism.dof}, {"frames", nlohmann::ordered_json::array()}};
  std::string text = format("%s: %d degrees of freedom\n", args.mechanism.c_str(), mechanism.dof);
  for (std::size_t i = 0; i < mechanism.frames.size(); ++i) {
    const auto& frame = mechanism.frames[i];
    const int parent = frame.parent < 0 ? 0 : mechanism.frames[static_cast<std::size_t>(frame.parent)].id;
    document["frames"].push_back(
        {{"id", frame.id}, {"name", frame.name}, {"parent", parent}, {"T", toJson(state.X_BF[i])}});
    const Vector3d p = state.X_BF[i].translation();
    text += format("frame %s: %.6f %.6f %.6f m\n", frame.name.c_str(), p.x(), p.y(), p.z());
  }
  // Reports joint values beyond limits and, with a wrench, efforts that the motors cannot hold.
  mechanism::JointLimitWatch watch(mechanism::dofLimits(mechanism));
  watch.check(kNaN, q, {}, {}, efforts);
  const auto limits = run::reportsOf("", mechanism, watch.breaches(), false);
  for (const run::JointLimitReport& r : limits) line.warn(run::describe(r));
  document["joint_limits"] = jointLimitsJson(limits);
  document["joint_efforts"] = efforts;
  for (std::size_t i = 0; i < efforts.size() && !args.wrenches.empty(); ++i)
    text += format("effort of dof %zu: %.6g\n", i, efforts[i]);
  if (args.repeat > 0) {
    document["cycle_us"] = timings(mechanism, q, args.repeat);
    text += format("one call: %.3f us (median)\n", document["cycle_us"]["median"].get<double>());
  }
  line.print(document, text);
  return kDone;
}

}  // namespace

void addFk(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "fk", "forward kinematics of a mechanism file",
                 "abstand fk data/robots/lwr/lwr4.mech --q 0,0.5,0,-1.2,0,0.8,0 --wrench 7:0,0,10,0,0,0");
  auto args = std::make_shared<FkArguments>();
  command->add_option("MECHANISM", args->mechanism, "robot file (.mech or .urdf)")->required();
  command->add_option("--q", args->q,
                      "joint values a,b,... in SI, in the order of the mapping (default: zeros)");
  command->add_option("--wrench", args->wrenches,
                      "FRAME:fx,fy,fz,tx,ty,tz in world axes at that frame's origin");
  command->add_option("--repeat", args->repeat, "number of call batches to time")
      ->check(CLI::Range(1, 100000000));
  addPackagePath(command, args->packages);
  command->callback([&line, args] { line.run = [&line, args] { return runFk(line, *args); }; });
}

}  // namespace abstand::cli
