#include "app/report/summary_section.hpp"

#include <algorithm>
#include <cmath>

#include "app/tune/separation_table.hpp"
#include "core/text/escaped_xml.hpp"
#include "core/text/message_text.hpp"

namespace abstand::report {
namespace {

std::string item(const std::string& text) { return "<li>" + text::escapedXml(text) + "</li>\n"; }
std::string roundedMm(double metres, int digits) { return text::rounded(1e3 * metres, digits) + " mm"; }

std::string nearestText(const tune::TuneAnswer& answer) {
  const tune::ClosestApproach* nearest = nullptr;
  std::string unseen;
  for (const tune::ClosestApproach& c : answer.closest) {
    if (!c.always_seen) unseen += (unseen.empty() ? "" : ", ") + c.part;
    if (!c.link.empty() && (!nearest || c.clearance() < nearest->clearance())) nearest = &c;
  }
  std::string text = "Nobody was ever seen.";
  if (nearest)
    text = "Nearest: " + tune::partText(nearest->part, nearest->tool) + " to " + nearest->link + ", " +
           roundedMm(nearest->distance, 1) + " \u00b1 " + roundedMm(nearest->error(), 1) + ", " +
           tune::verdictText(nearest->verdict()) + " (" + answer.recordings[nearest->recording].recording +
           " at " + text::rounded(nearest->t, 3) + " s).";
  return unseen.empty() ? text : text + " Not always seen, and not known there: " + unseen + ".";
}

std::string marginText(const tune::TuneAnswer& answer) {
  const auto largest = std::max_element(answer.table.proposed.begin(), answer.table.proposed.end(),
                                        [](const auto& a, const auto& b) { return a.margin < b.margin; });
  if (std::isinf(largest->margin)) return "Margins: for " + largest->part + " no margin suffices.";
  if (largest->margin == 0.0) return "Margins: none of these recordings needed one.";
  return "Largest proposed margin: " + roundedMm(largest->margin, 0) + " for " + largest->part + ".";
}

std::string contactText(const tune::TuneAnswer& answer) {
  std::size_t all = 0, beyond = 0, excluded = 0;
  for (const tune::RankedApproach& r : tune::rankedApproaches(answer)) {
    const tune::ContactShare& c = r.approach->contact;
    ++all;
    if (c.region.empty()) continue;
    if (c.excluded)
      ++excluded;
    else if (c.share > 1.0 || c.pressure_share > 1.0)
      ++beyond;
  }
  if (answer.recordings.front().contact_limits.empty()) return "Contacts were not judged.";
  return "Of " + std::to_string(all) + " approaches below " + roundedMm(answer.options.pass.near, 0) + ", " +
         std::to_string(beyond) + " would have been beyond a limit of force or pressure as contacts, and " +
         std::to_string(excluded) + " would have been with a region at which contact is excluded.";
}

std::string separationText(const tune::TuneAnswer& answer) {
  double longest = 0.0;
  std::string part;
  for (const tune::ProposedMargin& p : answer.table.proposed)
    if (const double broken = tune::separationRow(answer.recordings, p.part).broken; broken > longest)
      longest = broken, part = p.part;
  if (part.empty()) return "The protective distance was kept.";
  return "The protective distance was violated, for longest by " + part + ": " + text::rounded(longest, 1) +
         " s.";
}

}  // namespace

std::string summarySection(const tune::TuneAnswer& answer) {
  std::size_t reservations = 0;
  for (const tune::TunedRecording& r : answer.recordings) reservations += r.reservations.size();
  return "<h2>Summary</h2>\n<ul>\n" + item(nearestText(answer)) + item(marginText(answer)) +
         item(contactText(answer)) + item(separationText(answer)) +
         item(std::to_string(answer.failed.size()) + " recordings could not be run, and " +
              std::to_string(reservations) + " reservations weaken the numbers (below).") +
         "</ul>\n";
}

}  // namespace abstand::report
