// Straight runs of sheer cells, and cells of one height.
#include "tracking/depth/people/furniture.hpp"

#include <algorithm>

#include "tracking/depth/people/pillars.hpp"

namespace abstand::tracking {
namespace {

using Place = PlanView::Place;

constexpr float kMinSheer = 2e-4f;    // m^2 in a slab, of a cell
constexpr float kSheer = 0.003f;      // m^2 in a slab of 4 cm of a line; a sheer surface there has up to 0.01
constexpr double kFront = 0.6;        // m, breadth
constexpr double kFilled = 0.85;      // share of its cells that are sheer
constexpr double kBeside = 0.05;      // m, distance from the line ...
constexpr double kBesideFar = 0.006;  // ... and more by the square of the depth (1/m), as a Kinect's noise
constexpr double kStanding = 0.4;     // share of the cells of a front that are seen near the floor
constexpr double kEndFront = 0.44;    // m, of a front with a level top, as of the end of a bench
constexpr double kLevelShare = 0.8;   // of its cells that have the same top
constexpr float kLowestEnd = 0.7f;    // m, of that top; higher than the knees of people who sit
constexpr int kLines = 40;            // tries for each front
constexpr int kFronts = 3;            // of a component
constexpr int kGapCells = 2;
constexpr std::uint8_t kKeptImages = 10;  // that furniture is remembered for, as a search may miss it
constexpr int kOften = 6;                 // images
constexpr int kNearCells = 7;
constexpr float kSameTop = 0.05f;   // m, of a cell in which furniture stays, also if its lower part is hidden
constexpr float kWall = 1.0f;       // m, fronts higher than that are walls
constexpr float kRoomWall = 1.9f;   // m, walls that go on beyond gaps; people are lower
constexpr double kCutShare = 0.2;   // of a wall, that the upper border of the image cuts off
constexpr double kDeepest = 1.0;    // m, of the level top of a front
constexpr double kContinues = 1.0;  // m that fronts and tops above kLowestEnd go on behind people
constexpr float kAbove = 0.03f;     // m, of the surface that belongs to furniture above its top

constexpr double kLevel = 0.3;    // m^2
constexpr float kUneven = 0.01f;  // m, of a level above its median
constexpr float kLowestLevel = 0.3f, kHighestLevel = 1.2f, kLevelBin = 0.04f;

/// Surface (m^2) in the lowest three slabs.
using Slabs = std::array<float, 3>;

bool isSheer(const Slabs& area, float limit) {
  return area[1] > limit && (area[0] > limit || area[2] > limit);
}
Slabs lowestSlabs(const PlanView::Cell& c) { return {c.area[0], c.area[1], c.area[2]}; }

bool areLevel(float top, float other) { return std::abs(top - other) < kLevelBin; }
/// Whether most cells of a front that is no wall end at the same height.
bool hasLevelTop(std::span<const float> tops, float top) {
  if (top < kLowestEnd || top > kWall) return false;
  const auto level = std::count_if(tops.begin(), tops.end(), [&](float t) { return areLevel(t, top); });
  return static_cast<double>(level) >= kLevelShare * static_cast<double>(tops.size());
}

/// Whether a front is seen near the floor. Somebody on a chair, seen from the side, is as broad and as
/// straight above the seat's edge, but has legs below (0.2 of the cells; benches and their ends 0.6 to 1).
bool standsOnFloor(const PlanView& plan, std::span<const int> front) {
  const auto low =
      std::count_if(front.begin(), front.end(), [&](int i) { return plan.cell(i).area[0] > kMinSheer; });
  return static_cast<double>(low) >= kStanding * static_cast<double>(front.size());
}

}  // namespace

/// Points p with n . p = offset; `along` is perpendicular to n.
struct Furniture::FrontLine {
  Place n{Place::Zero()}, along{Place::Zero()};
  double offset{0.0};
  double begin{0.0}, end{0.0};  ///< m along the line, of the longest run
  double breadth() const { return end - begin; }
  bool holds(const Place& p) const {
    const double beside = kBeside + kBesideFar * p.y() * p.y();
    return std::abs(n.dot(p) - offset) < beside;
  }
  /// Whether its run is there.
  bool runsOver(const Place& p) const {
    const double at = along.dot(p);
    return holds(p) && at >= begin - PlanView::kCell && at <= end + PlanView::kCell;
  }
};

Furniture::Furniture()
    : top_(static_cast<std::size_t>(PlanView::kColumns) * PlanView::kRows, 0.0f),
      age_(top_.size(), 0),
      found_(top_.size(), 0),
      seen_(top_.size(), 0),
      beside_(top_.size(), 0),
      line_(static_cast<std::size_t>(4.0 * PlanView::kReach / PlanView::kCell)) {
  marked_.reserve(top_.size());
  filled_.reserve(top_.size());
  sheer_.reserve(top_.size());
  chosen_.reserve(top_.size());
  tops_.reserve(top_.size());
}

void Furniture::noteBackground(int cell, float height) {
  const auto k = static_cast<std::size_t>(cell);
  if (height < top_[k]) seen_[k] = image_;
}

/// Whether furniture was found, or is background, beside a cell in this image.
bool Furniture::isKept(int cell) const {
  const int row = cell / PlanView::kColumns, column = cell % PlanView::kColumns;
  for (int r = std::max(0, row - kNearCells); r <= std::min(PlanView::kRows - 1, row + kNearCells); ++r)
    for (int c = std::max(0, column - kNearCells); c <= std::min(PlanView::kColumns - 1, column + kNearCells);
         ++c)
      if (seen_[static_cast<std::size_t>(r * PlanView::kColumns + c)] == image_) return true;
  return false;
}

/// Cells of a surface seen at a low angle are often missed: they take the top of their neighbours for one
/// image.
void Furniture::fillHoles() {
  constexpr std::uint8_t kSurrounded = 4;  // of eight neighbours
  const auto visit = [&](int cell, const auto& neighbour) {
    const int row = cell / PlanView::kColumns, column = cell % PlanView::kColumns;
    if (row == 0 || column == 0 || row == PlanView::kRows - 1 || column == PlanView::kColumns - 1) return;
    for (int r = -1; r <= 1; ++r)
      for (int c = -1; c <= 1; ++c)
        if (r != 0 || c != 0) neighbour(static_cast<std::size_t>(cell + r * PlanView::kColumns + c));
  };
  const std::size_t lasting = marked_.size();
  for (std::size_t m = 0; m < lasting; ++m)
    if (found_[static_cast<std::size_t>(marked_[m])] >= kOften)
      visit(marked_[m], [&](std::size_t k) { ++beside_[k]; });
  for (std::size_t m = 0; m < lasting; ++m)
    visit(marked_[m], [&](std::size_t k) {
      if (beside_[k] >= kSurrounded && top_[k] == 0.0f) {
        top_[k] = top_[static_cast<std::size_t>(marked_[m])];
        filled_.push_back(static_cast<int>(k));
      }
      beside_[k] = 0;
    });
}

bool Furniture::find(const PlanView& plan) {
  for (const int i : filled_) top_[static_cast<std::size_t>(i)] = 0.0f;
  filled_.clear();
  for (std::size_t k = 0; k < plan.components(); ++k) {
    findFronts(plan, plan.component(k));
    findLevels(plan, plan.component(k));
    if (sheerShare(plan, plan.component(k)) < kPillar) continue;
    for (const int i : plan.component(k)) mark(i, plan.cell(i).top);
  }
  std::erase_if(marked_, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    if (seen_[k] == image_) {
      age_[k] = 0;
      return false;
    }
    if (found_[k] >= kOften && (std::abs(plan.cell(i).top + kAbove - top_[k]) < kSameTop || isKept(i)))
      return false;
    if (++age_[k] <= kKeptImages) return false;
    top_[k] = 0.0f;
    found_[k] = 0;
    return true;
  });
  fillHoles();
  ++image_;
  return !marked_.empty();
}

