#include "app/report/exposure_section.hpp"

#include <algorithm>
#include <cmath>

#include "app/report/body_heat_picture.hpp"
#include "app/report/page.hpp"
#include "app/report/room_heat_picture.hpp"
#include "app/report/svg_plot.hpp"
#include "core/base/output_file.hpp"
#include "core/text/escaped_xml.hpp"

namespace abstand::report {
namespace {

constexpr std::size_t kPairRows = 15, kPhaseRows = 15;
using Cells = std::vector<std::string>;

std::string decimals(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}
std::string spell(double seconds) { return seconds > 0.0 ? decimals("%.2f", seconds) : "0"; }

std::string bandName(double band) { return band > 0.0 ? decimals("< %.0f mm", 1e3 * band) : "contact"; }

Cells header(const Cells& names, bool several) {
  Cells cells = names;
  for (const double band : margin::kExposureBands) cells.push_back(bandName(band));
  for (const char* more :
       {"weighted", "not seen", "near misses", "closing m/s", "min mm", "part", "link", "at s"})
    cells.emplace_back(more);
  if (several) cells.emplace_back("recording");
  // The nearest pair is not repeated if it is the row's name.
  for (const std::string& name : names) {
    const auto again =
        std::find(cells.begin() + static_cast<std::ptrdiff_t>(names.size()), cells.end(), name);
    if (again != cells.end()) cells.erase(again);
  }
  return cells;
}

/// Cells after the name of a row.
Cells numbers(const tune::ExposureRow& row, const Cells& names, bool several) {
  Cells cells;
  for (const double seconds : row.spent.below) cells.push_back(spell(seconds));
  cells.push_back(spell(row.spent.weighted));
  cells.push_back(spell(row.not_seen));
  cells.push_back(std::to_string(row.approaches));
  cells.push_back(std::isfinite(row.closing) ? decimals("%.2f", row.closing) : "");
  const tune::ExposureRow::Nearest none;
  const tune::ExposureRow::Nearest& n = row.nearest ? *row.nearest : none;
  cells.push_back(row.nearest ? decimals("%.0f", 1e3 * n.clearance) : "not seen");
  const bool names_part = std::find(names.begin(), names.end(), "part") != names.end();
  const bool names_link = std::find(names.begin(), names.end(), "link") != names.end();
  if (!names_part) cells.push_back(n.part);
  if (!names_link) cells.push_back(n.link);
  cells.push_back(row.nearest ? decimals("%.2f", n.t) : "");
  if (several) cells.push_back(n.recording);
  return cells;
}

/// False for one recording, whose name is then omitted.
bool fromSeveral(const tune::ExposureTable& table) {
  const auto other = [&](const tune::ExposureRow& row) {
    return row.nearest && table.body.nearest && row.nearest->recording != table.body.nearest->recording;
  };
  return std::any_of(table.pairs.begin(), table.pairs.end(), other) ||
         std::any_of(table.phases.begin(), table.phases.end(), other);
}

template <class Name>
std::string tableOf(const Cells& names, const std::vector<const tune::ExposureRow*>& rows, bool several,
                    const Name& name) {
  std::vector<Cells> cells;
  for (const tune::ExposureRow* row : rows) {
    cells.push_back(name(*row));
    const Cells more = numbers(*row, names, several);
    cells.back().insert(cells.back().end(), more.begin(), more.end());
  }
  return htmlTable(header(names, several), cells);
}

std::vector<const tune::ExposureRow*> pointers(const std::vector<tune::ExposureRow>& rows) {
  std::vector<const tune::ExposureRow*> all;
  for (const tune::ExposureRow& row : rows) all.push_back(&row);
  return all;
}

/// The rows with the highest weighted exposure.
std::vector<const tune::ExposureRow*> highest(const std::vector<tune::ExposureRow>& rows, std::size_t count) {
  std::vector<const tune::ExposureRow*> all;
  for (const tune::ExposureRow& row : rows)
    if (row.spent.weighted > 0.0) all.push_back(&row);
  std::stable_sort(all.begin(), all.end(),
                   [](const auto* a, const auto* b) { return a->spent.weighted > b->spent.weighted; });
  all.resize(std::min(all.size(), count));
  return all;
}

std::string figure(const std::string& svg, const std::string& caption) {
  return svg.empty() ? std::string()
                     : "<figure>" + svg + "<figcaption>" + caption + "</figcaption></figure>\n";
}

std::string pictures(const tune::ExposureTable& table) {
  if (table.body_cells.empty())
    return "<p>No tracked part came nearer than " + decimals("%.0f mm", 1e3 * margin::kExposureBands.back()) +
           ".</p>\n";
  return figure(bodyHeatPicture(table),
                "Where on the body: weighted exposure of each cell of the surface, in seconds. Each frame "
                "counts for the cell that holds a part's nearest point to the robots. Drawn on a person of "
                "mean stature; dashed outline: the part was not tracked for some of the time.") +
         figure(roomHeatPicture(table),
                "Where in the room, from above: weighted exposure of each cell of " +
                    decimals("%.0f mm", 1e3 * tune::kFloorCell) +
                    " of the floor, in seconds. Robots (blue) at their pose in the first frame.");
}

/// As shares of the time, so that segments of several recordings and a short last one are comparable.
std::string phasePlot(const tune::ExposureTable& table) {
  verify::Plot plot{
      "Exposure over the program", "time of the program [s]", "share of the time", false, false, {}};
  for (std::size_t b = margin::kExposureBands.size(); b-- > 0;) {
    verify::Series series{bandName(margin::kExposureBands[b]), {}, {}};
    for (const tune::ExposureRow& row : table.phases) {
      if (!(row.time > 0.0)) continue;
      series.x.push_back(0.5 * (row.t0 + row.t1));
      series.y.push_back(row.spent.below[b] / row.time);
    }
    plot.series.push_back(std::move(series));
  }
  verify::Series not_seen{"not seen", {}, {}};
  for (const tune::ExposureRow& row : table.phases) {
    if (!(row.time > 0.0)) continue;
    not_seen.x.push_back(0.5 * (row.t0 + row.t1));
    not_seen.y.push_back(row.not_seen / row.time);
  }
  if (table.body.not_seen > 0.0) plot.series.push_back(std::move(not_seen));
  return plot.series.front().x.size() > 1 ? svgPlot(plot) : std::string();
}

}  // namespace

std::string exposureSection(const tune::ExposureTable& table) {
  const bool several = fromSeveral(table);
  const double largest = margin::kExposureBands.back();
  std::string html =
      "<h2>Exposure</h2>\n<p>Seconds with a certified clearance below each band (contact: below 0, so that "
      "it "
      "is not excluded). <em>Weighted</em> counts a second at a clearance <i>c</i> as 1 - <i>c</i> / " +
      decimals("%.0f mm", 1e3 * largest) +
      ", and as 1 in contact: the time below a band, averaged over all bands up to there. Time not seen "
      "is in no band; the true time below a band is at most the sum of both. Closing: the highest speed of "
      "two "
      "nearest points towards each other while nearer than " +
      decimals("%.0f mm", 1e3 * table.near) + "; min: the smallest clearance and its time.</p>\n";
  html += pictures(table) + "<h3>Body parts</h3>\n";
  std::vector<const tune::ExposureRow*> parts{&table.body};
  for (const tune::ExposureRow& row : table.parts) parts.push_back(&row);
  html += tableOf({"part"}, parts, several, [](const tune::ExposureRow& row) {
    const std::string where = row.nearest ? ": " + row.nearest->part : std::string();
    return Cells{row.part.empty() ? "whole body" + where : row.part};
  });
  html += "<h3>Links</h3>\n" + tableOf({"link"}, pointers(table.links), several,
                                       [](const tune::ExposureRow& row) { return Cells{row.link}; });
  const auto pairs = highest(table.pairs, kPairRows);
  if (!pairs.empty())
    html += "<h3>Pairs with the highest weighted exposure</h3>\n" +
            tableOf({"part", "link"}, pairs, several, [](const tune::ExposureRow& row) {
              return Cells{row.part, row.link};
            });
  const auto phases = highest(table.phases, kPhaseRows);
  if (!phases.empty())
    html += "<h3>Program segments with the highest weighted exposure</h3>\n" + phasePlot(table) +
            tableOf({"from", "to"}, phases, several, [](const tune::ExposureRow& row) {
              return Cells{decimals("%.2f s", row.t0), decimals("%.2f s", row.t1)};
            });
  return html;
}

void writeExposurePage(const tune::ExposureTable& table, const ExposurePageOptions& options,
                       const std::filesystem::path& file) {
  OutputFile out(file);
  out.stream() << pageBegin("Abstand: exposure") << "<h1>Exposure of people to robots</h1>\n<p>"
               << options.recordings << (options.recordings == 1 ? " recording, " : " recordings, ")
               << decimals("%.1f s", table.body.time) << ".</p>\n"
               << exposureSection(table) << "<p class=\"soft\">Made by abstand "
               << text::escapedXml(options.version) << ". An analysis, no certified safety function.</p>\n"
               << pageEnd();
  out.commit();
}

}  // namespace abstand::report
