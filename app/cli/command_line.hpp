// Common parts of all subcommands.
#pragma once

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "core/robot_file/mesh_reference.hpp"
#include "core/structure/build_progress.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::cli {

inline constexpr int kSchemaVersion = 1;

/// Exit codes; part of the command line contract.
enum ExitCode : int {
  kDone = 0,
  kLimitBroken = 1,
  kWrongUsage = 2,
  kBadInput = 3,
  kInternal = 4,
  kPartly = 5,
  kInterrupted = 130
};

/// Kind of an output option.
enum class OutputKind : std::uint8_t { kFile, kFolder };

/// The selected subcommand and its common options.
struct CommandLine {
  bool json{false};
  bool quiet{false};
  bool cache{true};          ///< structures may be taken from the user's cache folder
  std::function<int()> run;  ///< set by the selected subcommand
  std::vector<std::pair<const CLI::Option*, OutputKind>> outputs;  ///< of all subcommands
  mutable bool printed{false};                                     ///< print() wrote a document

  /// Registers an option that names an output, for checkOutputs().
  CLI::Option* output(CLI::Option* option, OutputKind kind = OutputKind::kFile) {
    outputs.emplace_back(option, kind);
    return option;
  }
  /// Prints one JSON document, or the text, on stdout; with --quiet nothing (except requested JSON). The text
  /// goes to stderr if an output file is standard output. Throws WriteError.
  void print(nlohmann::ordered_json document, const std::string& text) const;
  /// One line on stderr, "warning: ..."; suppressed by --quiet.
  void warn(const std::string& text) const;
};

/// Adds a subcommand with --json, --quiet and an example in its help.
CLI::App* addCommand(CLI::App& root, CommandLine& line, const std::string& name, const std::string& what,
                     const std::string& example);

/// Adds --package-path, for commands that read robot files.
void addPackagePath(CLI::App* command, robot_file::PackagePaths& packages);

/// Adds --no-cache, for commands that need haptic structures.
void addCacheFlag(CLI::App* command, CommandLine& line);

void addFk(CLI::App& root, CommandLine& line);
void addDynamics(CLI::App& root, CommandLine& line);
void addConvert(CLI::App& root, CommandLine& line);
void addBuild(CLI::App& root, CommandLine& line);
void addHuman(CLI::App& root, CommandLine& line);
void addSkeleton(CLI::App& root, CommandLine& line);
void addPairs(CLI::App& root, CommandLine& line);
void addRenderDepth(CLI::App& root, CommandLine& line);
void addCoverage(CLI::App& root, CommandLine& line);
void addCalibrate(CLI::App& root, CommandLine& line);
void addTrack(CLI::App& root, CommandLine& line);
void addRun(CLI::App& root, CommandLine& line);
void addServe(CLI::App& root, CommandLine& line);
void addCheck(CLI::App& root, CommandLine& line);
void addTune(CLI::App& root, CommandLine& line);
void addMerge(CLI::App& root, CommandLine& line);
void addDiff(CLI::App& root, CommandLine& line);
void addExport(CLI::App& root, CommandLine& line);
void addEvents(CLI::App& root, CommandLine& line);
void addResults(CLI::App& root, CommandLine& line);
void addExposure(CLI::App& root, CommandLine& line);
void addReport(CLI::App& root, CommandLine& line);
void addBench(CLI::App& root, CommandLine& line);
void addVerify(CLI::App& root, CommandLine& line);

/// Parses "0.3,-1,2e-3". Throws UsageError with the name `option`.
std::vector<double> numberList(const std::string& text, const std::string& option);
/// Parses X,Y,Z in m, likewise.
Eigen::Vector3d point(const std::string& text, const std::string& option);
/// Parses a finite number. Throws UsageError with the name `option`.
double number(const std::string& text, const std::string& option);
/// The same within `least` to `most`; `unit` is used in the error.
double numberWithin(const std::string& text, const std::string& option, double least, double most,
                    const std::string& unit);

/// A part of the human model by name. Throws UsageError with the name `option` and the nearest name.
humanmodel::BodyPart bodyPart(const std::string& name, const std::string& option);

nlohmann::ordered_json toJson(const Eigen::Vector3d& v);
nlohmann::ordered_json toJson(const Eigen::Isometry3d& X);  ///< 3 rows of 4
nlohmann::ordered_json toJson(const Eigen::Matrix3d& M);

/// True after Ctrl-C, SIGTERM or SIGHUP.
bool interrupted();

/// A progress bar on stderr if that is a terminal and neither --quiet nor NO_COLOR disables it.
std::function<void(std::size_t, std::size_t)> progressBar(const CommandLine& line, const std::string& label);

/// Progress bar and Ctrl-C for the building of structures.
structure::BuildMonitor buildMonitor(const CommandLine& line);

/// printf into a string.
std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

}  // namespace abstand::cli
