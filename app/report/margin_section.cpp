#include "app/report/margin_section.hpp"

#include <algorithm>
#include <cmath>

#include "app/report/page.hpp"
#include "core/text/message_text.hpp"

namespace abstand::report {
namespace {

std::string millimetresText(double metres, int digits = 0) {
  if (std::isinf(metres)) return metres > 0.0 ? "none" : "not seen";
  return text::rounded(1e3 * metres, digits) + " mm";
}

std::string secondsText(double t) { return text::rounded(t, 3) + " s"; }

std::string linkTable(const tune::TuneAnswer& answer) {
  std::vector<std::vector<std::string>> rows;
  for (const tune::GroupNeed& need : answer.links) {
    std::vector<std::string> row{
        need.link, std::isinf(need.margin) ? "no margin suffices" : millimetresText(need.margin)};
    row.push_back(need.recording
                      ? answer.recordings[*need.recording].recording + " at " + secondsText(need.need.t)
                      : "no stop needed");
    rows.push_back(std::move(row));
  }
  return htmlTable({"link", "smallest safe margin", "determined by"}, rows);
}

}  // namespace

std::string closestSection(const tune::TuneAnswer& answer) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> header{"part",     "distance",    "engine (mm)", "tracker (mm)",
                                  "age (mm)", "calib. (mm)", "frames (mm)", "certified clearance",
                                  "verdict",  "link",        "at (s)"};
  const bool several = answer.recordings.size() > 1;
  if (several) header.push_back("recording");
  for (const tune::ClosestApproach& c : answer.closest) {
    if (c.link.empty()) {
      rows.push_back(
          {c.part, "never tracked", "", "", "", "", "", "", tune::verdictText(c.verdict()), "", ""});
      if (several) rows.back().push_back("");
      continue;
    }
    rows.push_back({c.part, text::rounded(1e3 * c.distance, 1) + " \u00b1 " + millimetresText(c.error(), 1),
                    text::rounded(1e3 * c.bound, 1), text::rounded(1e3 * c.poseTracker(), 1),
                    text::rounded(1e3 * c.pose_age, 1), text::rounded(1e3 * c.calibration, 1),
                    text::rounded(1e3 * c.between_frames, 1), millimetresText(c.clearance(), 1),
                    tune::verdictText(c.verdict()), c.link, text::rounded(c.t, 3)});
    if (several) rows.back().push_back(answer.recordings[c.recording].recording);
  }
  return "<h2>Closest approaches</h2>\n<p>For each body part, the time of the minimum certified clearance: "
         "the "
         "measured distance and its uncertainty, which is the sum of its shares: "
         "the "
         "engine's bound, the uncertainty of the person's pose (as stated by the tracker, plus the share "
         "that the age "
         "of the "
         "pose adds while a part is not tracked), the calibration between "
         "recording "
         "and robot (an assumption, below), and the motion between two frames.</p>\n" +
         htmlTable(header, rows);
}

std::string marginSetSection(const tune::TuneAnswer& answer) {
  std::vector<std::vector<std::string>> rows;
  for (const tune::StrategyOutcome& s : answer.strategies) {
    const margin::MarginOutcome& o = s.outcome;
    rows.push_back({s.rules.name, std::to_string(o.stops), text::rounded(100.0 * o.stoppedShare(), 1) + " %",
                    std::to_string(o.false_stops), std::to_string(o.missed_stops),
                    millimetresText(o.min_clearance)});
  }
  return "<h2>Margin sets</h2>\n<p>The smallest safe margins as one margin for all, by part, by link "
         "and by "
         "pair, evaluated over all pairs together. A finer set usually causes fewer false stops; the counts "
         "are its outcome on these recordings.</p>\n" +
         htmlTable({"set of margins", "stops", "time stopped", "false", "missed",
                    "smallest clearance to a moving robot"},
                   rows) +
         "<p>The smallest safe margin of each link, for the nearest part of any person:</p>\n" +
         linkTable(answer);
}

std::string bandSection(const tune::TuneAnswer& answer) {
  if (answer.bands.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const tune::VariantBand& b : answer.bands)
    rows.push_back({b.part, millimetresText(b.margin.least) + " to " + millimetresText(b.margin.largest),
                    answer.recordings[b.margin.of_largest].recording,
                    millimetresText(b.clearance.least) + " to " + millimetresText(b.clearance.largest),
                    answer.recordings[b.clearance.of_least].recording});
  return "<h2>Variants of one recording</h2>\n<p>Runs of one recording with other "
         "people, positions "
         "or speeds: the smallest and the largest value of each part.</p>\n" +
         htmlTable({"part", "smallest safe margin", "largest for", "smallest clearance", "minimum for"},
                   rows);
}

}  // namespace abstand::report
