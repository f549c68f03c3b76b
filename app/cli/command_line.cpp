#include "app/cli/command_line.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "app/cli/version.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand::cli {
namespace {

std::atomic<bool> interrupt_seen{false};
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

void CommandLine::print(nlohmann::ordered_json document, const std::string& text) const {
  if (json) {
    nlohmann::ordered_json whole{{"schema_version", kSchemaVersion}, {"version", kVersion}};
    whole.update(document);
    // Names in strangers' files may be in any encoding; what is no UTF-8 becomes a replacement character.
    std::cout << whole.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << std::endl;
  } else if (!quiet) {
    std::cout << text << std::flush;
  }
}

void CommandLine::warn(const std::string& text) const {
  if (!quiet) std::cerr << "warning: " << text << "\n";
}

CLI::App* addCommand(CLI::App& root, CommandLine& line, const std::string& name, const std::string& what,
                     const std::string& example) {
  CLI::App* command = root.add_subcommand(name, what);
  command->footer("Example:\n  " + example);
  command->add_flag("--json", line.json, "one JSON document on stdout");
  command->add_flag("--quiet", line.quiet, "say nothing but errors");
  return command;
}

void addPackagePath(CLI::App* command, PackagePaths& packages) {
  command->add_option(
      "--package-path", packages.folders,
      "folders that hold ROS packages, before those of ROS_PACKAGE_PATH, AMENT_PREFIX_PATH and "
      "CMAKE_PREFIX_PATH");
}

void addCacheFlag(CLI::App* command, CommandLine& line) {
  command->add_flag("--no-cache{false}", line.cache,
                    "build all structures anew (they are kept in ~/.cache/abstand, or $ABSTAND_CACHE)");
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

bool interrupted() { return interrupt_seen.load(std::memory_order_relaxed); }

void catchInterrupts() {
  std::signal(SIGINT, [](int) { interrupt_seen.store(true, std::memory_order_relaxed); });
}

std::function<void(std::size_t, std::size_t)> progressBar(const CommandLine& line, const std::string& label) {
  if (line.quiet || !::isatty(STDERR_FILENO) || std::getenv("NO_COLOR")) return {};
  return [label, last = std::size_t{1000}](std::size_t done, std::size_t all) mutable {
    const std::size_t percent = all ? 100 * done / all : 100;
    if (percent == last) return;
    last = percent;
    std::fprintf(stderr, "\r%s %3zu %%%s", label.c_str(), percent, done == all ? "\n" : "");
    std::fflush(stderr);
  };
}

BuildMonitor buildMonitor(const CommandLine& line) {
  BuildMonitor monitor;
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
