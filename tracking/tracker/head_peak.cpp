// Outline of a view, in columns across it.
#include "tracking/tracker/head_peak.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace abstand::tracking {
namespace {

constexpr double kColumn = 0.03;     // m; points of a person at 5 m are 2 cm apart
constexpr double kLowerHead = 0.08;  // m below the highest point: more than hair, or a hat
constexpr double kHeadDrop = 0.10;   // m below the vertex, where a head is nearly at its widest
constexpr double kNarrowest = 0.11, kWidest = 0.27;  // m; a fist or a forearm is narrower than a head
// m below the vertex: from the neck to the chest, and the width there; an arm has 0.10, a trunk from the side
// 0.2.
constexpr double kChestHigh = 0.25, kChestLow = 0.42, kChest = 0.17;

/// What one camera sees of a person, by columns of kColumn.
class Outline {
 public:
  /// False if the camera does not see the person, or looks straight down.
  bool set(const BodyObservation& seen, std::size_t view) {
    points_ = &seen.points();
    view_ = view;
    Vector3d sum = Vector3d::Zero();
    double count = 0.0;
    each([&](std::size_t i) { sum += points_->point(i), count += 1.0; });
    if (count == 0.0) return false;
    middle_ = sum / count;
    Vector3d away = middle_ - seen.views()[view].eye();
    away.z() = 0.0;
    if (away.norm() < 1e-6) return false;
    across_ = away.normalized().cross(Vector3d::UnitZ());
    top_.fill(-kInfinity);
    each([&](std::size_t i) {
      double& top = top_[columnOf(i)];
      top = std::max(top, static_cast<double>(points_->z[i]));
    });
    return true;
  }

  /// z (m) of the highest head, if it is lower than the highest points; -infinity: none.
  double lowerHead() const {
    const double highest = *std::max_element(top_.begin(), top_.end());
    double head = -kInfinity;
    for (std::size_t c = 1; c + 1 < kColumns; ++c) {
      const bool is_peak = top_[c] >= top_[c - 1] && top_[c] >= top_[c + 1];
      if (is_peak && top_[c] > head && isHead(c)) head = top_[c];
    }
    return head < highest - kLowerHead ? head : -kInfinity;
  }

 private:
  static constexpr std::size_t kColumns = 80;  // 1.2 m to either side

  template <class Visit>
  void each(const Visit& visit) const {
    for (std::size_t i = 0; i < points_->count; ++i)
      if (points_->view[i] == view_) visit(i);
  }
  /// Points farther aside are in the outermost column.
  std::size_t columnOf(std::size_t i) const {
    const double column = across_.dot(points_->point(i) - middle_) / kColumn + 0.5 * kColumns;
    return static_cast<std::size_t>(std::clamp(column, 0.0, kColumns - 1.0));
  }
  /// First and last of the columns around `c` that have a property, which `c` has.
  template <class Has>
  static std::array<std::size_t, 2> columnsAround(std::size_t c, const Has& has) {
    std::array<std::size_t, 2> columns{c, c};
    while (columns[0] > 0 && has(columns[0] - 1)) --columns[0];
    while (columns[1] + 1 < kColumns && has(columns[1] + 1)) ++columns[1];
    return columns;
  }
  static double width(const std::array<std::size_t, 2>& columns) {
    return static_cast<double>(columns[1] - columns[0] + 1) * kColumn;
  }
  bool isHead(std::size_t peak) const {
    const double z = top_[peak];
    const auto [first, last] = columnsAround(peak, [&](std::size_t c) { return top_[c] >= z - kHeadDrop; });
    // A shoulder is beside the neck.
    if (*std::max_element(top_.begin() + first, top_.begin() + last + 1) > z) return false;
    const double head = width({first, last});
    if (head < kNarrowest || head > kWidest) return false;
    std::array<bool, kColumns> is_chest{};
    each([&](std::size_t i) {
      const double below = z - static_cast<double>(points_->z[i]);
      if (below >= kChestHigh && below <= kChestLow) is_chest[columnOf(i)] = true;
    });
    return is_chest[peak] && width(columnsAround(peak, [&](std::size_t c) { return is_chest[c]; })) >= kChest;
  }

  const SeenPoints* points_{nullptr};
  std::size_t view_{0};
  Vector3d middle_{Vector3d::Zero()}, across_{Vector3d::UnitY()};
  std::array<double, kColumns> top_{};
};

}  // namespace

std::optional<double> headBelowHands(const BodyObservation& seen) {
  double head = -kInfinity;
  for (std::size_t v = 0; v < seen.views().size(); ++v)
    if (Outline outline; outline.set(seen, v)) head = std::max(head, outline.lowerHead());
  if (head == -kInfinity) return std::nullopt;
  return head;
}

}  // namespace abstand::tracking
