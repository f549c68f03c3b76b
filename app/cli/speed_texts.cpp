#include "app/cli/speed_texts.hpp"

#include <algorithm>
#include <cmath>

#include "app/cli/command_line.hpp"
#include "app/cli/json_values.hpp"

namespace abstand::cli {
namespace {

using SpeedJson = nlohmann::ordered_json;

const char* limitName(tune::SpeedLimit kind) {
  return kind == tune::SpeedLimit::kContact ? "contact" : "separation";
}

SpeedJson speedsJson(const tune::TuneAnswer& answer) {
  SpeedJson rows = SpeedJson::array();
  for (std::size_t i = 0; i < answer.speeds.size(); ++i) {
    const tune::SpeedSegment& s = answer.speeds[i];
    SpeedJson j{{"motion", "all robots"},
                {"segment", i},
                {"t0", s.t0},
                {"t1", s.t1},
                {"speed_scale", s.speed_scale},
                {"limited_by", nullptr},
                {"by_separation", s.by_separation},
                {"by_contact", s.by_contact}};
    if (s.limited_by)
      j["limited_by"] = {{"recording", answer.recordings[s.limited_by->recording].recording},
                         {"t", s.limited_by->t},
                         {"part", s.limited_by->part},
                         {"kind", limitName(s.limited_by->kind)}};
    rows.push_back(std::move(j));
  }
  return rows;
}

SpeedJson standsJson(const std::optional<tune::SpeedProof::Stands>& stands) {
  if (!stands) return nullptr;
  return {{"t0", stands->t0}, {"t1", stands->t1},     {"recording", stands->recording},
          {"t", stands->t},   {"part", stands->part}, {"kind", limitName(stands->kind)}};
}

SpeedJson proofJson(const tune::TuneAnswer& answer) {
  const tune::SpeedProof& proof = *answer.proof;
  SpeedJson rows = SpeedJson::array();
  for (const auto& motion : answer.profile) {
    SpeedJson j{
        {"motion", motion.mechanism},
        {"proven", proof.proven},
        {"broken_time_separation",
         proof.iterations > 0 ? SpeedJson(proof.broken_time_separation) : SpeedJson(nullptr)},
        {"broken_contacts", proof.iterations > 0 ? SpeedJson(proof.broken_contacts) : SpeedJson(nullptr)},
        {"cycle_time", proof.pace ? SpeedJson(proof.pace->cycleTime()) : SpeedJson(nullptr)},
        {"iterations", proof.iterations},
        {"stands", standsJson(proof.stands)},
        {"failed", proof.failed.size()},
        {"file", motion.file.empty() ? SpeedJson(nullptr) : SpeedJson(motion.file.string())}};
    rows.push_back(std::move(j));
  }
  return rows;
}

SpeedJson profileJson(const tune::SpeedProof& proof) {
  SpeedJson rows = SpeedJson::array();
  for (const tune::PermittedPace& s : proof.scales)
    rows.push_back({{"t0", s.t0}, {"t1", s.t1}, {"speed_scale", s.scale}});
  return rows;
}

SpeedJson tradeJson(const std::vector<tune::TradePoint>& trade) {
  SpeedJson rows = SpeedJson::array();
  for (const tune::TradePoint& p : trade)
    rows.push_back({{"speed_scale", p.speed_scale},
                    {"cycle_time", p.cycle_time},
                    {"margin", numberOrNull(p.margin)},
                    {"stopped_share", numberOrNull(p.stopped_share)},
                    {"not_judged", p.unjudged},
                    {"failed", p.failed}});
  return rows;
}

std::string tradeText(const std::vector<tune::TradePoint>& trade) {
  if (trade.empty()) return "";
  std::string text =
      format("\n%-14s %8s %12s %10s %9s\n", "whole program", "speed", "cycle time", "margin", "stopped");
  for (const tune::TradePoint& p : trade) {
    text += format("%-14s %6.0f %% %10.1f s ", "", 100.0 * p.speed_scale, p.cycle_time);
    text += std::isfinite(p.margin) ? format("%7.0f mm %7.1f %%\n", 1e3 * p.margin, 100.0 * p.stopped_share)
                                    : std::string("no margin suffices\n");
  }
  return text;
}

std::string tableText(const tune::TuneAnswer& answer) {
  double scale = 1.0;
  std::size_t slowed = 0;
  for (const tune::SpeedSegment& s : answer.speeds) {
    scale = std::min(scale, s.speed_scale);
    slowed += s.speed_scale < 1.0;
  }
  const char* rule = answer.speed_rule == tune::SpeedRule::kBoth         ? "separation and contact limits"
                     : answer.speed_rule == tune::SpeedRule::kSeparation ? "separation"
                                                                         : "contact limits";
  if (slowed == 0) return format("\npermitted speeds: %s were kept throughout\n", rule);
  const double permitted = tune::cycleTime(answer.speeds);
  return format(
             "\npermitted speeds (ISO/TS 15066:2016): %s kept with %zu of %zu segments slowed down, to %.0f "
             "%% at least; ",
             rule, slowed, answer.speeds.size(), 100.0 * scale) +
         (std::isinf(permitted) ? "in some segment the robot would have to stand still\n"
                                : format("the program would take %.1f s instead of %.1f s\n", permitted,
                                         answer.speeds.back().t1 - answer.speeds.front().t0));
}

}  // namespace

std::string_view ruleName(tune::SpeedRule rule) {
  switch (rule) {
    case tune::SpeedRule::kSeparation:
      return "separation";
    case tune::SpeedRule::kContact:
      return "contact";
    case tune::SpeedRule::kBoth:
      break;
  }
  return "both";
}

void addSpeeds(const tune::TuneAnswer& answer, nlohmann::ordered_json& document) {
  document["speed_rule"] = ruleName(answer.speed_rule);
  document["speeds"] = speedsJson(answer);
  if (!answer.speeds.empty())
    document["cycle_time"] = {{"as_recorded", answer.speeds.back().t1 - answer.speeds.front().t0},
                              {"permitted", tune::cycleTime(answer.speeds)}};
  if (answer.proof) {
    document["proof"] = proofJson(answer);
    document["profile"] = profileJson(*answer.proof);
  }
  if (!answer.trade.empty()) document["trade"] = tradeJson(answer.trade);
}

std::string proofLine(const tune::TuneAnswer& answer) {
  const tune::SpeedProof& proof = *answer.proof;
  const std::string head = "speed profile (" + std::string(ruleName(answer.speed_rule)) + "): ";
  if (proof.proven)
    return head + format("proven in replay %d: no limit was violated, the program takes %.1f s",
                         proof.iterations, proof.pace->cycleTime());
  if (const auto& s = proof.stands)
    return head + format(
                      "found no speed for %.3f to %.3f s of the program: the robot would have to stand "
                      "(%s, %s at %.3f s, %s), expected one above %.0f %%; nothing was written",
                      s->t0, s->t1, s->part.c_str(), s->recording.c_str(), s->t, limitName(s->kind),
                      100.0 * tune::kSlowestScale);
  if (proof.interrupted) return head + "interrupted, not proven; nothing was written";
  if (!proof.failed.empty())
    return head + "not proven, a replay failed (" + proof.failed.front().recording + ": " +
           proof.failed.front().error + "); nothing was written";
  return head + format(
                    "not proven after %d replays: the protective distance was violated for %.2f s, limits "
                    "of contacts %ld times; nothing was written",
                    proof.iterations, proof.broken_time_separation, proof.broken_contacts);
}

std::string speedsText(const tune::TuneAnswer& answer) {
  std::string text = tableText(answer);
  if (answer.proof) text += proofLine(answer) + "\n";
  for (const auto& motion : answer.profile)
    if (!motion.file.empty()) text += "  " + motion.mechanism + ": " + motion.file.string() + "\n";
  return text + tradeText(answer.trade);
}

}  // namespace abstand::cli
