// abstand: distances and contact between people and robots, without a window.
#include <cstdio>
#include <iostream>

#include "app/cli/command_line.hpp"
#include "app/cli/version.hpp"
#include "core/base/error.hpp"

namespace {

using namespace abstand;

int fail(int code, const std::string& text) {
  std::cerr << text << std::endl;
  return code;
}

int runCommand(const cli::CommandLine& line) {
  try {
    return line.run();
  } catch (const BuildCancelled&) {
    return fail(cli::kInterrupted, "abstand: interrupted");
  } catch (const ParseError& e) {
    return fail(cli::kBadInput, e.what());
  } catch (const UsageError& e) {
    return fail(cli::kWrongUsage, std::string("abstand: error: ") + e.what());
  } catch (const std::exception& e) {
    return fail(cli::kInternal, std::string("abstand: internal error: ") + e.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  cli::catchInterrupts();
  cli::CommandLine line;
  CLI::App app(
      "How close people come to robots, how hard a touch would be, and which safety margin is right.\n"
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
  cli::addTrack(app, line);
  cli::addCalibrate(app, line);
  cli::addRun(app, line);
  cli::addServe(app, line);
  cli::addCheck(app, line);
  cli::addBench(app, line);
  cli::addVerify(app, line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    // The contract knows one code for all wrong usage.
    return fail(cli::kWrongUsage, std::string("abstand: error: ") + e.what() + "\nhint: abstand --help");
  }
  return runCommand(line);
}
