#include "app/report/tune_report.hpp"

#include <algorithm>
#include <cmath>

#include "app/report/exposure_section.hpp"
#include "app/report/margin_section.hpp"
#include "app/report/page.hpp"
#include "app/report/speed_section.hpp"
#include "app/report/svg_plot.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"
#include "core/text/escaped_xml.hpp"

namespace abstand::report {
namespace {

constexpr std::size_t kApproaches = 20, kPictures = 3;
constexpr std::size_t kPlotPoints = 350;

std::string shown(const char* pattern, double value) {
  if (std::isnan(value)) return "not known";
  if (std::isinf(value)) return value > 0.0 ? "none" : "not seen";
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}
std::string counted(std::size_t n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}
std::string mm(double metres) { return shown("%.0f mm", 1e3 * metres); }
std::string percent(double share) {
  return std::isfinite(share) ? shown("%.0f %%", 100.0 * share) : "not certain";
}
std::string seconds(double t) { return shown("%.3f s", t); }

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

std::string proposedSection(const tune::TuneAnswer& answer) {
  std::vector<std::vector<std::string>> rows;
  for (const tune::ProposedMargin& p : answer.table.proposed) {
    std::vector<std::string> row{p.part, std::isinf(p.margin) ? "no margin suffices" : mm(p.margin)};
    if (const auto& d = p.decided_by)
      row.insert(row.end(), {answer.recordings[d->recording].recording + " at " + seconds(d->t), d->link,
                             shown("%.1f mm", 1e3 * d->bound) + " + " + shown("%.1f mm", 1e3 * d->pose) +
                                 " + " + shown("%.1f mm", 1e3 * d->sampling)});
    else
      row.insert(row.end(), {"no stop needed", "", ""});
    row.push_back(p.fit ? mm(p.fit->quantile(0.99)) : "too few recordings");
    rows.push_back(std::move(row));
  }
  const double share = answer.table.proposed.front().unseen_share;
  return "<h2>Proposed margins</h2>\n<p>The smallest margin of each part without a missed stop in " +
         counted(answer.recordings.size(), "recording") +
         ". The last but one column lists the shares of each margin: the engine's bound, the uncertainty "
         "of the pose and the displacement within one frame of the sensor.</p>\n" +
         htmlTable({"part", "margin", "determined by", "link", "bound + pose + frame",
                    "99 % of recordings (Gumbel)"},
                   rows) +
         "<p><strong>Confidence.</strong> If further recordings are of the same kind and independent of each "
         "other, then with "
         "95 % confidence at most " +
         shown("%.1f %%", 100.0 * share) +
         " of them need a larger margin for a part (order statistics; the rule of three). More recordings "
         "make this percentage "
         "smaller; others of another kind (other people, tasks, speeds) are not covered by it at all.</p>\n";
}

verify::Plot curveOf(const tune::TuneAnswer& answer) {
  verify::Plot plot{"Stops", "margin [m]", "stops per minute", false, false, {}};
  plot.series = {{"all", {}, {}}, {"false", {}, {}}, {"missed", {}, {}}};
  for (const tune::MarginRow& row : answer.table.rows) {
    if (row.part != tune::kWholeBody || !(row.outcome.time > 0.0)) continue;
    const double minutes = row.outcome.time / 60.0;
    const double values[] = {static_cast<double>(row.outcome.stops) / minutes,
                             static_cast<double>(row.outcome.false_stops) / minutes,
                             static_cast<double>(row.outcome.missed_stops) / minutes};
    for (std::size_t i = 0; i < 3; ++i) {
      plot.series[i].x.push_back(row.margin);
      plot.series[i].y.push_back(values[i]);
    }
  }
  return plot;
}

verify::Plot shareOf(const tune::TuneAnswer& answer) {
  verify::Plot plot{"Time stopped", "margin [m]", "share of the time", false, false, {{"stopped", {}, {}}}};
  for (const tune::MarginRow& row : answer.table.rows) {
    if (row.part != tune::kWholeBody) continue;
    plot.series[0].x.push_back(row.margin);
    plot.series[0].y.push_back(row.outcome.stoppedShare());
  }
  return plot;
}

std::string curveSection(const tune::TuneAnswer& answer) {
  std::vector<std::vector<std::string>> rows;
  for (const tune::MarginRow& row : answer.table.rows) {
    if (row.part != tune::kWholeBody) continue;
    const margin::MarginOutcome& o = row.outcome;
    rows.push_back({mm(row.margin), std::to_string(o.stops), shown("%.1f %%", 100.0 * o.stoppedShare()),
                    std::to_string(o.false_stops), std::to_string(o.missed_stops),
                    std::isinf(o.min_clearance) ? "none" : mm(o.min_clearance),
                    o.lead_time ? seconds(*o.lead_time) : "no contact"});
  }
  return "<h2>Cost of margins</h2>\n<p>All parts with the same margin, over all recordings. A false stop "
         "is one without which "
         "the limit would have been kept; a missed stop is not certainly in time.</p>\n" +
         svgPlot(shareOf(answer)) + svgPlot(curveOf(answer)) +
         htmlTable({"margin", "stops", "time stopped", "false", "missed",
                    "smallest clearance to a moving robot", "lead time"},
                   rows);
}

/// Nearest first.
std::vector<tune::RankedApproach> ranked(const tune::TuneAnswer& answer) {
  std::vector<tune::RankedApproach> all = tune::rankedApproaches(answer);
  all.resize(std::min(all.size(), kApproaches));
  return all;
}

std::string approachSection(const tune::TuneAnswer& answer, const TuneReportOptions& options) {
  std::string html =
      "<h2>Nearest approaches</h2>\n<p>Local minima of the certified clearance, nearest first, and the "
      "contact at the highest closing speed of the approach, as percentages of the limits of "
      "the body region: transient, or quasi-static where the part may be clamped.</p>\n";
  std::vector<std::vector<std::string>> rows;
  std::string pictures;
  const auto all = ranked(answer);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const tune::Approach& a = *all[i].approach;
    const tune::TunedRecording& r = *all[i].recording;
    const std::string part = r.pass.parts[a.part].part, link = r.pass.links[a.link];
    const bool contact = !a.contact.region.empty();
    std::vector<std::string> row{mm(a.clearance), part, link, seconds(a.t)};
    if (contact)
      row.insert(row.end(),
                 {shown("%.2f m/s", a.contact.closing),
                  a.contact.region + ", " + std::string(contact::kindText(a.contact.kind)),
                  a.contact.excluded ? "excluded"
                                     : shown("%.0f N", a.contact.force) + ", " + percent(a.contact.share),
                  a.contact.excluded ? "" : percent(a.contact.pressure_share)});
    else
      row.insert(row.end(), {"not closing", "", "", ""});
    if (answer.recordings.size() > 1) row.push_back(r.recording);
    rows.push_back(std::move(row));
    if (i >= kPictures || !options.picture) continue;
    const std::string svg = options.picture(r, a);
    if (!svg.empty())
      pictures += "<figure>" + svg + "<figcaption>" +
                  text::escapedXml(part + " to " + link + " at " + seconds(a.t) + ": " + mm(a.clearance)) +
                  "; people orange, robots blue.</figcaption></figure>\n";
  }
  if (rows.empty()) return html + "<p>None below " + mm(answer.options.pass.near) + ".</p>\n";
  std::vector<std::string> header{"clearance",
                                  "part",
                                  "link",
                                  "time",
                                  "hardest closing before",
                                  "region",
                                  "force, of its limit",
                                  "pressure, of its limit"};
  if (answer.recordings.size() > 1) header.push_back("recording");
  return html + htmlTable(header, rows) + pictures;
}

/// Minimum of each interval, so that no minimum is lost.
verify::Series thinned(const margin::ClearanceTrack& track, const std::string& name) {
  verify::Series series{name, {}, {}};
  const std::size_t stride = track.frames() / kPlotPoints + 1;
  for (std::size_t i = 0; i < track.frames(); i += stride) {
    std::size_t least = i;
    for (std::size_t k = i; k < std::min(i + stride, track.frames()); ++k)
      if (track.clearance[k] < track.clearance[least]) least = k;
    series.x.push_back(track.t[least]);
    series.y.push_back(track.clearance[least]);
  }
  return series;
}

/// Clearance over time of the parts that came nearest in a recording.
std::string timeSection(const tune::TuneAnswer& answer) {
  const auto all = ranked(answer);
  if (all.empty()) return {};
  const tune::TunedRecording& r = *all.front().recording;
  verify::Plot plot{r.recording, "time [s]", "clearance [m]", false, false, {}};
  std::vector<std::pair<double, const tune::PartClearance*>> parts;
  for (const tune::PartClearance& p : r.pass.parts)
    parts.emplace_back(*std::min_element(p.track.clearance.begin(), p.track.clearance.end()), &p);
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < std::min<std::size_t>(5, parts.size()); ++i)
    plot.series.push_back(thinned(parts[i].second->track, parts[i].second->part));
  return "<h2>Clearance over time</h2>\n<p>The five parts with the smallest clearances, in the recording "
         "with the "
         "nearest approach.</p>\n" +
         svgPlot(plot);
}

