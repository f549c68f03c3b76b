#include "app/tune/exposure_tally.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "humanmodel/body_cells.hpp"

namespace abstand::tune {
namespace {

constexpr int kOutlineDirections = 24;
constexpr double kMaxFloorIndex = 1e9;
constexpr auto kNoPair = std::numeric_limits<std::size_t>::max();

std::optional<int> floorIndex(double p) {
  const double index = std::floor(p / kFloorCell);
  if (!(std::abs(index) < kMaxFloorIndex)) return std::nullopt;
  return static_cast<int>(index);
}

bool isKnown(const WindowFrame& frame, std::size_t pair) {
  return margin::isExposureKnown(frame.clearance[pair], frame.uncertainty[pair]);
}

}  // namespace

ExposureTally::ExposureTally(const session::Session& session, const std::vector<WatchedPair>& pairs,
                             std::span<const Names> names, double near)
    : session_(session), pairs_(pairs), near_(near) {
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::size_t> slot;
  for (const Names& n : names) slot.try_emplace({n.part, n.link}, 0);
  std::size_t parts = 0, links = 0;
  for (auto& [name, number] : slot) {
    number = slots_.size();
    slots_.push_back({name.first, name.second});
    parts = std::max<std::size_t>(parts, name.first + 1u);
    links = std::max<std::size_t>(links, name.second + 1u);
    result_.pairs.push_back({name.first, name.second, {}});
  }
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    slot_of_.push_back(slot.at({names[p].part, names[p].link}));
    const auto& surface = *session.scene().objects()[pairs[p].part].spec.structure->surface;
    half_extent_.push_back(0.5 * surface.bounds().extent());
  }
  min_of_slot_.resize(slots_.size());
  result_.parts.resize(parts);
  result_.links.resize(links);
  min_of_link_.resize(links);
  cells_.resize(parts * humanmodel::kCellCount);
}

void ExposureTally::frame(const WindowFrame& frame, double duration, std::span<const ClosingMotion> motions,
                          std::span<const std::size_t> nearest) {
  if (result_.outlines.empty()) drawOutlines(frame);
  noteClosing(frame, motions);
  takeClearances(frame, duration, nearest);
  takeCells(frame, duration, nearest);
}

void ExposureTally::noteClosing(const WindowFrame& frame, std::span<const ClosingMotion> motions) {
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    if (!(frame.clearance[p] < near_) || !isKnown(frame, p)) continue;
    const Names& names = slots_[slot_of_[p]];
    const double closing = motions[p].closing();
    for (Exposure* e : {&result_.pairs[slot_of_[p]].exposure, &result_.parts[names.part],
                        &result_.links[names.link], &result_.body})
      e->closing = std::max(e->closing, closing);
  }
}

/// Smallest known clearance; unknown ones are recorded separately.
void ExposureTally::take(Least& least, const WindowFrame& frame, std::size_t pair) const {
  if (!isKnown(frame, pair)) {
    least.seen = false;
  } else if (frame.clearance[pair] < least.clearance) {
    const Names& names = slots_[slot_of_[pair]];
    least = {frame.clearance[pair], names.part, names.link, least.seen};
  }
}

void ExposureTally::takeClearances(const WindowFrame& frame, double duration,
                                   std::span<const std::size_t> nearest) {
  const auto add = [&](Exposure& exposure, const Least& least) {
    if (exposure.add(frame.t, least.clearance, least.seen, duration))
      exposure.part = least.part, exposure.link = least.link;
  };
  // Of several people with the same part the nearest one.
  std::fill(min_of_slot_.begin(), min_of_slot_.end(), kNoPair);
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    std::size_t& least = min_of_slot_[slot_of_[p]];
    if (least == kNoPair || frame.clearance[p] < frame.clearance[least]) least = p;
  }
  std::fill(min_of_link_.begin(), min_of_link_.end(), Least{});
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    Least alone;
    take(alone, frame, min_of_slot_[s]);
    add(result_.pairs[s].exposure, alone);
    take(min_of_link_[slots_[s].link], frame, min_of_slot_[s]);
  }
  for (std::size_t l = 0; l < min_of_link_.size(); ++l) add(result_.links[l], min_of_link_[l]);
  Least of_all;
  for (std::size_t part = 0; part < nearest.size(); ++part) {
    Least alone;
    take(alone, frame, nearest[part]);
    add(result_.parts[part], alone);
    take(of_all, frame, nearest[part]);
  }
  add(result_.body, of_all);
}

void ExposureTally::takeCells(const WindowFrame& frame, double duration,
                              std::span<const std::size_t> nearest) {
  in_frame_.clear();
  for (std::size_t part = 0; part < nearest.size(); ++part) {
    const std::size_t p = nearest[part];
    const double clearance = frame.clearance[p];
    if (!(clearance < margin::kExposureBands.back()) || !isKnown(frame, p)) continue;
    const Vector3d p_P = frame.X_WB[pairs_[p].part].inverse() * frame.on_part[p];
    const Vector3d u = p_P.cwiseQuotient(half_extent_[p]);
    if (u.allFinite() && u.squaredNorm() > 0.0)
      cells_[part * humanmodel::kCellCount + humanmodel::cellOf(u)].add(clearance, duration);
    for (const FloorLayer layer : {FloorLayer::kPeople, FloorLayer::kRobots}) {
      const Vector3d& at = layer == FloorLayer::kPeople ? frame.on_part[p] : frame.on_link[p];
      const auto x = floorIndex(at.x()), y = floorIndex(at.y());
      if (!x || !y) continue;
      const FloorKey key{layer, *x, *y};
      const auto found =
          std::find_if(in_frame_.begin(), in_frame_.end(), [&](const auto& c) { return c.first == key; });
      if (found == in_frame_.end())
        in_frame_.emplace_back(key, clearance);
      else
        found->second = std::min(found->second, clearance);
    }
  }
  if (duration > 0.0)
    for (const auto& [key, clearance] : in_frame_) floor_[key].add(clearance, duration);
}

void ExposureTally::drawOutlines(const WindowFrame& frame) {
  std::vector<bool> drawn(result_.links.size(), false);
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const std::uint16_t link = slots_[slot_of_[p]].link;
    if (drawn[link]) continue;
    drawn[link] = true;
    LinkOutline outline{link, {}};
    const Transform& X_WB = frame.X_WB[pairs_[p].link];
    const auto& support = session_.scene().objects()[pairs_[p].link].spec.structure->support;
    for (int i = 0; i < kOutlineDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kOutlineDirections;
      const Vector3d n_W(std::cos(angle), std::sin(angle), 0.0);
      const Vector3d corner = X_WB * support.extreme(X_WB.linear().transpose() * n_W).point;
      outline.corners.emplace_back(corner.x(), corner.y());
    }
    result_.outlines.push_back(std::move(outline));
  }
  std::sort(result_.outlines.begin(), result_.outlines.end(),
            [](const LinkOutline& a, const LinkOutline& b) { return a.link < b.link; });
}

PassExposure ExposureTally::finish() {
  for (std::size_t i = 0; i < cells_.size(); ++i)
    if (cells_[i].weighted > 0.0)
      result_.body_cells.push_back({static_cast<std::uint16_t>(i / humanmodel::kCellCount),
                                    static_cast<std::uint16_t>(i % humanmodel::kCellCount), cells_[i]});
  for (const auto& [key, spent] : floor_)
    result_.floor_cells.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), spent});
  return std::move(result_);
}

}  // namespace abstand::tune
