#include "app/tune/exposure_table.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "app/tune/part_frames.hpp"

namespace abstand::tune {
namespace {

/// s, for floating-point times: a frame at the border of two segments belongs to the later one.
constexpr double kBorder = 1e-9;

void add(ExposureRow& row, const Exposure& e, const TunedRecording& recording) {
  row.spent.add(e.spent);
  row.time += e.time;
  row.not_seen += e.not_seen;
  row.closing = std::max(row.closing, e.closing);
  if (std::isinf(e.min_clearance) || (row.nearest && !(e.min_clearance < row.nearest->clearance))) return;
  row.nearest = {e.min_clearance, recording.recording, recording.pass.parts[e.part].part,
                 recording.pass.links[e.link], e.t_min};
}

/// Rows by name, in order of first use.
class Rows {
 public:
  explicit Rows(std::vector<ExposureRow>& rows) : rows_(rows) {}
  ExposureRow& of(const std::string& part, const std::string& link) {
    const auto [at, fresh] = index_.try_emplace({part, link}, rows_.size());
    if (fresh) {
      rows_.emplace_back();
      rows_.back().part = part;
      rows_.back().link = link;
    }
    return rows_[at->second];
  }

 private:
  std::vector<ExposureRow>& rows_;
  std::map<std::pair<std::string, std::string>, std::size_t> index_;
};

std::vector<ExposureRow> stretches(const std::vector<TunedRecording>& recordings, double length) {
  double begin = kInfinity, end = -kInfinity;
  for (const TunedRecording& r : recordings) begin = std::min(begin, r.t0), end = std::max(end, r.t1);
  std::vector<ExposureRow> rows;
  if (!(end > begin)) return rows;
  rows.resize(static_cast<std::size_t>(std::ceil((end - begin) / length - kBorder)));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].t0 = begin + static_cast<double>(i) * length;
    rows[i].t1 = std::min(end, begin + static_cast<double>(i + 1) * length);
  }
  return rows;
}

/// What all parts did in a frame.
struct BodyFrame {
  double least{kInfinity},
      closing{0.0};                ///< m, of the nearest part that was seen; m/s, of parts that are near
  std::uint16_t part{0}, link{0};  ///< the nearest
  bool seen{true};                 ///< every part was
};

/// Adds part `p` to the frames of a recording.
void addPart(const PartClearance& part, std::size_t p, double near, std::vector<BodyFrame>& frames) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    BodyFrame& frame = frames[i];
    const double clearance = part.track.clearance[i];
    if (!margin::isExposureKnown(clearance, part.uncertainty[i])) {
      frame.seen = false;
      continue;
    }
    if (clearance < near) frame.closing = std::max(frame.closing, part.robot_speed[i] + part.person_speed[i]);
    if (!(clearance < frame.least)) continue;
    frame.least = clearance;
    frame.part = static_cast<std::uint16_t>(p);
    frame.link = part.link[i];
  }
}

std::vector<ExposureRow> phasesOf(const std::vector<TunedRecording>& recordings, double length, double near) {
  std::vector<ExposureRow> rows = stretches(recordings, length);
  if (rows.empty()) return rows;
  const double begin = rows.front().t0;
  const auto at = [&](double t) -> ExposureRow& {
    const double index = std::floor((t - begin) / length + kBorder);
    return rows[std::min(rows.size() - 1, static_cast<std::size_t>(std::max(0.0, index)))];
  };
  for (const TunedRecording& r : recordings) {
    std::vector<BodyFrame> frames(r.frames);
    std::vector<double> t;
    PartByPart parts(r);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const PartClearance& part = parts.part(p);
      if (p == 0) t = part.track.t;
      addPart(part, p, near, frames);
    }
    for (std::size_t i = 0; i < t.size(); ++i) {
      Exposure exposure;
      exposure.closing = frames[i].closing;
      exposure.part = frames[i].part;
      exposure.link = frames[i].link;
      exposure.add(t[i], frames[i].least, frames[i].seen, i + 1 < t.size() ? t[i + 1] - t[i] : 0.0);
      add(at(t[i]), exposure, r);
    }
    for (const Approach& a : r.pass.approaches) ++at(a.t).approaches;
  }
  return rows;
}

}  // namespace

ExposureTable exposureTable(const std::vector<TunedRecording>& recordings, double segment, double near) {
  ExposureTable table;
  table.near = near;
  Rows parts(table.parts), links(table.links), pairs(table.pairs);
  std::map<std::pair<std::string, std::size_t>, margin::ExposureTime> body;
  std::map<std::tuple<FloorLayer, int, int>, margin::ExposureTime> floor;
  for (const TunedRecording& r : recordings) {
    const PassExposure& e = r.pass.exposure;
    add(table.body, e.body, r);
    for (std::size_t p = 0; p < e.parts.size(); ++p) add(parts.of(r.pass.parts[p].part, ""), e.parts[p], r);
    for (std::size_t l = 0; l < e.links.size(); ++l) add(links.of("", r.pass.links[l]), e.links[l], r);
    for (const PassExposure::Pair& pair : e.pairs)
      add(pairs.of(r.pass.parts[pair.part].part, r.pass.links[pair.link]), pair.exposure, r);
    table.body.approaches += r.pass.approaches.size();
    for (const Approach& a : r.pass.approaches) {
      const std::string &part = r.pass.parts[a.part].part, &link = r.pass.links[a.link];
      ++parts.of(part, "").approaches;
      ++links.of("", link).approaches;
      ++pairs.of(part, link).approaches;
    }
    for (const BodyCell& c : e.body_cells) body[{r.pass.parts[c.part].part, c.cell}].add(c.spent);
    for (const FloorCell& c : e.floor_cells) floor[{c.layer, c.x, c.y}].add(c.spent);
    if (table.outlines.empty())
      for (const LinkOutline& o : e.outlines) table.outlines.push_back({r.pass.links[o.link], o.corners});
  }
  for (const auto& [key, spent] : body) table.body_cells.push_back({key.first, key.second, spent});
  for (const auto& [key, spent] : floor)
    table.floor_cells.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), spent});
  table.phases = phasesOf(recordings, segment, near);
  return table;
}

}  // namespace abstand::tune