std::string assumptions(const tune::TuneAnswer& answer) {
  const tune::TuneOptions& o = answer.options;
  std::string html =
      "<h2>Assumptions</h2>\n" +
      htmlTable(
          {"quantity", "value", "effect of a change"},
          {{"reaction time", shown("%.0f ms", 1e3 * o.pass.braking.reaction_time),
            "each 10 ms more need 10 ms times the closing speed more margin: 16 mm at 1.6 m/s"},
           {"deceleration of each joint", shown("%.3g rad/s^2 or m/s^2", o.pass.braking.deceleration),
            "half of it doubles the braking time and the person's displacement in it"},
           {"limit", mm(o.pass.limit), "margins grow with it one to one"},
           {"calibration error between recording and robot", mm(o.pass.calibration_error),
            "every clearance is smaller by it, and margins grow with it one to one; 0 means that it was not "
            "measured"},
           {"parts that may be clamped", listed(tune::clampedParts(answer.recordings)),
            "quasi-static limits apply to their contacts, which are usually half of the transient ones, "
            "and no "
            "part of their mass recoils"},
           {"restart time", seconds(o.restart_time), "adds to the time stopped, not to margins"}}) +
      "<p>Each stop is evaluated separately; robot and person follow the recording until the margin is "
      "violated. Distances "
      "and braking are certified between frames too (docs/margins.md).</p>\n<h2>Inputs</h2>\n";
  std::vector<std::vector<std::string>> rows;
  for (const tune::TunedRecording& r : answer.recordings)
    rows.push_back({r.recording, std::to_string(r.frames), seconds(r.seconds()),
                    r.unjudged > 0.0 ? seconds(r.unjudged) : "", r.content});
  html += htmlTable({"recording", "frames", "length", "not evaluated", "content (XXH3)"}, rows);
  for (const auto& f : answer.failed)
    html += "<p class=\"failed\">Not run: " + text::escapedXml(f.recording + ": " + f.error) + "</p>\n";
  const std::string& stamp = answer.recordings.front().contact_limits;
  if (!stamp.empty()) html += "<p>Limits of contact: " + text::escapedXml(stamp) + ".</p>\n";
  rows.clear();
  for (const tune::TunedRecording& r : answer.recordings)
    for (const run::Reservation& reservation : r.reservations)
      rows.push_back({r.recording, reservation.kind, reservation.text});
  html += "<h2>Reservations</h2>\n";
  return html +
         (rows.empty() ? std::string("<p>None.</p>\n") : htmlTable({"recording", "kind", "reason"}, rows));
}

