#include "app/report/margin_section.hpp"

#include <algorithm>
#include <cmath>

#include "app/report/page.hpp"
#include "core/text/message_text.hpp"

namespace abstand::report {
namespace {

// m: below it nothing is stated, but sums are rounded.
constexpr double kStated = 1e-6;

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
  std::vector<std::string> header{
      "part",        "distance",    "engine (mm)",         "tracker (mm)", "age (mm)", "latency (mm)",
      "calib. (mm)", "frames (mm)", "certified clearance", "verdict",      "link",     "at (s)"};
  const bool several = answer.recordings.size() > 1;
  if (several) header.push_back("recording");
  for (const tune::ClosestApproach& c : answer.closest) {
    if (c.link.empty()) {
      rows.push_back(
          {c.part, "never tracked", "", "", "", "", "", "", "", tune::verdictText(c.verdict()), "", ""});
      if (several) rows.back().push_back("");
      continue;
    }
    rows.push_back({tune::partText(c.part, c.tool),
                    text::rounded(1e3 * c.distance, 1) + " \u00b1 " + millimetresText(c.error(), 1),
                    text::rounded(1e3 * c.bound, 1),
                    c.poseTracker() > kStated ? text::rounded(1e3 * c.poseTracker(), 1) : "not stated",
                    text::rounded(1e3 * c.pose_age, 1), text::rounded(1e3 * c.latency, 1),
                    text::rounded(1e3 * c.calibration, 1), text::rounded(1e3 * c.between_frames, 1),
                    millimetresText(c.clearance(), 1), tune::verdictText(c.verdict()), c.link,
                    text::rounded(c.t, 3)});
    if (several) rows.back().push_back(answer.recordings[c.recording].recording);
  }
  return "<h2>Closest approaches</h2>\n<p>For each body part, the time of the minimum certified clearance: "
         "the "
         "measured distance and its uncertainty, which is the sum of its shares: "
         "the "
         "engine's bound, the uncertainty of the person's pose (as stated by the tracker, plus the share "
         "that the age "
         "of the "
         "pose adds where a part was not seen recently), the latency of the pose and the calibration between "
         "recording "
         "and robot (assumptions, below), and the motion between two frames. \"Not stated\": the recording "
         "says nothing of the error of its tracker; it "
         "counts as 0, and the verdict holds only for the bodies where they were recorded.</p>\n" +
         htmlTable(header, rows);
}

std::string worstPhaseSection(const tune::TuneAnswer& answer) {
  if (answer.worst_phases.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const auto& r : answer.worst_phases)
    for (const tune::WorstPhase& w : r.parts)
      rows.push_back({r.recording, w.part, w.touches ? "touch" : millimetresText(w.lower, 1), w.link,
                      secondsText(w.t_person), secondsText(w.t_robot), secondsText(w.phase),
                      w.unseen > 0.0 ? secondsText(w.unseen) : ""});
  return "<h2>The worst phase</h2>\n<p>Recording and program are not synchronised: the minimum certified "
         "clearance "
         "over every time of the one and every time of the other, between frames too. The phase says by how "
         "much "
         "the program would have run ahead. Where a part was not seen nothing was searched.</p>\n" +
         htmlTable(
             {"recording", "part", "clearance", "link", "person at", "program at", "phase", "not seen for"},
             rows);
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
                    answer.recordings[b.clearance.of_smallest].recording});
  return "<h2>Variants of one recording</h2>\n<p>Runs of one recording with other "
         "people, positions "
         "or speeds: the smallest and the largest value of each part.</p>\n" +
         htmlTable({"part", "smallest safe margin", "largest for", "smallest clearance", "minimum for"},
                   rows);
}

}  // namespace abstand::report
