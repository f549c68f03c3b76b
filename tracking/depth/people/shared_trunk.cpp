// The extent of the surface between and beside two peaks, along their connecting line.
#include "tracking/depth/people/shared_trunk.hpp"

#include "tracking/depth/people/body_area.hpp"

namespace abstand::tracking {
namespace {

constexpr double kHipsAt = 0.35, kShouldersAt = 0.75;  // share of the height of the peak
constexpr double kOutliers = 0.03;                     // share of the surface, at each end
// Simulated people of 1.75 m with raised arms have at most 0.08 m and 0.19 (95 % of the images), two people
// 0.42 to 0.82 m apart at least 0.12 m and 0.2.
constexpr double kMaxExcess = 0.10;  // m, extent of the trunk less the distance of the peaks
constexpr double kMaxBeyond = 0.2;   // share of the surface on the side of a peak that is beyond it
constexpr double kMinAcross = 0.4;   // component of the line of the peaks across the view of the camera

}  // namespace

bool shareTrunk(const PlanView& plan, const PlanView::Place& a, const PlanView::Place& b, double top) {
  const double distance = (b - a).norm();
  if (distance > kPeaksOfOne) return false;
  const PlanView::Place along = (b - a) / distance, middle = 0.5 * (a + b);
  if (std::abs(along.x()) < kMinAcross) return false;
  const double reach = 0.5 * distance + kBodyRadius;
  // Area by the position along the line.
  constexpr double kBin = 0.01;  // m
  constexpr auto kBins = static_cast<std::size_t>((kPeaksOfOne + 2.0 * kBodyRadius) / kBin) + 2;
  std::array<double, kBins> area{};
  const auto first = static_cast<std::size_t>(kHipsAt * top / PlanView::kSlab);
  const auto last = static_cast<std::size_t>(kShouldersAt * top / PlanView::kSlab);
  double whole = 0.0;
  plan.around(middle, reach, [&](int i, double) {
    const double s = (PlanView::placeOf(i) - middle).dot(along);
    for (std::size_t slab = first; slab <= last; ++slab) {
      const auto part = static_cast<double>(plan.cell(i).area[slab]);
      area[static_cast<std::size_t>((s + reach) / kBin)] += part;
      whole += part;
    }
  });
  double from = 0.0, to = 0.0, sum = 0.0;  // m, along the line from the middle
  std::array<double, 2> side{}, beyond{};
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const double s = (static_cast<double>(bin) + 0.5) * kBin - reach;
    if (sum < kOutliers * whole) from = s;
    sum += area[bin];
    if (sum < (1.0 - kOutliers) * whole) to = s;
    const std::size_t k = s < 0.0 ? 0 : 1;
    side[k] += area[bin];
    if (std::abs(s) > 0.5 * distance) beyond[k] += area[bin];
  }
  return to - from < distance + kMaxExcess &&
         (beyond[0] < kMaxBeyond * side[0] || beyond[1] < kMaxBeyond * side[1]);
}

}  // namespace abstand::tracking
