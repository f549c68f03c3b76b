#include "app/cli/command_line.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "app/cli/version.hpp"
#include "core/base/error.hpp"
#include "core/base/interrupt.hpp"
#include "core/base/message_line.hpp"
#include "core/base/number.hpp"
#include "core/base/progress_report.hpp"
#include "core/base/standard_output.hpp"

namespace abstand::cli {

namespace {

/// Limit for a line of text output; a line of a long table has some hundred.
constexpr std::size_t kMaxLineBytes = 10'000;

}  // namespace

void CommandLine::print(nlohmann::ordered_json document, const std::string& text) const {
  if (json) {
    nlohmann::ordered_json whole{{"schema_version", kSchemaVersion}, {"version", kVersion}};
    whole.update(document);
    // Names in untrusted files may be in any encoding; invalid UTF-8 becomes a replacement character.
    writeStandardOutput(whole.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  } else if (!quiet) {
    const std::string clean = messageLines(text, kMaxLineBytes);
    if (isStandardOutputClaimed())
      std::cerr << clean << std::flush;
    else
      writeStandardOutput(clean);
  }
  printed = true;
}

void CommandLine::warn(const std::string& text) const {
  if (!quiet) std::cerr << "warning: " << messageLine(text) << "\n";
}

CLI::App* addCommand(CLI::App& root, CommandLine& line, const std::string& name, const std::string& what,
                     const std::string& example) {
  CLI::App* command = root.add_subcommand(name, what);
  command->footer("Example:\n  " + example);
  command->add_flag("--json", line.json, "one JSON document on stdout");
  command->add_flag("--quiet", line.quiet, "print errors only");
  return command;
}

void addPackagePath(CLI::App* command, robot_file::PackagePaths& packages) {
  command->add_option(
      "--package-path", packages.folders,
      "folders that hold ROS packages, before those of ROS_PACKAGE_PATH, AMENT_PREFIX_PATH and "
      "CMAKE_PREFIX_PATH");
}

void addCacheFlag(CLI::App* command, CommandLine& line) {
  command->add_flag("--no-cache{false}", line.cache,
                    "rebuild all structures (cached in ~/.cache/abstand, or $ABSTAND_CACHE)");
}

double number(const std::string& text, const std::string& option) {
  const auto v = parseDouble(text);
  if (!v) throw UsageError(option + ": found '" + text + "', expected a finite number");
  return *v;
}

double numberWithin(const std::string& text, const std::string& option, double least, double most,
                    const std::string& unit) {
  const double v = number(text, option);
  if (v < least || v > most)
    throw UsageError(option + ": found " + text + ", expected " + format("%g to %g", least, most) +
                     (unit.empty() ? "" : " " + unit));
  return v;
}

humanmodel::BodyPart bodyPart(const std::string& name, const std::string& option) {
  if (const auto part = humanmodel::parsePart(name)) return *part;
  const auto names = humanmodel::partNames();
  const std::string near = nearestName(name, {names.begin(), names.end()});
  throw UsageError(option + ": found the unknown part '" + name + "'" +
                   (near.empty() ? "" : ", did you mean '" + near + "'?"));
}

std::vector<double> numberList(const std::string& text, const std::string& option) {
  std::vector<double> values;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    values.push_back(number(text.substr(begin, end - begin), option));
    if (end == text.size()) return values;
    begin = end + 1;
  }
}

Eigen::Vector3d point(const std::string& text, const std::string& option) {
  const std::vector<double> p = numberList(text, option);
  if (p.size() != 3) throw UsageError(option + ": found '" + text + "', expected X,Y,Z in metres");
  return {p[0], p[1], p[2]};
}

nlohmann::ordered_json toJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

nlohmann::ordered_json toJson(const Eigen::Isometry3d& X) {
  auto rows = nlohmann::ordered_json::array();
  for (int i = 0; i < 3; ++i)
    rows.push_back({X.matrix()(i, 0), X.matrix()(i, 1), X.matrix()(i, 2), X.matrix()(i, 3)});
  return rows;
}

nlohmann::ordered_json toJson(const Eigen::Matrix3d& M) {
  auto rows = nlohmann::ordered_json::array();
  for (int i = 0; i < 3; ++i) rows.push_back({M(i, 0), M(i, 1), M(i, 2)});
  return rows;
}

bool interrupted() { return interruptRequested(); }

std::function<void(std::size_t, std::size_t)> progressBar(const CommandLine& line, const std::string& label) {
  if (line.quiet) return {};
  const bool on_terminal = ::isatty(STDERR_FILENO) != 0 && !std::getenv("NO_COLOR");
  return ProgressReport(
      messageLine(label), on_terminal,
      [](const std::string& text) {
        std::fputs(text.c_str(), stderr);
        std::fflush(stderr);
      },
      [] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
      });
}

structure::BuildMonitor buildMonitor(const CommandLine& line) {
  structure::BuildMonitor monitor;
  monitor.cancelled = interrupted;
  if (const auto bar = progressBar(line, "build")) {
    monitor.progress = [bar](double fraction, std::string_view) {
      constexpr std::size_t kAll = 1000;
      bar(static_cast<std::size_t>(fraction * kAll), kAll);
    };
  }
  return monitor;
}

std::string format(const char* pattern, ...) {
  char buffer[1024];
  std::va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(buffer, sizeof buffer, pattern, arguments);
  va_end(arguments);
  return buffer;
}

}  // namespace abstand::cli
