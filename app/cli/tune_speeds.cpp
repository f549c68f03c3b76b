#include "app/cli/tune_speeds.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/base/input_log.hpp"
#include "core/base/output_file.hpp"

namespace abstand::cli {
namespace {

constexpr std::size_t kMaxScales = 100;

std::vector<double> scalesOf(const std::string& text) {
  if (text.empty()) return {};
  const std::vector<double> scales = numberList(text, "--speed-scales");
  for (const double scale : scales)
    if (!(scale >= tune::kSlowestScale && scale <= 1.0))
      throw UsageError("--speed-scales: found '" + text + "', expected shares from 0.01 to 1");
  if (scales.size() > kMaxScales)
    throw UsageError("--speed-scales: found more than 100 shares, expected fewer");
  return scales;
}

std::string fileOf(const tune::ProgramMotion& motion) { return motion.mechanism + ".csv"; }

/// Throws UsageError for a name that is not a valid file name.
void checkFile(const std::string& folder, const tune::ProgramMotion& motion) {
  if (motion.mechanism.find('/') != std::string::npos)
    throw UsageError("--speed-profile: found the mechanism `" + motion.mechanism +
                     "`, expected a valid file name");
  if (isInput(std::filesystem::path(folder) / fileOf(motion)))
    throw UsageError("--speed-profile: found " + (std::filesystem::path(folder) / fileOf(motion)).string() +
                     ", which is also an input, expected a different folder");
}

}  // namespace

void addSpeedRule(CLI::App& command, std::string& rule) {
  command
      .add_option("--speed-rule", rule,
                  "limits that permitted speeds respect: separation, contact or both (default: both)")
      ->check(CLI::IsMember({"both", "separation", "contact"}));
}

tune::SpeedRule speedRule(const std::string& name) {
  if (name == "separation") return tune::SpeedRule::kSeparation;
  return name == "contact" ? tune::SpeedRule::kContact : tune::SpeedRule::kBoth;
}

void addSpeedStudy(CLI::App& command, CommandLine& line, SpeedArguments& args) {
  line.output(
      command.add_option("--speed-profile", args.profile,
                         "folder for the robots' motions at permitted speeds, verified by replay with "
                         "the recordings; written only if no limit is violated"),
      OutputKind::kFolder);
  command
      .add_option("--max-iterations", args.max_iterations,
                  "maximum number of replays for --speed-profile, each slower where the last one violated a "
                  "limit (default: 10)")
      ->check(CLI::Range(1, 1000));
  command.add_option(
      "--speed-scales", args.scales,
      "0.5,0.75,1...: reports margin, cycle time and stops of the program at each speed scale");
}

SpeedStudy::SpeedStudy(const SpeedArguments& args, std::vector<tune::PlanItem> items, const Load& load)
    : args_(args), items_(std::move(items)), scales_(scalesOf(args.scales)) {
  for (const tune::PlanItem& item : items_)
    if (item.scene != items_.front().scene || item.motions != items_.front().motions)
      throw UsageError(
          "--speed-profile, --speed-scales: found a plan with several scenes or programs, expected one");
  motions_ = tune::programMotions(load(items_.front()));
  if (args_.profile.empty()) return;
  for (const tune::ProgramMotion& m : motions_) checkFile(args_.profile, m);
  out_ = std::make_unique<OutputFolder>(args_.profile);
}

bool SpeedStudy::run(tune::TuneAnswer& answer, const std::filesystem::path& folder,
                     const tune::RunItems& run_items) {
  tune::ProgramReplay replay(items_, answer.recordings, motions_, folder, run_items);
  if (out_) {
    answer.proof = tune::proveSpeeds(
        answer.speeds, answer.recordings, replay,
        {answer.speed_rule, answer.options.pass.braking.deceleration, args_.max_iterations});
    const bool proven = answer.proof->proven;
    for (const tune::ProgramMotion& m : motions_) {
      if (proven)
        writeFile(out_->place(fileOf(m)),
                  mechanism::formatMotion(tune::retimed(m.motion, *answer.proof->pace)));
      answer.profile.push_back(
          {m.mechanism, proven ? std::filesystem::path(args_.profile) / fileOf(m) : std::filesystem::path()});
    }
    if (proven) out_->commit();
    out_.reset();
    answer.interrupted = answer.interrupted || answer.proof->interrupted;
  }
  if (!answer.interrupted) answer.trade = tune::tradeCurve(scales_, replay, answer.options);
  for (const tune::TradePoint& p : answer.trade) answer.interrupted = answer.interrupted || p.interrupted;
  return !answer.proof || answer.proof->proven;
}

}  // namespace abstand::cli
