// abstand convert: converts robot files, and reports the deviation.
#include <algorithm>
#include <cmath>

#include "app/cli/command_line.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/robot_file/dh_mechanism.hpp"
#include "core/robot_file/mech_file.hpp"
#include "core/robot_file/robot_writer.hpp"
#include "core/robot_file/urdf_file.hpp"

namespace abstand::cli {
namespace {

// m and rad. Largest accepted deviation of a posture.
constexpr double kExact = 1e-9;

struct ConvertArguments {
  std::filesystem::path in, out;
  int postures{1000};
  robot_file::PackagePaths packages;
};

/// Adapts mesh names to an output file in another folder.
void rebase(robot_file::Robot& robot, const ConvertArguments& args, std::vector<std::string>& warnings) {
  robot_file::MeshFinder finder(args.in, args.packages);
  std::error_code ec;
  const auto folder =
      std::filesystem::weakly_canonical(std::filesystem::absolute(args.out, ec), ec).parent_path();
  for (auto& g : robot.geometry) {
    if (g.shape) continue;
    if (const auto file = finder.find(g.mesh)) {
      const auto relative = std::filesystem::weakly_canonical(*file, ec).lexically_relative(folder);
      g.mesh = (relative.empty() ? *file : relative).string();
    } else {
      warnings.push_back(g.pos.file + ":" + std::to_string(g.pos.line) + ": found no file " + g.mesh +
                         ": its name is kept unchanged");
    }
  }
  warnings.insert(warnings.end(), finder.remarks().begin(), finder.remarks().end());
}

struct Written {
  std::string text;
  robot_file::Robot robot;    ///< as read back from the text
  std::vector<double> scale;  ///< of its joint values; empty: all 1
  std::size_t extra_frames{0};
  robot_file::PostureResidual residual;
};

Written writeMech(const robot_file::Robot& robot, const ConvertArguments& args,
                  const robot_file::DhTolerance& tolerance) {
  Written w;
  const robot_file::Robot table = robot_file::toDh(robot, tolerance);
  w.extra_frames = table.mechanism.frames.size() - robot.mechanism.frames.size();
  w.text = robot_file::mechText(table);
  w.robot = robot_file::parseMech(w.text, args.out.string());
  w.residual = robot_file::postureResidual(robot.mechanism, w.robot.mechanism, args.postures);
  return w;
}

Written write(const robot_file::Robot& robot, const ConvertArguments& args) {
  const std::string extension = args.out.extension().string();
  if (extension == ".mech") {
    Written w = writeMech(robot, args, {});
    // Rounding in the file adds up over many joints: extra frames are preferred to an inexact table.
    if (w.residual.position > kExact || w.residual.angle > kExact) w = writeMech(robot, args, {1e-14, 1e-15});
    return w;
  }
  if (extension != ".urdf")
    throw UsageError("found the file " + args.out.string() + ", expected the extension .mech or .urdf");
  Written w;
  robot_file::UrdfWritten urdf = robot_file::urdfText(robot);
  w.text = std::move(urdf.text);
  w.scale = std::move(urdf.scale);
  w.robot = robot_file::parseUrdf(w.text, args.out.string());
  w.residual = robot_file::postureResidual(robot.mechanism, w.robot.mechanism, args.postures, w.scale);
  return w;
}

/// Warning with the joints whose acceleration limits a URDF cannot store; empty: none.
std::string lostAccelerations(const mechanism::Mechanism& mechanism) {
  std::string joints;
  for (const auto& f : mechanism.frames)
    if (std::isfinite(f.limits.acceleration))
      joints += (joints.empty() ? "" : ", ") + (f.joint.empty() ? f.name : f.joint);
  return joints.empty() ? joints : "dropped the acceleration limits, which URDF does not support: " + joints;
}

int runConvert(const CommandLine& line, const ConvertArguments& args) {
  robot_file::Robot robot = robot_file::loadRobot(args.in);
  std::vector<std::string> warnings = robot.warnings;
  rebase(robot, args, warnings);
  const Written w = write(robot, args);
  writeFile(args.out, w.text);

  for (std::size_t i = 0; i < w.scale.size(); ++i)
    if (w.scale[i] != 1.0)
      warnings.push_back(
          format("the value of dof %zu is %g times that of the source: URDF does not support a scale", i,
                 w.scale[i]));
  if (args.out.extension() == ".urdf")
    if (const std::string lost = lostAccelerations(robot.mechanism); !lost.empty()) warnings.push_back(lost);
  for (const auto& warning : warnings) line.warn(warning);
  const bool exact = w.residual.position <= kExact && w.residual.angle <= kExact;
  nlohmann::ordered_json document{{"file", args.out.string()},
                                  {"dof", robot.mechanism.dof},
                                  {"frames", robot.mechanism.frames.size()},
                                  {"extra_frames", w.extra_frames},
                                  {"geometry", robot.geometry.size()},
                                  {"residual",
                                   {{"postures", w.residual.postures},
                                    {"position", w.residual.position},
                                    {"angle", w.residual.angle},
                                    {"frame", w.residual.frame}}},
                                  {"exact", exact},
                                  {"warnings", warnings}};
  line.print(document,
             format("%s: %d degrees of freedom, %zu frames and %zu more for the table, %zu geometries\n"
                    "residual over %d postures: %.3g m, %.3g rad\n",
                    args.out.c_str(), robot.mechanism.dof, robot.mechanism.frames.size(), w.extra_frames,
                    robot.geometry.size(), w.residual.postures, w.residual.position, w.residual.angle));
  return exact ? kDone : kPartly;
}

}  // namespace

void addConvert(CLI::App& root, CommandLine& line) {
  auto* command = addCommand(root, line, "convert", "a robot file in the other format, with the residual",
                             "abstand convert robot.urdf robot.mech");
  auto args = std::make_shared<ConvertArguments>();
  command->add_option("IN", args->in, "robot file (.mech or .urdf)")->required();
  line.output(command->add_option("OUT", args->out, "robot file to write, .mech or .urdf by its extension"))
      ->required();
  command->add_option("--postures", args->postures, "random postures that are compared")
      ->check(CLI::Range(1, 10000000));
  addPackagePath(command, args->packages);
  command->callback([&line, args] { line.run = [&line, args] { return runConvert(line, *args); }; });
}

}  // namespace abstand::cli