void Furniture::mark(int cell, float top) {
  const auto k = static_cast<std::size_t>(cell);
  if (top_[k] == 0.0f) marked_.push_back(cell);
  top_[k] = std::max(top_[k], top + kAbove);
  if (seen_[k] == image_) return;
  seen_[k] = image_;
  if (found_[k] < 255) ++found_[k];
}

/// Of the sheer cells, along lines through two of them; without breadth: none.
Furniture::FrontLine Furniture::longestFront(const PlanView& plan, Random& random) {
  const double middle = 0.5 * static_cast<double>(line_.size()) * PlanView::kCell;
  FrontLine best;
  for (int k = 0; k < kLines; ++k) {
    const Place a = PlanView::placeOf(sheer_[random.below(sheer_.size())]);
    const Place b = PlanView::placeOf(sheer_[random.below(sheer_.size())]);
    if ((b - a).norm() < 0.5 * kEndFront) continue;
    FrontLine line;
    line.along = (b - a).normalized();
    line.n = {-line.along.y(), line.along.x()};
    line.offset = line.n.dot(a);
    std::fill(line_.begin(), line_.end(), Slabs{});
    for (const int i : sheer_) {
      const Place p = PlanView::placeOf(i);
      if (!line.holds(p)) continue;
      Slabs& sum = line_[static_cast<std::size_t>((line.along.dot(p) + middle) / PlanView::kCell)];
      const Slabs area = lowestSlabs(plan.cell(i));
      for (std::size_t slab = 0; slab < sum.size(); ++slab) sum[slab] += area[slab];
    }
    // The longest run.
    int begin = -1, last = -1, filled = 0;
    for (int i = 0; i < static_cast<int>(line_.size()); ++i) {
      if (!isSheer(line_[static_cast<std::size_t>(i)], kSheer)) continue;
      if (begin < 0 || i - last > kGapCells) begin = i, filled = 0;
      last = i;
      ++filled;
      const double breadth = (last + 1 - begin) * PlanView::kCell;
      if (breadth < std::max(kEndFront, best.breadth()) || filled * PlanView::kCell < kFilled * breadth)
        continue;
      best = line;
      best.begin = begin * PlanView::kCell - middle;
      best.end = best.begin + breadth;
    }
  }
  return best;
}

