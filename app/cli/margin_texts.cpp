#include "app/cli/margin_texts.hpp"

#include <algorithm>
#include <cmath>

#include "app/cli/command_line.hpp"
#include "app/cli/json_values.hpp"

namespace abstand::cli {
namespace {

/// Pairs in the text; the JSON has all.
constexpr std::size_t kTextPairs = 10;

}  // namespace

nlohmann::ordered_json outcomeJson(const margin::MarginOutcome& o) {
  return {{"stops", o.stops},
          {"stopped_share", o.stoppedShare()},
          {"false_stops", o.false_stops},
          {"missed_stops", o.missed_stops},
          {"unseen", o.unseen},
          {"min_distance", o.min_clearance},
          {"lead_time", orNull(o.lead_time)}};
}

nlohmann::ordered_json strategiesJson(const tune::TuneAnswer& answer) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const tune::StrategyOutcome& s : answer.strategies) {
    nlohmann::ordered_json row{{"name", s.rules.name}};
    row.update(outcomeJson(s.outcome));
    rows.push_back(std::move(row));
  }
  return rows;
}

nlohmann::ordered_json groupNeedsJson(const tune::TuneAnswer& answer,
                                      const std::vector<tune::GroupNeed>& needs) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const tune::GroupNeed& need : needs) {
    nlohmann::ordered_json row;
    if (!need.part.empty()) row["part"] = need.part;
    row["link"] = need.link;
    row["margin"] = need.margin;
    row["decided_by"] = row["uncertainty"] = nullptr;
    if (need.recording) {
      row["decided_by"] = {{"recording", answer.recordings[*need.recording].recording}, {"t", need.need.t}};
      row["uncertainty"] = {
          {"bound", need.need.bound}, {"pose", need.need.pose}, {"sampling", need.need.sampling}};
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

nlohmann::ordered_json toolJson(const std::string& tool) {
  return tool.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(tool);
}

nlohmann::ordered_json closestJson(const tune::TuneAnswer& answer) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const tune::ClosestApproach& c : answer.closest) {
    nlohmann::ordered_json row{
        {"part", c.part}, {"verdict", tune::verdictName(c.verdict())}, {"not_seen", c.not_seen}};
    const bool seen = !c.link.empty();
    row["recording"] = seen ? nlohmann::ordered_json(answer.recordings[c.recording].recording) : nullptr;
    row["t"] = seen ? nlohmann::ordered_json(c.t) : nullptr;
    row["link"] = seen ? nlohmann::ordered_json(c.link) : nullptr;
    row["tool"] = toolJson(c.tool);
    row["distance"] = seen ? nlohmann::ordered_json(c.distance) : nullptr;
    row["error"] = seen ? nlohmann::ordered_json(c.error()) : nullptr;
    row["clearance"] = seen ? nlohmann::ordered_json(c.clearance()) : nullptr;
    row["shares"] = {{"bound", c.bound},
                     {"pose", c.pose},
                     {"latency", c.latency},
                     {"calibration", c.calibration},
                     {"between_frames", c.between_frames}};
    row["pose_shares"] = {{"tracker", c.poseTracker()}, {"age", c.pose_age}};
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string closestText(const tune::TuneAnswer& answer) {
  std::string text =
      "\nclosest approaches: measured distance and its uncertainty (engine + pose + "
      "latency + calibration + between frames; age: share of the pose age in the pose term):\n";
  for (const tune::ClosestApproach& c : answer.closest) {
    if (c.link.empty()) {
      text += format("%-14s never tracked\n", c.part.c_str());
      continue;
    }
    text += format("%-14s %8.1f ± %.1f mm (%.1f + %.1f + %.1f + %.1f + %.1f; age %.1f)  %s, %s at %.3f s\n",
                   tune::partText(c.part, c.tool).c_str(), 1e3 * c.distance, 1e3 * c.error(), 1e3 * c.bound,
                   1e3 * c.pose, 1e3 * c.latency, 1e3 * c.calibration, 1e3 * c.between_frames,
                   1e3 * c.pose_age, tune::verdictText(c.verdict()), c.link.c_str(), c.t);
  }
  return text;
}

nlohmann::ordered_json bandsJson(const tune::TuneAnswer& answer) {
  const auto band = [&](const tune::Band& b) {
    return nlohmann::ordered_json{{"min", b.least},
                                  {"max", b.largest},
                                  {"min_of", answer.recordings[b.of_smallest].recording},
                                  {"max_of", answer.recordings[b.of_largest].recording}};
  };
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const tune::VariantBand& b : answer.bands)
    rows.push_back({{"recording", answer.recordings[b.runs.front()].recording},
                    {"runs", b.runs.size()},
                    {"part", b.part},
                    {"margin", band(b.margin)},
                    {"clearance", band(b.clearance)}});
  return rows;
}

std::string bandsText(const tune::TuneAnswer& answer) {
  if (answer.bands.empty()) return {};
  const auto mm = [](double v) { return std::isinf(v) ? std::string("none") : format("%.0f", 1e3 * v); };
  std::string text = "\nvariants of one recording: margin min, max, and smallest clearance min, max (mm)\n";
  for (const tune::VariantBand& b : answer.bands)
    text += format("%-14s %6s %6s  %6s %6s  largest margin: %s\n", b.part.c_str(), mm(b.margin.least).c_str(),
                   mm(b.margin.largest).c_str(), mm(b.clearance.least).c_str(),
                   mm(b.clearance.largest).c_str(), answer.recordings[b.margin.of_largest].recording.c_str());
  return text;
}

std::string strategiesText(const tune::TuneAnswer& answer) {
  std::string text = format("\n%-24s %6s %8s %7s %7s %12s\n", "sets of margins", "stops", "stopped", "false",
                            "missed", "min distance");
  for (const tune::StrategyOutcome& s : answer.strategies) {
    const margin::MarginOutcome& o = s.outcome;
    text += format("%-24s %6ld %6.1f %% %7ld %7ld %9.1f mm\n", s.rules.name.c_str(), o.stops,
                   100.0 * o.stoppedShare(), o.false_stops, o.missed_stops, 1e3 * o.min_clearance);
  }
  return answer.strategies.empty() ? std::string() : text;
}

std::string groupNeedsText(const tune::TuneAnswer& answer) {
  std::string text = "\nsmallest margins per link:\n";
  for (const tune::GroupNeed& need : answer.links)
    text += format(
        "%-24s %s\n", need.link.c_str(),
        std::isinf(need.margin) ? "no margin suffices" : format("%4.0f mm", 1e3 * need.margin).c_str());
  std::vector<tune::GroupNeed> pairs;
  for (const tune::GroupNeed& need : answer.pairs)
    if (need.margin > 0.0) pairs.push_back(need);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const auto& a, const auto& b) { return a.margin > b.margin; });
  text += format("\npairs that need a margin: %zu of %zu\n", pairs.size(), answer.pairs.size());
  for (std::size_t i = 0; i < std::min(pairs.size(), kTextPairs); ++i)
    text += format("%-14s %-24s %s\n", pairs[i].part.c_str(), pairs[i].link.c_str(),
                   std::isinf(pairs[i].margin) ? "no margin suffices"
                                               : format("%4.0f mm", 1e3 * pairs[i].margin).c_str());
  return text;
}

}  // namespace abstand::cli
