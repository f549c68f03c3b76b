#include "app/cli/exposure_texts.hpp"

#include <algorithm>
#include <cmath>

#include "app/cli/command_line.hpp"
#include "app/cli/csv_field.hpp"
#include "app/cli/json_values.hpp"
#include "app/cli/tune_texts.hpp"
#include "core/base/number.hpp"
#include "humanmodel/body_cells.hpp"

namespace abstand::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Pairs, segments and near misses in the text; the JSON has all.
constexpr std::size_t kTextRows = 5;

Json spentJson(const margin::ExposureTime& spent) {
  Json below = Json::array();
  for (const double seconds : spent.below) below.push_back(seconds);
  return {{"below", below}, {"weighted", spent.weighted}};
}

Json exposureRowJson(const tune::ExposureRow& row, Json names) {
  names.update(spentJson(row.spent));
  names["time"] = row.time;
  names["not_seen"] = row.not_seen;
  names["near_misses"] = row.approaches;
  names["max_closing_speed"] = numberOrNull(row.closing);
  names["nearest"] = nullptr;
  if (const auto& n = row.nearest)
    names["nearest"] = {{"clearance", n->clearance},
                        {"recording", n->recording},
                        {"t", n->t},
                        {"part", n->part},
                        {"link", n->link}};
  return names;
}

Json floorJson(const tune::ExposureTable& table, tune::FloorLayer layer) {
  Json cells = Json::array();
  for (const tune::FloorCell& c : table.floor_cells) {
    if (c.layer != layer) continue;
    Json cell{{"x", (c.x + 0.5) * tune::kFloorCell}, {"y", (c.y + 0.5) * tune::kFloorCell}};
    cell.update(spentJson(c.spent));
    cells.push_back(std::move(cell));
  }
  return cells;
}

Json bodyJson(const tune::ExposureTable& table) {
  Json cells = Json::array();
  for (const auto& c : table.body_cells) {
    const Vector3d u = humanmodel::cellMiddle(c.cell);
    Json cell{{"part", c.part},
              {"cell", c.cell},
              {"place", humanmodel::cellPlace(c.cell)},
              {"direction", {u.x(), u.y(), u.z()}}};
    cell.update(spentJson(c.spent));
    cells.push_back(std::move(cell));
  }
  return cells;
}

std::string secondsText(double seconds) {
  return seconds > 0.0 ? format("%9.2f", seconds) : std::string("        0");
}

std::string lineOf(const std::string& name, const tune::ExposureRow& row) {
  std::string text = format("%-30s", name.c_str());
  for (const double seconds : row.spent.below) text += secondsText(seconds);
  text += secondsText(row.spent.weighted) + secondsText(row.not_seen);
  text += format("%8zu", row.approaches);
  text += std::isfinite(row.closing) ? format("%9.2f", row.closing) : std::string("        -");
  if (!row.nearest) return text + "  not seen\n";
  const tune::ExposureRow::Nearest& n = *row.nearest;
  return text +
         format("  %.1f mm, %s to %s at %.3f s\n", 1e3 * n.clearance, n.part.c_str(), n.link.c_str(), n.t);
}

std::string titleOf(const char* first) {
  std::string text = format("\n%-30s", first);
  for (const double band : margin::kExposureBands)
    text += band > 0.0 ? format("%6.0f mm", 1e3 * band) : std::string("  contact");
  return text + " weighted not seen  misses  closing    min clearance\n";
}

std::string phaseName(const tune::ExposureRow& row) { return format("%.2f to %.2f s", row.t0, row.t1); }

/// The rows with the highest weighted exposure.
template <class Name>
std::string highestText(const char* title, const std::vector<tune::ExposureRow>& rows, const Name& name) {
  std::vector<const tune::ExposureRow*> some;
  for (const tune::ExposureRow& row : rows)
    if (row.spent.weighted > 0.0) some.push_back(&row);
  std::stable_sort(some.begin(), some.end(),
                   [](const auto* a, const auto* b) { return a->spent.weighted > b->spent.weighted; });
  if (some.empty()) return {};
  std::string text = titleOf(title);
  for (std::size_t i = 0; i < std::min(some.size(), kTextRows); ++i) text += lineOf(name(*some[i]), *some[i]);
  return text;
}

template <class Cells>
auto hottest(const Cells& cells) {
  return std::max_element(cells.begin(), cells.end(),
                          [](const auto& a, const auto& b) { return a.spent.weighted < b.spent.weighted; });
}

std::string placesText(const tune::ExposureTable& table) {
  std::vector<tune::FloorCell> people;
  for (const tune::FloorCell& c : table.floor_cells)
    if (c.layer == tune::FloorLayer::kPeople) people.push_back(c);
  if (people.empty() || table.body_cells.empty()) return {};
  const auto body = hottest(table.body_cells);
  const auto floor = hottest(people);
  return format(
      "\nmaximum weighted exposure on the body: %s, %s, %.2f s; in the room: at (%.3f, %.3f) m, %.2f s\n",
      body->part.c_str(), humanmodel::cellPlace(body->cell).c_str(), body->spent.weighted,
      (floor->x + 0.5) * tune::kFloorCell, (floor->y + 0.5) * tune::kFloorCell, floor->spent.weighted);
}

