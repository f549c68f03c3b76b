// Options and output about the warm start, for all commands that process frames.
#include "app/cli/warm_start.hpp"

#include "core/base/error.hpp"

namespace abstand::cli {

void WarmStartArguments::apply(session::SessionOptions& session) const {
  if (cold && warm) throw UsageError("--cold and --remember contradict each other: expected one of them");
  if (cold) session.remember = false;
  if (warm) session.remember = true;
  if (!tolerance.empty())
    session.far_tolerance = numberWithin(tolerance, "--tolerance", 0.0, query::kMaxFarTolerance, "");
}

void addWarmStart(CLI::App& command, WarmStartArguments& args) {
  command.add_flag("--cold", args.cold, "cold start: every frame is queried from its poses alone (slower)");
  command.add_flag("--remember", args.warm,
                   "warm start: pairs start from their last result, overriding the scene (default)");
  command.add_option("--tolerance", args.tolerance,
                     "relative tolerance (0 to 0.1) of distances beyond 0.1 m when pairs "
                     "start warm (default: the scene's, else 0.002)");
}

nlohmann::ordered_json warmStartJson(const std::optional<run::RunSummary::WarmStart>& warm_start) {
  if (!warm_start) return nullptr;
  nlohmann::ordered_json j{{"block_frames", nullptr}, {"far_from_m", query::kRelativeFrom}};
  if (warm_start->block > 0) j["block_frames"] = warm_start->block;
  j["far_tolerance"] = warm_start->far_tolerance;
  return j;
}

std::string warmStartText(const std::optional<run::RunSummary::WarmStart>& warm_start) {
  if (!warm_start) return {};
  return format(
      "warm start: distances beyond %.1f m are at most %.3g %% above the minimum%s\n", query::kRelativeFrom,
      100.0 * warm_start->far_tolerance,
      warm_start->block > 0 ? format("; every %zu frames start cold", warm_start->block).c_str() : "");
}

}  // namespace abstand::cli
