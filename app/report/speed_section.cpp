#include "app/report/speed_section.hpp"

#include <algorithm>
#include <cmath>

#include "app/report/page.hpp"
#include "app/report/svg_plot.hpp"
#include "core/text/escaped_xml.hpp"
#include "core/text/message_text.hpp"

namespace abstand::report {
namespace {

constexpr std::size_t kSlowestRows = 20;

std::string shareText(double share, int digits = 0) { return text::rounded(100.0 * share, digits) + " %"; }
std::string atSeconds(double t) { return " at " + text::rounded(t, 3) + " s"; }
std::string timeText(double seconds) {
  return std::isinf(seconds) ? "the robot would have to stand" : text::rounded(seconds, 1) + " s";
}

/// Horizontal lines over the segments, with steps between them.
verify::Series steps(const std::vector<tune::SpeedSegment>& segments, const std::string& name,
                     double tune::SpeedSegment::*value) {
  verify::Series series{name, {}, {}};
  for (const tune::SpeedSegment& s : segments)
    for (const double t : {s.t0, s.t1}) {
      series.x.push_back(t);
      series.y.push_back(s.*value);
    }
  return series;
}

const char* ruleText(tune::SpeedRule rule) {
  switch (rule) {
    case tune::SpeedRule::kSeparation:
      return "the protective distance (separation)";
    case tune::SpeedRule::kContact:
      return "the limits of transient contact";
    case tune::SpeedRule::kBoth:
      break;
  }
  return "the protective distance (separation) and the limits of transient contact";
}

/// Segments that are slowed down, slowest first.
std::string slowestTable(const tune::TuneAnswer& answer) {
  std::vector<const tune::SpeedSegment*> slowed;
  for (const tune::SpeedSegment& s : answer.speeds)
    if (s.speed_scale < 1.0 && s.limited_by) slowed.push_back(&s);
  std::stable_sort(slowed.begin(), slowed.end(),
                   [](const auto* a, const auto* b) { return a->speed_scale < b->speed_scale; });
  if (slowed.empty()) return "<p>No segment has to be slowed down.</p>\n";
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < std::min(slowed.size(), kSlowestRows); ++i) {
    const tune::SpeedSegment& s = *slowed[i];
    rows.push_back({text::rounded(s.t0, 2) + " to " + text::rounded(s.t1, 2) + " s", shareText(s.speed_scale),
                    shareText(s.by_separation), shareText(s.by_contact),
                    s.limited_by->kind == tune::SpeedLimit::kSeparation ? "separation" : "contact",
                    s.limited_by->part,
                    answer.recordings[s.limited_by->recording].recording + atSeconds(s.limited_by->t)});
  }
  return "<p>" + std::to_string(slowed.size()) + " of " + std::to_string(answer.speeds.size()) +
         " segments have to be slowed down" +
         (slowed.size() > kSlowestRows ? "; the slowest " + std::to_string(kSlowestRows) + ":" : ":") +
         "</p>\n" +
         htmlTable({"segment", "permitted speed", "by separation", "by contact", "limited by", "part",
                    "decided by"},
                   rows);
}

std::string proofText(const tune::SpeedProof& proof) {
  if (proof.proven)
    return "<p>Speed profile: <strong>proven</strong> in replay " + std::to_string(proof.iterations) +
           ". With the slowed program and the same recordings, no limit was violated; it takes " +
           timeText(proof.pace->cycleTime()) + ".</p>\n";
  const std::string failed = "<p class=\"failed\">Speed profile: ";
  if (const auto& s = proof.stands)
    return failed + "none was found. Between " + text::rounded(s->t0, 3) + " and " + text::rounded(s->t1, 3) +
           " s of the program the robot would have to stand still (" +
           text::escapedXml(s->part + ", " + s->recording) + atSeconds(s->t) + ").</p>\n";
  return failed + "not proven after " + std::to_string(proof.iterations) +
         " replays. The protective distance was violated for " +
         text::rounded(proof.broken_time_separation, 2) + " s, contact limits " +
         std::to_string(proof.broken_contacts) + " times.</p>\n";
}

}  // namespace

std::string speedSection(const tune::TuneAnswer& answer) {
  if (answer.speeds.empty()) return {};
  verify::Plot plot{
      "Permitted speed", "time of the program [s]", "share of the recorded speed", false, false, {}};
  plot.series.push_back(steps(answer.speeds, "permitted", &tune::SpeedSegment::speed_scale));
  plot.series.push_back(steps(answer.speeds, "by separation", &tune::SpeedSegment::by_separation));
  plot.series.push_back(steps(answer.speeds, "by contact", &tune::SpeedSegment::by_contact));
  const double recorded = answer.speeds.back().t1 - answer.speeds.front().t0;
  return std::string(
             "<h2>Permitted speeds</h2>\n<p>For each segment of the program the highest share of the "
             "recorded speed at which ") +
         ruleText(answer.speed_rule) +
         " would have been kept by the recorded people (ISO/TS 15066:2016). Slower robots meet people at "
         "other "
         "places of the program: only a replay (<code>--speed-profile</code>) proves a profile.</p>\n" +
         svgPlot(plot) + "<p>Cycle time: " + timeText(recorded) + " as recorded, " +
         timeText(tune::cycleTime(answer.speeds)) + " at the permitted speeds.</p>\n" + slowestTable(answer) +
         (answer.proof ? proofText(*answer.proof) : std::string());
}

std::string tradeSection(const tune::TuneAnswer& answer) {
  if (answer.trade.empty()) return {};
  verify::Plot margins{"Margin", "cycle time [s]", "margin [m]", false, false, {{"needed", {}, {}}}};
  verify::Plot stopped{
      "Time stopped", "cycle time [s]", "share of the time", false, false, {{"with that margin", {}, {}}}};
  std::vector<std::vector<std::string>> rows;
  for (const tune::TradePoint& p : answer.trade) {
    const bool suffices = std::isfinite(p.margin);
    if (suffices) {
      margins.series[0].x.push_back(p.cycle_time);
      margins.series[0].y.push_back(p.margin);
      stopped.series[0].x.push_back(p.cycle_time);
      stopped.series[0].y.push_back(p.stopped_share);
    }
    rows.push_back({shareText(p.speed_scale), timeText(p.cycle_time),
                    suffices ? text::rounded(1e3 * p.margin, 0) + " mm" : "no margin suffices",
                    suffices ? shareText(p.stopped_share, 1) : "",
                    p.failed > 0 ? std::to_string(p.failed) : ""});
  }
  return "<h2>Margin, speed and time</h2>\n<p>The whole program replayed at constant speed scales with the "
         "same "
         "recordings: the largest margin needed by any part, and the percentage of time for which the "
         "robot "
         "is stopped with it. A faster cycle needs a larger margin and stops more often.</p>\n" +
         svgPlot(margins) + svgPlot(stopped) +
         htmlTable({"speed", "cycle time", "margin", "time stopped", "failed replays"}, rows);
}

}  // namespace abstand::report