std::string missesText(const tune::TuneAnswer& answer) {
  const auto ranked = tune::rankedApproaches(answer);
  std::string text = format("\nnear misses (%zu below %.0f mm), nearest first:\n", ranked.size(),
                            1e3 * answer.exposure.near);
  for (std::size_t i = 0; i < std::min(ranked.size(), kTextRows); ++i) {
    const tune::Approach& a = *ranked[i].approach;
    const tune::TunedRecording& r = *ranked[i].recording;
    text += format("%8.1f mm  %s to %s at %.3f s, closing at %.2f m/s%s\n", 1e3 * a.clearance,
                   r.pass.parts[a.part].part.c_str(), r.pass.links[a.link].c_str(), a.t, a.motion.closing(),
                   answer.recordings.size() > 1 ? (", " + r.recording).c_str() : "");
  }
  return text;
}

}  // namespace

nlohmann::ordered_json exposureJson(const tune::TuneAnswer& answer) {
  const tune::ExposureTable& table = answer.exposure;
  Json j{{"recordings", answer.recordings.size()},
         {"bands", margin::kExposureBands},
         {"near", table.near},
         {"whole_body", exposureRowJson(table.body, Json::object())},
         {"parts", Json::array()},
         {"links", Json::array()},
         {"pairs", Json::array()},
         {"phases", Json::array()}};
  for (const auto& row : table.parts) j["parts"].push_back(exposureRowJson(row, {{"part", row.part}}));
  for (const auto& row : table.links) j["links"].push_back(exposureRowJson(row, {{"link", row.link}}));
  for (const auto& row : table.pairs)
    j["pairs"].push_back(exposureRowJson(row, {{"part", row.part}, {"link", row.link}}));
  for (std::size_t i = 0; i < table.phases.size(); ++i)
    j["phases"].push_back(exposureRowJson(
        table.phases[i], {{"segment", i}, {"t0", table.phases[i].t0}, {"t1", table.phases[i].t1}}));
  j["approaches"] = Json::array();
  for (const tune::RankedApproach& r : tune::rankedApproaches(answer))
    j["approaches"].push_back(approachJson(r));
  j["room"] = {{"cell", tune::kFloorCell},
               {"people", floorJson(table, tune::FloorLayer::kPeople)},
               {"robots", floorJson(table, tune::FloorLayer::kRobots)}};
  j["body"] = bodyJson(table);
  return j;
}

std::string exposureText(const tune::TuneAnswer& answer) {
  const tune::ExposureTable& table = answer.exposure;
  std::string text = format("%zu recordings, %.1f s. Seconds with a certified clearance below each band\n",
                            answer.recordings.size(), table.body.time);
  text += titleOf("part") + lineOf("whole_body", table.body);
  for (const auto& row : table.parts) text += lineOf(row.part, row);
  text += titleOf("link");
  for (const auto& row : table.links) text += lineOf(row.link, row);
  text += highestText("pair", table.pairs,
                      [](const tune::ExposureRow& row) { return row.part + " " + row.link; });
  text += highestText("program segment", table.phases, phaseName);
  return text + placesText(table) + missesText(answer);
}

void writeExposureCsv(const tune::ExposureTable& table, std::ostream& out) {
  out << "of,part,link,t0,t1,time";
  for (const double band : margin::kExposureBands) out << ",below_" << formatDouble(band);
  out << ",weighted,not_seen,near_misses,max_closing_speed,min_clearance,min_recording,min_part,min_link,min_"
         "t\n";
  const auto number = [](double v) { return std::isfinite(v) ? formatDouble(v) : std::string(); };
  const auto write = [&](const char* of, const tune::ExposureRow& row) {
    out << of << ',' << row.part << ',' << csvField(row.link) << ',' << number(row.t0) << ','
        << number(row.t1) << ',' << number(row.time);
    for (const double seconds : row.spent.below) out << ',' << number(seconds);
    out << ',' << number(row.spent.weighted) << ',' << number(row.not_seen) << ',' << row.approaches << ','
        << number(row.closing) << ',';
    if (const auto& n = row.nearest)
      out << number(n->clearance) << ',' << csvField(n->recording) << ',' << n->part << ','
          << csvField(n->link) << ',' << number(n->t);
    else
      out << ",,,,";
    out << '\n';
  };
  write("whole_body", table.body);
  for (const auto& row : table.parts) write("part", row);
  for (const auto& row : table.links) write("link", row);
  for (const auto& row : table.pairs) write("pair", row);
  for (const auto& row : table.phases) write("phase", row);
}

}  // namespace abstand::cli
