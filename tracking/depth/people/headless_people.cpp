// Cells at the upper border, and trunks with free space beside.
#include "tracking/depth/people/headless_people.hpp"

#include "tracking/depth/people/body_area.hpp"

namespace abstand::tracking {
namespace {

using BodyPlace = PlanView::Place;

// m. Lower than the shoulders of small adults (1.2), the border cuts off more than a head; higher than the
// first of the second, it is above the heads.
constexpr float kLowestCut = 1.15f, kHighestCut = 2.0f;
constexpr double kBroadestCut = 0.75;  // m; shoulders with arms are up to 0.6 broad
constexpr int kFewestCells = 3;
constexpr double kTrunkArea = 0.15;  // m^2 of visible surface, half of a trunk that faces the camera
constexpr double kTrunkFrom = 0.3;   // share of the height at the border
// m: free space, and cells in it that are nearly as high as the border, relative to those of the body.
constexpr double kFreeBeside = 0.65, kMaxCellsBeside = 0.25;
constexpr float kNearlyAsHigh = 0.4f;
// Whole bodies, m: of people whose hands are at or above the head. The trunk of somebody who sits is lower.
constexpr float kLowestWhole = 1.2f, kHighestWhole = 2.45f;
constexpr double kTrunkTo = 0.7;            // share of the height
constexpr double kTrunkFromTheSide = 0.10;  // m^2
constexpr double kMaxAreaBeside = 0.25;     // of the trunk, as kMaxCellsBeside

/// Whether the border cuts off a body here; sets its middle.
bool isCutBody(const PlanView& plan, std::span<const int> cells, BodyPlace& middle) {
  int cut = 0;
  float top = 0.0f;
  BodyPlace sum = BodyPlace::Zero(), low = BodyPlace::Constant(kInfinity), high = -low;
  for (const int i : cells) {
    if (!plan.cell(i).cut) continue;
    const BodyPlace place = PlanView::placeOf(i);
    ++cut;
    top = std::max(top, plan.cell(i).top);
    sum += place;
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  if (cut < kFewestCells || top < kLowestCut || top > kHighestCut || (high - low).norm() > kBroadestCut)
    return false;
  middle = middleOfBody(plan, sum / cut);
  const auto first = static_cast<std::size_t>(kTrunkFrom * static_cast<double>(top) / PlanView::kSlab);
  double area = 0.0;
  int body = 0, beside = 0;
  plan.around(middle, kFreeBeside, [&](int i, double distance) {
    const PlanView::Cell& cell = plan.cell(i);
    const bool is_high = cell.top > top - kNearlyAsHigh;
    if (distance > kBodyRadius) {
      beside += is_high;
      return;
    }
    body += is_high;
    for (std::size_t slab = first; slab < PlanView::kSlabs; ++slab)
      area += static_cast<double>(cell.area[slab]);
  });
  return area >= kTrunkArea && beside <= kMaxCellsBeside * body;
}

/// Whether there is a body inside the image, whose highest part need not be a head; sets its middle.
bool isWholeBody(const PlanView& plan, std::span<const int> cells, BodyPlace& middle) {
  int highest = cells.front();
  for (const int i : cells)
    if (plan.cell(i).top > plan.cell(highest).top) highest = i;
  const float top = plan.cell(highest).top;
  if (top < kLowestWhole || top > kHighestWhole) return false;
  const auto first = static_cast<std::size_t>(kTrunkFrom * static_cast<double>(top) / PlanView::kSlab);
  const auto last = static_cast<std::size_t>(kTrunkTo * static_cast<double>(top) / PlanView::kSlab);
  middle = middleOfBody(plan, PlanView::placeOf(highest));
  double trunk = 0.0, beside = 0.0;
  plan.around(middle, kFreeBeside, [&](int i, double distance) {
    double& area = distance > kBodyRadius ? beside : trunk;
    for (std::size_t slab = first; slab <= last; ++slab) area += static_cast<double>(plan.cell(i).area[slab]);
  });
  return trunk >= kTrunkFromTheSide && beside <= kMaxAreaBeside * trunk;
}

}  // namespace

void HeadlessPeople::find(const PlanView& plan) {
  found_.start();
  count_ = 0;
  for (std::size_t k = 0; k < plan.components() && !found_.full(); ++k) {
    BodyPlace middle;
    const std::span<const int> cells = plan.component(k);
    if (!isCutBody(plan, cells, middle) && !isWholeBody(plan, cells, middle)) continue;
    const RepeatedPlaces::Entry& body = found_.add(middle, kMoved);
    if (body.images >= kImages && body.moved) places_[count_++] = middle;
  }
}

}  // namespace abstand::tracking
