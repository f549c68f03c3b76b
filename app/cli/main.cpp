// abstand: distances and contact between people and robots, command line program.
#include <cstdio>
#include <iostream>
#include <sstream>

#include "app/cli/command_line.hpp"
#include "app/cli/output_check.hpp"
#include "app/cli/version.hpp"
#include "core/base/error.hpp"
#include "core/base/input_log.hpp"
#include "core/base/interrupt.hpp"
#include "core/base/message_line.hpp"
#include "core/base/standard_output.hpp"
#include "core/base/write_error.hpp"

namespace {

using namespace abstand;

int fail(int code, const std::string& text) {
  // An error and its hint; only these have two lines.
  const auto hint = text.find("\nhint: ");
  std::cerr << messageLine(text.substr(0, hint)) << "\n";
  if (hint != text.npos) std::cerr << messageLine(text.substr(hint + 1)) << "\n";
  std::cerr << std::flush;
  return code;
}

/// Message for a command interrupted before it had a report.
int endInterrupted(const cli::CommandLine& line) {
  if (line.json && !line.printed) line.print({{"interrupted", true}}, "");
  return fail(cli::kInterrupted, "abstand: interrupted");
}

template <class Work>
int caught(const Work& work) {
  try {
    return work();
  } catch (const Interrupted&) {
    return fail(cli::kInterrupted, "abstand: interrupted");
  } catch (const ParseError& e) {
    return fail(cli::kBadInput, e.what());
  } catch (const UsageError& e) {
    return fail(cli::kWrongUsage, std::string("abstand: error: ") + e.what());
  } catch (const WriteError& e) {
    return fail(cli::kInternal, std::string("abstand: error: ") + e.what());
  } catch (const std::exception& e) {
    return fail(cli::kInternal, std::string("abstand: internal error: ") + e.what());
  }
}

int runCommand(const CLI::App& app, const cli::CommandLine& line) {
  return caught([&] {
    try {
      cli::checkOutputs(app, line);
      const int code = line.run();
      return code == cli::kInterrupted && !line.printed ? endInterrupted(line) : code;
    } catch (const structure::BuildCancelled&) {
      return endInterrupted(line);
    } catch (const Interrupted&) {
      return endInterrupted(line);
    }
  });
}

/// Handles --help and --version.
int printHelp(const CLI::App& app, const CLI::Success& e) {
  return caught([&] {
    std::ostringstream out, err;
    const int code = app.exit(e, out, err);
    writeStandardOutput(out.str());
    return code;
  });
}

}  // namespace

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  reserveStandardDescriptors();
  catchInterrupts();
  keepInputLog();
  cli::CommandLine line;
  CLI::App app(
      "Analyses how close people come to robots, how severe contacts would be, and which safety margins "
      "suffice.\n"
      "An analysis tool, not a safety function.",
      "abstand");
  app.set_version_flag("--version", std::string("abstand ") + cli::kVersion);
  app.require_subcommand(1);
  cli::addFk(app, line);
  cli::addDynamics(app, line);
  cli::addConvert(app, line);
  cli::addBuild(app, line);
  cli::addHuman(app, line);
  cli::addSkeleton(app, line);
  cli::addPairs(app, line);
  cli::addRenderDepth(app, line);
  cli::addCoverage(app, line);
  cli::addTrack(app, line);
  cli::addCalibrate(app, line);
  cli::addRun(app, line);
  cli::addServe(app, line);
  cli::addCheck(app, line);
  cli::addTune(app, line);
  cli::addMerge(app, line);
  cli::addDiff(app, line);
  cli::addExport(app, line);
  cli::addEvents(app, line);
  cli::addResults(app, line);
  cli::addExposure(app, line);
  cli::addReport(app, line);
  cli::addBench(app, line);
  cli::addVerify(app, line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {
    return printHelp(app, e);
  } catch (const CLI::ParseError& e) {
    // The contract has one exit code for all wrong usage.
    return fail(cli::kWrongUsage, std::string("abstand: error: ") + e.what() + "\nhint: abstand --help");
  }
  return runCommand(app, line);
}
