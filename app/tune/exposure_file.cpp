#include "app/tune/exposure_file.hpp"

#include <cmath>

#include "core/base/error.hpp"
#include "humanmodel/body_cells.hpp"

namespace abstand::tune {
namespace {

constexpr std::size_t kBands = margin::kExposureBands.size();
constexpr std::size_t kSpentColumns = kBands + 1;
/// Part and link (-1: all), times in bands, time, not seen, smallest clearance, its t, part and link, closing
/// speed.
constexpr std::size_t kExposureColumns = 2 + kSpentColumns + 7;
/// Part, cell, times in bands.
constexpr std::size_t kBodyColumns = 2 + kSpentColumns;
/// Layer, x, y, times in bands.
constexpr std::size_t kFloorColumns = 3 + kSpentColumns;
/// Link, x, y.
constexpr std::size_t kOutlineColumns = 3;
constexpr double kMaxFloorCell = 1e9;

void addSpent(hdf5::TableWriter& out, std::size_t table, const margin::ExposureTime& spent) {
  out.add(table, spent.below);
  out.add(table, spent.weighted);
}

void addExposure(hdf5::TableWriter& out, std::size_t table, double part, double link, const Exposure& e) {
  out.add(table, part);
  out.add(table, link);
  addSpent(out, table, e.spent);
  for (const double v : {e.time, e.not_seen, e.min_clearance, e.t_min, static_cast<double>(e.part),
                         static_cast<double>(e.link), e.closing})
    out.add(table, v);
  out.endRow();
}

/// The numbers of one row in sequence, each validated.
class Row {
 public:
  Row(const double* values, const std::string& file) : next_(values), file_(file) {}
  double number() { return *next_++; }
  /// s, finite, not negative.
  double time() {
    const double v = number();
    if (!(v >= 0.0 && std::isfinite(v))) fail("a time that is negative or not finite");
    return v;
  }
  /// An integer from `least` to below `count`.
  double whole(double least, double count, const char* what) {
    const double v = number();
    if (!(v >= least && v < count && v == std::floor(v))) fail(what);
    return v;
  }
  margin::ExposureTime spent() {
    margin::ExposureTime spent;
    for (double& v : spent.below) v = time();
    spent.weighted = time();
    return spent;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw ParseError({file_}, "found an exposure with " + what + ", expected a file written by abstand");
  }
  const double* next_;
  const std::string& file_;
};

Exposure exposureOf(Row& row, const NameCounts& names) {
  Exposure e;
  e.spent = row.spent();
  e.time = row.time();
  e.not_seen = row.time();
  e.min_clearance = row.number();
  e.t_min = row.number();
  e.part = static_cast<std::uint16_t>(row.whole(0.0, static_cast<double>(names.parts), "an unknown part"));
  e.link = static_cast<std::uint16_t>(row.whole(0.0, static_cast<double>(names.links), "an unknown link"));
  e.closing = row.number();
  return e;
}

/// Calls `take` with each row of a table.
template <class Take>
void eachRow(const hdf5::TableReader& in, const std::string& name, std::size_t width, const std::string& file,
             const Take& take) {
  const std::size_t rows = in.extents(name).rows;
  const std::vector<double> values = in.table(name, rows, width);
  for (std::size_t i = 0; i < rows; ++i) {
    Row row(values.data() + i * width, file);
    take(row);
  }
}

}  // namespace

void writeExposure(const PassExposure& exposure, hdf5::TableWriter& out) {
  const std::size_t all = out.table("exposure", {kExposureColumns});
  addExposure(out, all, -1.0, -1.0, exposure.body);
  for (std::size_t p = 0; p < exposure.parts.size(); ++p)
    addExposure(out, all, static_cast<double>(p), -1.0, exposure.parts[p]);
  for (std::size_t l = 0; l < exposure.links.size(); ++l)
    addExposure(out, all, -1.0, static_cast<double>(l), exposure.links[l]);
  for (const PassExposure::Pair& p : exposure.pairs) addExposure(out, all, p.part, p.link, p.exposure);
  out.nextTables();
  const std::size_t body = out.table("exposure_body", {kBodyColumns});
  for (const BodyCell& c : exposure.body_cells) {
    out.add(body, c.part);
    out.add(body, c.cell);
    addSpent(out, body, c.spent);
    out.endRow();
  }
  out.nextTables();
  const std::size_t floor = out.table("exposure_floor", {kFloorColumns});
  for (const FloorCell& c : exposure.floor_cells) {
    for (const double v :
         {c.layer == FloorLayer::kPeople ? 0.0 : 1.0, static_cast<double>(c.x), static_cast<double>(c.y)})
      out.add(floor, v);
    addSpent(out, floor, c.spent);
    out.endRow();
  }
  out.nextTables();
  const std::size_t outlines = out.table("outlines", {kOutlineColumns});
  for (const LinkOutline& o : exposure.outlines)
    for (const Eigen::Vector2d& corner : o.corners) {
      for (const double v : {static_cast<double>(o.link), corner.x(), corner.y()}) out.add(outlines, v);
      out.endRow();
    }
}

PassExposure readExposure(const hdf5::TableReader& in, const NameCounts& names, const std::string& file) {
  PassExposure exposure;
  exposure.parts.resize(names.parts);
  exposure.links.resize(names.links);
  const auto parts = static_cast<double>(names.parts), links = static_cast<double>(names.links);
  eachRow(in, "exposure", kExposureColumns, file, [&](Row& row) {
    const double part = row.whole(-1.0, parts, "an unknown part");
    const double link = row.whole(-1.0, links, "an unknown link");
    const Exposure e = exposureOf(row, names);
    if (part >= 0.0 && link >= 0.0)
      exposure.pairs.push_back({static_cast<std::uint16_t>(part), static_cast<std::uint16_t>(link), e});
    else if (part >= 0.0)
      exposure.parts[static_cast<std::size_t>(part)] = e;
    else if (link >= 0.0)
      exposure.links[static_cast<std::size_t>(link)] = e;
    else
      exposure.body = e;
  });
  eachRow(in, "exposure_body", kBodyColumns, file, [&](Row& row) {
    BodyCell c;
    c.part = static_cast<std::uint16_t>(row.whole(0.0, parts, "an unknown part"));
    c.cell = static_cast<std::uint16_t>(
        row.whole(0.0, static_cast<double>(humanmodel::kCellCount), "an unknown cell"));
    c.spent = row.spent();
    exposure.body_cells.push_back(c);
  });
  eachRow(in, "exposure_floor", kFloorColumns, file, [&](Row& row) {
    FloorCell c;
    c.layer = row.whole(0.0, 2.0, "an unknown layer") == 0.0 ? FloorLayer::kPeople : FloorLayer::kRobots;
    c.x = static_cast<int>(row.whole(-kMaxFloorCell, kMaxFloorCell, "an invalid position"));
    c.y = static_cast<int>(row.whole(-kMaxFloorCell, kMaxFloorCell, "an invalid position"));
    c.spent = row.spent();
    exposure.floor_cells.push_back(c);
  });
  eachRow(in, "outlines", kOutlineColumns, file, [&](Row& row) {
    const auto link = static_cast<std::uint16_t>(row.whole(0.0, links, "an unknown link"));
    const double x = row.number(), y = row.number();
    if (!std::isfinite(x) || !std::isfinite(y)) return;
    if (exposure.outlines.empty() || exposure.outlines.back().link != link)
      exposure.outlines.push_back({link, {}});
    exposure.outlines.back().corners.emplace_back(x, y);
  });
  return exposure;
}

}  // namespace abstand::tune
