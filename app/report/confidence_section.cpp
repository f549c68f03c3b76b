#include "app/report/confidence_section.hpp"

#include <algorithm>
#include <cmath>

#include "app/report/page.hpp"
#include "app/report/svg_plot.hpp"
#include "core/text/escaped_xml.hpp"
#include "core/text/message_text.hpp"

namespace abstand::report {
namespace {

constexpr std::size_t kFitPlots = 4;
constexpr int kFitPoints = 80;
// With fewer, more than a quarter of unseen recordings may need more (margin::unseenShare).
constexpr std::size_t kFewRecordings = 10;

std::string percentText(double share, int digits = 1) { return text::rounded(100.0 * share, digits) + " %"; }
std::string marginMm(double metres) { return text::rounded(1e3 * metres, 1) + " mm"; }

std::string recordingsText(const tune::TuneAnswer& answer) {
  return "<p><strong>Confidence by recordings.</strong> If further recordings are of the same kind and "
         "independent of each other, then with 95 % confidence at most " +
         percentText(answer.table.proposed.front().unseen_share) +
         " of them need a larger margin for a part (order statistics; the rule of three). More recordings "
         "make this percentage smaller; others of another kind (other people, tasks, speeds) are not covered "
         "by it at all." +
         (answer.recordings.size() < kFewRecordings ? " <strong>So few recordings say nearly nothing about "
                                                      "others: a margin of 0 mm means that these did not "
                                                      "need one.</strong>"
                                                    : "") +
         "</p>\n";
}

std::string minutesText(const tune::TuneAnswer& answer) {
  const double minutes = tune::shortestJudgedTime(answer.table) / 60.0;
  std::string text = "<p><strong>Confidence by time.</strong> ";
  if (!(minutes > 0.0)) return text + "Some part was never judged: nothing can be said.</p>\n";
  return text + "In " + text::rounded(minutes, 2) +
         " judged minutes (of the part with the least) nothing violated these margins. With 95 % confidence "
         "there are fewer than " +
         text::rounded(margin::unseenRate(minutes), minutes < 100.0 ? 3 : 5) +
         " violations per minute of unseen work, -ln(0.05) / minutes, and at most " +
         percentText(margin::unseenTimeShare(minutes)) +
         " of unseen minutes have one. Model: Poisson process, that is, minutes of the same kind of work "
         "with "
         "the same robots are independent of each other. A recording that repeats one motion has fewer "
         "independent minutes than it lasts. Variants of one recording (the same content) count once, with "
         "the longest of them. Twice the minutes halve the rate. A margin that does not suffice is not "
         "covered.</p>\n";
}

verify::Plot fitPlot(const tune::ProposedMargin& p) {
  verify::Plot plot{p.part + ": margins that the recordings need",
                    "needed margin [m]",
                    "share of recordings that need no more",
                    false,
                    false,
                    {{"recordings", {}, {}}, {"Gumbel fit", {}, {}}}};
  std::vector<double> values;
  std::copy_if(p.needed.begin(), p.needed.end(), std::back_inserter(values),
               [](double v) { return std::isfinite(v); });
  std::sort(values.begin(), values.end());
  const double n = static_cast<double>(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    for (const std::size_t below : {i, i + 1}) {
      plot.series[0].x.push_back(values[i]);
      plot.series[0].y.push_back(static_cast<double>(below) / n);
    }
  const double from = std::min(values.front(), p.fit->quantile(0.01));
  const double to = std::max(values.back(), p.fit->quantile(0.99));
  for (int i = 0; i <= kFitPoints; ++i) {
    const double x = from + (to - from) * i / kFitPoints;
    plot.series[1].x.push_back(x);
    plot.series[1].y.push_back(p.fit->probability(x));
  }
  return plot;
}

std::string fitText(const tune::TuneAnswer& answer) {
  std::vector<const tune::ProposedMargin*> fitted;
  for (const tune::ProposedMargin& p : answer.table.proposed)
    if (p.fit) fitted.push_back(&p);
  if (fitted.empty())
    return "<p>Extreme values: too few recordings that need different margins for a fit (at least 5).</p>\n";
  std::stable_sort(fitted.begin(), fitted.end(),
                   [](const auto* a, const auto* b) { return a->margin > b->margin; });
  std::vector<std::vector<std::string>> rows;
  std::string plots;
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    const tune::ProposedMargin& p = *fitted[i];
    const double critical = margin::criticalMisfit(p.fit->count);
    rows.push_back(
        {p.part, std::to_string(p.fit->count) + " of " + std::to_string(p.needed.size()),
         marginMm(p.fit->location), marginMm(p.fit->scale), marginMm(p.fit->quantile(0.95)),
         marginMm(p.fit->quantile(0.99)), text::rounded(p.fit->misfit, 3), text::rounded(critical, 3),
         p.fit->misfit > critical ? "does not fit: do not use the quantiles" : "not contradicted"});
    if (i < kFitPlots) plots += svgPlot(fitPlot(p));
  }
  return "<h3>Extreme values and their fit</h3>\n<p>Gumbel's extreme value distribution, fitted by "
         "probability weighted moments to the margins that the recordings need. The misfit is the largest "
         "vertical distance between the steps of the recordings and the fitted curve. Of samples that truly "
         "follow a Gumbel distribution, 5 % have a misfit above the critical one: above it, do not use the "
         "quantiles. Below it the recordings do not contradict the distribution; that does not prove "
         "quantiles beyond the recordings, and the 99 % one needs about a hundred of them. Plots: the " +
         std::to_string(std::min(kFitPlots, fitted.size())) + " parts with the largest margins.</p>\n" +
         htmlTable(
             {"part", "recordings", "location", "scale", "95 %", "99 %", "misfit", "critical", "reading"},
             rows) +
         plots;
}

}  // namespace

std::string confidenceSection(const tune::TuneAnswer& answer) {
  return recordingsText(answer) + minutesText(answer) + fitText(answer);
}

}  // namespace abstand::report
