#include "app/report/stop_section.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "app/report/page.hpp"
#include "app/tune/stop_term.hpp"
#include "core/text/escaped_xml.hpp"
#include "core/text/message_text.hpp"

namespace abstand::report {
namespace {

constexpr std::size_t kShownStops = 20;
constexpr const char* kNoTerm = "link does not move towards the part";

std::string stopMm(double metres) {
  return std::isfinite(metres) ? text::rounded(1e3 * metres, 0) : "not seen";
}

std::string outcomeText(const tune::MarginEvent& e) {
  return e.missed ? "missed stop" : e.false_stop ? "false stop" : "stop in time";
}

/// Stops of each part at its proposed margin, recording by recording.
std::vector<tune::MarginEvent> proposedStops(const tune::TuneAnswer& answer) {
  std::vector<tune::MarginEvent> stops;
  for (const tune::TunedRecording& r : answer.recordings) {
    const tune::PartFrames frames(r);
    for (const tune::ProposedMargin& p : answer.table.proposed) {
      if (!(p.margin > 0.0) || std::isinf(p.margin)) continue;
      for (tune::MarginEvent& e : tune::marginEvents(r, frames, p.margin, answer.options.margins(), p.part))
        if (e.kind == tune::MarginEvent::Kind::kIntrusion) stops.push_back(std::move(e));
    }
  }
  return stops;
}

}  // namespace

std::string stopSection(const tune::TuneAnswer& answer) {
  const std::vector<tune::MarginEvent> stops = proposedStops(answer);
  if (stops.empty()) return {};
  std::map<std::string, std::size_t> counts;
  std::vector<std::vector<std::string>> rows;
  for (const tune::MarginEvent& e : stops) {
    const auto term = tune::stopTerm(e, answer.options.pass.separation);
    ++counts[term ? term->largest : kNoTerm];
    if (rows.size() >= kShownStops) continue;
    const tune::PassResult& pass = e.recording->pass;
    std::vector<std::string> row{text::rounded(e.t0, 3) + " s", pass.parts[e.told_part].part,
                                 pass.links[e.told_link], stopMm(e.told_margin), stopMm(e.told_clearance)};
    if (term)
      row.insert(row.end(),
                 {stopMm(term->needed.sum()), stopMm(term->needed.person), stopMm(term->needed.reaction),
                  stopMm(term->needed.stopping), stopMm(term->needed.constant), term->largest});
    else
      row.insert(row.end(), {"", "", "", "", "", kNoTerm});
    row.push_back(outcomeText(e));
    if (answer.recordings.size() > 1) row.push_back(e.recording->recording);
    rows.push_back(std::move(row));
  }
  std::string summary;
  for (const auto& [term, count] : counts)
    summary += (summary.empty() ? "" : ", ") + term + ": " + std::to_string(count);
  std::vector<std::string> header{"time", "part", "link", "margin",    "clearance", "S_p",
                                  "S_h",  "S_r",  "S_s",  "constants", "largest",   "outcome"};
  if (answer.recordings.size() > 1) header.push_back("recording");
  return "<h2>Stops of the proposed margins</h2>\n<p>Each part with its proposed margin. At the beginning of "
         "each stop, in mm: the protective distance S_p of the pair that stopped the robot, its terms, and "
         "the largest of them, which a change would reduce most: person (S_h: assumed speed of people, "
         "reaction and stopping time), reaction (S_r: speed of the robot, reaction time), stopping (S_s: "
         "speed of the robot, stopping time), constant (C + Z_d + Z_r: sensor and errors). " +
         std::to_string(stops.size()) + " stops by their largest term: " + text::escapedXml(summary) +
         (stops.size() > rows.size() ? ". The first " + std::to_string(rows.size()) + " of them:" : ":") +
         "</p>\n" + htmlTable(header, rows);
}

}  // namespace abstand::report
