// Options and output about the warm start, for all commands that process frames.
#include "app/cli/warm_start.hpp"

#include "core/base/error.hpp"

namespace abstand::cli {

void WarmStartArguments::apply(session::SessionOptions& session) const {
  if (cold && warm) throw UsageError("--cold and --remember contradict each other: expected one of them");
  if (cold) session.remember = false;
  if (warm) session.remember = true;
  if (!tolerance.empty())
    session.far_tolerance = numberWithin(tolerance, "--tolerance", 0.0, scene::kMaxFarTolerance, "");
}

void addWarmStart(CLI::App& command, WarmStartArguments& args) {
  command.add_flag("--cold", args.cold, "every frame is queried from nothing but its poses: slower");
  command.add_flag("--remember", args.warm,
                   "pairs start from their last answer, whatever the scene says of it (the default)");
  command.add_option("--tolerance", args.tolerance,
                     "share (0 to 0.1) by which a distance beyond 0.1 m may exceed the smallest when pairs "
                     "start from their last answer (default: the scene's, else 0.002)");
}

nlohmann::ordered_json warmStartJson(const run::RunSummary& s) {
  if (!s.warm_start) return nullptr;
  nlohmann::ordered_json j{{"block_frames", nullptr}, {"far_from_m", query::kRelativeFrom}};
  if (s.warm_start->block > 0) j["block_frames"] = s.warm_start->block;
  j["far_tolerance"] = s.warm_start->far_tolerance;
  return j;
}

std::string warmStartText(const run::RunSummary& s) {
  if (!s.warm_start) return {};
  return format(
      "warm start: beyond %.1f m distances are at most %.3g %% above the smallest%s\n", query::kRelativeFrom,
      100.0 * s.warm_start->far_tolerance,
      s.warm_start->block > 0 ? format("; every %zu frames start cold", s.warm_start->block).c_str() : "");
}

}  // namespace abstand::cli