constexpr const char* kSignature = R"(<div class="whole"><h2>Signature</h2>
<p>The numbers above follow from the inputs and assumptions listed. They are an analysis, no certified safety function, and replace
neither a risk assessment nor a measurement at the machine.</p>
<div class="wide sign"><table><tr><th>margins put into service</th><td style="width:24rem">&nbsp;</td></tr>
<tr><th>reaction time and stopping verified by</th><td>&nbsp;</td></tr><tr><th>name, role</th><td>&nbsp;</td></tr>
<tr><th>date, signature</th><td>&nbsp;</td></tr></table></div></div>
)";

}  // namespace

void writeTuneReport(const tune::TuneAnswer& answer, const TuneReportOptions& options,
                     const std::filesystem::path& file) {
  OutputFile out(file);
  double time = 0.0;
  for (const tune::TunedRecording& r : answer.recordings) time += r.seconds();
  out.stream() << pageBegin("Abstand: safety margins")
               << "<h1>Safety margins: " << text::escapedXml(options.command) << "</h1>\n<p>"
               << counted(answer.recordings.size(), "recording") << ", " << shown("%.1f minutes", time / 60.0)
               << (answer.interrupted ? ", <span class=\"failed\">interrupted: incomplete</span>" : "")
               << ".</p>\n"
               << closestSection(answer) << proposedSection(answer) << marginSetSection(answer)
               << bandSection(answer) << curveSection(answer) << speedSection(answer) << tradeSection(answer)
               << approachSection(answer, options) << timeSection(answer) << exposureSection(answer.exposure)
               << assumptions(answer) << kSignature << "<p class=\"soft\">Made by abstand "
               << text::escapedXml(options.version) << ".</p>\n"
               << pageEnd();
  out.commit();
}

}  // namespace abstand::report
