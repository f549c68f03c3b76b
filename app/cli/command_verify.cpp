// abstand verify: verifies the engine on this machine.
#include "app/cli/command_line.hpp"
#include "app/cli/json_values.hpp"
#include "app/cli/version.hpp"
#include "app/report/report.hpp"
#include "core/base/error.hpp"
#include "core/verify/suite.hpp"

namespace abstand::cli {
namespace {

struct VerifyArguments {
  std::string report, only;
  std::size_t poses{0};  ///< 0: the default of the mode
  std::uint64_t seed{1};
  bool quick{false};
  int threads{0};
};

nlohmann::ordered_json toJson(const verify::CheckResult& r) {
  return {{"name", r.name},
          {"what", r.what},
          {"quantity", r.quantity},
          {"poses", r.poses},
          {"worst", numberOrNull(r.worst)},
          {"p50", numberOrNull(r.p50)},
          {"p99", numberOrNull(r.p99)},
          {"limit", numberOrNull(r.limit)},
          {"breaches", r.breaches},
          {"passed", r.passed}};
}

int runVerify(const CommandLine& line, const VerifyArguments& args) {
  verify::VerifyOptions options;
  options.quick = args.quick;
  options.poses = args.poses ? args.poses : (args.quick ? verify::kQuickPoses : options.poses);
  options.seed = args.seed;
  options.threads = args.threads;
  options.interrupted = interrupted;

  std::vector<verify::CheckResult> results;
  for (const verify::CheckFamily& family : verify::checkFamilies()) {
    if (!args.only.empty() && family.name != args.only) continue;
    options.progress = progressBar(line, std::string(family.name));
    if (options.progress) options.progress(0, 1);
    for (auto& result : family.run(options)) results.push_back(std::move(result));
    if (options.progress) options.progress(1, 1);
    if (interrupted()) break;
  }
  const bool cut_short = interrupted();
  const bool passed = !cut_short && std::ranges::all_of(results, &verify::CheckResult::passed);

  nlohmann::ordered_json document{{"passed", passed},
                                  {"poses", options.poses},
                                  {"seed", options.seed},
                                  {"quick", options.quick},
                                  {"checks", nlohmann::ordered_json::array()},
                                  {"interrupted", cut_short}};
  std::string text;
  for (const auto& r : results) {
    document["checks"].push_back(toJson(r));
    text += format("%-26s %s  %7zu poses, breaches %zu, worst %.3g (limit %.3g)\n", r.name.c_str(),
                   r.passed ? "passed" : "FAILED", r.poses, r.breaches, r.worst, r.limit);
  }
  text += cut_short ? "interrupted: the checks are incomplete\n" : passed ? "passed\n" : "not passed\n";
  if (!args.report.empty() && !cut_short) report::writeReport(results, options, kVersion, args.report);
  line.print(document, text);
  if (cut_short) return kInterrupted;
  return passed ? kDone : kLimitBroken;
}

}  // namespace

void addVerify(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "verify",
                 "verifies the engine on this machine: distances against brute force, forces against "
                 "closed forms",
                 "abstand verify --report verification.html");
  auto args = std::make_shared<VerifyArguments>();
  line.output(command->add_option("--report", args->report, "HTML page with tables and plots"));
  command
      ->add_option("--poses", args->poses,
                   "random and adversarial poses against brute force (100000; quick: 3000)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000}));
  command->add_option("--seed", args->seed, "random seed of the poses");
  command->add_flag("--quick", args->quick, "fewer poses, same limits");
  std::vector<std::string> names;
  for (const verify::CheckFamily& family : verify::checkFamilies()) names.emplace_back(family.name);
  command->add_option("--only", args->only, "one family of checks")->check(CLI::IsMember(names));
  command->add_option("--threads", args->threads, "0: all cores")->check(CLI::Range(0, 256));
  command->callback([&line, args] { line.run = [&line, args] { return runVerify(line, *args); }; });
}

}  // namespace abstand::cli