void Furniture::findFronts(const PlanView& plan, std::span<const int> component) {
  sheer_.clear();
  for (const int i : component)
    if (isSheer(lowestSlabs(plan.cell(i)), kMinSheer)) sheer_.push_back(i);
  Random random(1, 0);
  for (int front = 0; front < kFronts; ++front) {
    if (static_cast<double>(sheer_.size()) * PlanView::kCell < kFilled * kEndFront) return;
    const FrontLine best = longestFront(plan, random);
    if (best.breadth() < kEndFront) return;
    chosen_.clear();
    tops_.clear();
    for (const int i : component) {
      if (!best.runsOver(PlanView::placeOf(i))) continue;
      chosen_.push_back(i);
      tops_.push_back(plan.cell(i).top);
    }
    std::nth_element(tops_.begin(), tops_.begin() + static_cast<std::ptrdiff_t>(tops_.size() / 2),
                     tops_.end());
    const float top = tops_[tops_.size() / 2];
    if (top <= kWall && !standsOnFloor(plan, chosen_)) {
      std::erase_if(sheer_, [&](int i) { return best.holds(PlanView::placeOf(i)); });
      continue;
    }
    const bool is_end = best.breadth() < kFront;
    if (is_end && !hasLevelTop(tops_, top)) return;
    for (const int i : chosen_)
      if (!is_end || areLevel(plan.cell(i).top, top)) mark(i, top);
    std::erase_if(sheer_, [&](int i) { return topOf(i) > 0.0f; });
    top > kWall ? markWall(plan, best) : markLevel(plan, best, top);
  }
}

/// A wall goes on in its plane where somebody hides its lower part; beside a lower one, as a cupboard,
/// somebody may stand. chosen_ are its cells, tops_ their tops.
void Furniture::markWall(const PlanView& plan, const FrontLine& line) {
  const auto cut = std::count_if(chosen_.begin(), chosen_.end(), [&](int i) { return plan.cell(i).cut; });
  const bool goes_on = *std::max_element(tops_.begin(), tops_.end()) > kRoomWall ||
                       static_cast<double>(cut) * PlanView::kCell > kCutShare * line.breadth();
  for (const int i : plan.used()) {
    const Place p = PlanView::placeOf(i);
    if (goes_on ? line.holds(p) : line.runsOver(p)) mark(i, static_cast<float>(PlanView::kHighest));
  }
}

/// What is level with the top of a lower front and beside it is, for instance, the top of a bench that is
/// seen at a low angle.
void Furniture::markLevel(const PlanView& plan, const FrontLine& line, float top) {
  const double behind = top < kLowestEnd ? 0.0 : kContinues;
  const double beside = line.breadth() < kFront ? 0.0 : behind;
  for (const int i : plan.used()) {
    const Place p = PlanView::placeOf(i);
    const double along = line.along.dot(p);
    if (areLevel(plan.cell(i).top, top) && std::abs(line.n.dot(p) - line.offset) < kDeepest + behind &&
        along > line.begin - beside && along < line.end + beside)
      mark(i, plan.cell(i).top);
  }
}

void Furniture::findLevels(const PlanView& plan, std::span<const int> component) {
  constexpr auto kBins = static_cast<std::size_t>((kHighestLevel - kLowestLevel) / kLevelBin);
  std::array<int, kBins + 2> count{};
  const auto binOf = [](float top) { return static_cast<std::size_t>((top - kLowestLevel) / kLevelBin); };
  const auto inside = [](float top) { return top > kLowestLevel && top < kHighestLevel; };
  for (const int i : component)
    if (inside(plan.cell(i).top)) ++count[binOf(plan.cell(i).top)];
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const double area = (count[bin] + count[bin + 1]) * PlanView::kCell * PlanView::kCell;
    if (area < kLevel) continue;
    chosen_.clear();
    tops_.clear();
    for (const int i : component) {
      const float mine = plan.cell(i).top;
      if (!inside(mine) || (binOf(mine) != bin && binOf(mine) != bin + 1)) continue;
      chosen_.push_back(i);
      tops_.push_back(mine);
    }
    std::nth_element(tops_.begin(), tops_.begin() + static_cast<std::ptrdiff_t>(tops_.size() / 2),
                     tops_.end());
    const float top = tops_[tops_.size() / 2] + kUneven;
    for (const int i : chosen_)
      if (plan.cell(i).top < top + kAbove) mark(i, top);
  }
}

}  // namespace abstand::tracking
