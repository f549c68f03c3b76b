// Plan view: surfaces above the floor, seen from above.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::tracking {

/// A grid on the floor. Each cell stores the visible surface area above it in height slabs.
class PlanView {
 public:
  static constexpr double kCell = 0.04;                     ///< m
  static constexpr double kHalfWidth = 5.0, kReach = 10.0;  ///< m: to both sides, and ahead
  static constexpr int kColumns = 250, kRows = 250;
  static constexpr int kSlabs = 10;                   ///< number of height slabs ...
  static constexpr double kSlab = 0.25;               ///< ... m each
  static constexpr double kHighest = kSlabs * kSlab;  ///< m; higher points are ignored

  using Place = Eigen::Vector2d;  ///< m: to the right of the camera and ahead of it

  struct Cell {
    std::array<float, kSlabs> area{};  ///< m^2, visible
    float top{0.0f};                   ///< m
    float whole{0.0f};                 ///< m^2, sum of all slabs
    float settled{0.0f};               ///< m^2 of it whose depth has been stable for a while ...
    float drift{0.0f};                 ///< ... and the sum of how far (m) that drifted, times m^2
    int component{-1};
    bool cut{false};           ///< the upper border of the image is there
    bool side{false};          ///< the left or the right one is
    bool beside_known{false};  ///< a known object that is nearer adjoins it in the image
    std::int16_t owner{-1};    ///< index of the person that it belongs to; -1: none
  };

  PlanView();
  void clear();
  /// The cell at a position; -1 outside of the grid.
  static int cellAt(double right, double ahead) {
    const double column = (right + kHalfWidth) * (1.0 / kCell), row = ahead * (1.0 / kCell);
    if (!(column >= 0.0 && column < kColumns && row >= 0.0 && row < kRows)) return -1;
    return static_cast<int>(row) * kColumns + static_cast<int>(column);
  }
  static Place placeOf(int cell) {
    return {(cell % kColumns + 0.5) * kCell - kHalfWidth, (cell / kColumns + 0.5) * kCell};
  }
  /// `height` from 0 to below kHighest.
  void add(int cell, double height, double area) {
    Cell& c = cells_[static_cast<std::size_t>(cell)];
    if (c.whole == 0.0f) used_.push_back(cell);
    const auto a = static_cast<float>(area), h = static_cast<float>(height);
    c.whole += a;
    c.area[static_cast<std::size_t>(height * (1.0 / kSlab))] += a;
    if (h > c.top) c.top = h;
  }
  /// Notes that the upper border of the image cuts the surface above a cell; after add().
  void markCut(int cell) { cells_[static_cast<std::size_t>(cell)].cut = true; }
  /// Likewise the left or the right border.
  void markSide(int cell) { cells_[static_cast<std::size_t>(cell)].side = true; }
  /// A part of what was added, whose depth has been stable for a while, and drifted by `drift` (m).
  void addSettled(int cell, double area, double drift) {
    Cell& c = cells_[static_cast<std::size_t>(cell)];
    c.settled += static_cast<float>(area);
    c.drift += static_cast<float>(area * drift);
  }
  /// Notes that a known object is before the surface beside this one; after add().
  void markBesideKnown(int cell) { cells_[static_cast<std::size_t>(cell)].beside_known = true; }
  /// Connects occupied cells up to 8 cm apart into components(), numbered in order of their first cell.
  void join();

  const Cell& cell(int i) const { return cells_[static_cast<std::size_t>(i)]; }
  Cell& cell(int i) { return cells_[static_cast<std::size_t>(i)]; }
  /// m^2; less surface above a cell is noise.
  static constexpr float kMinArea = 4e-4f;
  bool occupied(int i) const { return cell(i).whole >= kMinArea; }

  /// Cells of a component, or all used cells (including noise), in a fixed order.
  const std::vector<int>& used() const { return used_; }
  std::size_t components() const { return starts_.size() - 1; }
  std::span<const int> component(std::size_t k) const {
    return std::span(joined_).subspan(starts_[k], starts_[k + 1] - starts_[k]);
  }
  /// Calls visit(cell, distance) for the occupied cells within `radius` (m) of a position.
  template <class Visit>
  void around(const Place& place, double radius, const Visit& visit) const {
    const int reach = static_cast<int>(radius / kCell) + 1;
    const int column = static_cast<int>(std::floor((place.x() + kHalfWidth) / kCell));
    const int row = static_cast<int>(std::floor(place.y() / kCell));
    for (int r = std::max(0, row - reach); r <= std::min(kRows - 1, row + reach); ++r)
      for (int c = std::max(0, column - reach); c <= std::min(kColumns - 1, column + reach); ++c) {
        const int i = r * kColumns + c;
        if (!occupied(i)) continue;
        const double distance = (placeOf(i) - place).norm();
        if (distance <= radius) visit(i, distance);
      }
  }

 private:
  std::vector<Cell> cells_;
  std::vector<int> used_, joined_;
  std::vector<std::size_t> starts_{0};
};

}  // namespace abstand::tracking
