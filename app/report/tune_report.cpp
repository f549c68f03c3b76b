#include "app/report/tune_report.hpp"

#include <algorithm>
#include <cmath>

#include "app/report/assumption_section.hpp"
#include "app/report/confidence_section.hpp"
#include "app/report/contact_section.hpp"
#include "app/report/exposure_section.hpp"
#include "app/report/margin_section.hpp"
#include "app/report/page.hpp"
#include "app/report/separation_section.hpp"
#include "app/report/speed_section.hpp"
#include "app/report/stop_section.hpp"
#include "app/report/summary_section.hpp"
#include "app/report/svg_plot.hpp"
#include "app/tune/part_frames.hpp"
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
std::string massText(double kg) { return std::isfinite(kg) ? shown("%.1f kg", kg) : "wall"; }
std::string seconds(double t) { return shown("%.3f s", t); }

std::string enclosedText(const tune::TuneAnswer& answer, const std::string& part) {
  const auto range = tune::enclosedRange(answer.recordings, part);
  if (!range) return "not known";
  const std::string least = percent(range->min.all_statures), largest = percent(range->max.all_statures);
  return least == largest ? least : least + " to " + largest;
}

/// The 99 % quantile, unless the distribution does not fit.
std::string fitCell(const tune::ProposedMargin& p) {
  if (!p.fit) return "too few recordings";
  return p.fit->misfit > margin::criticalMisfit(p.fit->count) ? "does not fit" : mm(p.fit->quantile(0.99));
}

std::string proposedSection(const tune::TuneAnswer& answer) {
  std::vector<std::vector<std::string>> rows;
  for (const tune::ProposedMargin& p : answer.table.proposed) {
    std::vector<std::string> row{p.decided_by ? tune::partText(p.part, p.decided_by->tool) : p.part,
                                 std::isinf(p.margin) ? "no margin suffices" : mm(p.margin)};
    if (const auto& d = p.decided_by)
      row.insert(row.end(), {answer.recordings[d->recording].recording + " at " + seconds(d->t), d->link,
                             shown("%.1f mm", 1e3 * d->bound) + " + " + shown("%.1f mm", 1e3 * d->pose) +
                                 " + " + shown("%.1f mm", 1e3 * d->sampling)});
    else
      row.insert(row.end(), {"no stop needed", "", ""});
    row.push_back(enclosedText(answer, p.part));
    row.push_back(fitCell(p));
    rows.push_back(std::move(row));
  }
  return "<h2>Proposed margins</h2>\n<p>The smallest margin of each part without a missed stop in " +
         counted(answer.recordings.size(), "recording") +
         ". Of each margin, one column says what the engine's bound, the uncertainty of the pose (with "
         "latency and "
         "calibration) and the motion within one frame of the sensor take. \"Body encloses\" is the share of "
         "all "
         "people (ANSUR II; of the stated sex, else women and men half and half) whose bare part is no "
         "thicker "
         "than that of the body that the margin was judged with; with others the margin may be too small. A "
         "larger percentile of the person raises it.</p>\n" +
         htmlTable({"part", "margin", "determined by", "link", "bound + pose + frame", "body encloses",
                    "99 % of recordings (Gumbel)"},
                   rows) +
         confidenceSection(answer);
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
      "the body region: transient, or quasi-static where the part may be clamped. Wall: the file of the "
      "robot has no masses. Half the robot's speed halves the robot's part of the closing speed. \"Not "
      "certain\" is a pressure on a point that is too sharp to have a certain area. Values, masses and "
      "limits follow below.</p>\n";
  std::vector<std::vector<std::string>> rows;
  std::string pictures;
  const auto all = ranked(answer);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const tune::Approach& a = *all[i].approach;
    const tune::TunedRecording& r = *all[i].recording;
    const std::string part = tune::partText(r.pass.parts[a.part].part, r.pass.toolName(a.tool));
    const std::string& link = r.pass.links[a.link];
    const bool contact = !a.contact.region.empty();
    std::vector<std::string> row{std::to_string(i + 1), mm(a.clearance), part, link, seconds(a.t)};
    if (contact)
      row.insert(row.end(),
                 {shown("%.2f m/s", a.contact.closing), massText(a.contact.robot_mass),
                  a.contact.region + ", " + std::string(contact::kindText(a.contact.kind)),
                  a.contact.excluded ? "excluded"
                                     : shown("%.0f N", a.contact.force) + ", " + percent(a.contact.share),
                  a.contact.excluded ? "" : percent(a.contact.pressure_share)});
    else
      row.insert(row.end(), {"not closing", "", "", "", ""});
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
  std::vector<std::string> header{"no.",
                                  "clearance",
                                  "part",
                                  "link",
                                  "time",
                                  "hardest closing before",
                                  "robot's mass",
                                  "region",
                                  "force, of its limit",
                                  "pressure, of its limit"};
  if (answer.recordings.size() > 1) header.push_back("recording");
  return html + htmlTable(header, rows) + contactTable(answer, all) + limitTable(answer) + pictures;
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
  const tune::PartFrames frames(r);
  std::vector<std::pair<double, const tune::PartClearance*>> parts;
  for (const tune::PartClearance& p : frames.parts())
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
               << summarySection(answer) << closestSection(answer) << proposedSection(answer)
               << marginSetSection(answer) << bandSection(answer) << worstPhaseSection(answer)
               << curveSection(answer) << stopSection(answer) << separationSection(answer)
               << contactTimeSection(answer) << speedSection(answer) << tradeSection(answer)
               << approachSection(answer, options) << timeSection(answer) << exposureSection(answer.exposure)
               << assumptionSection(answer) << kSignature << "<p class=\"soft\">Made by abstand "
               << text::escapedXml(options.version) << ".</p>\n"
               << pageEnd();
  out.commit();
}

}  // namespace abstand::report
