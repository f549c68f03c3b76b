// Extents, and surface that moves.
#include "tracking/depth/people/crouched_people.hpp"

namespace abstand::tracking {
namespace {

// m: of people who squat, kneel with the head down, or bend to the floor. HeadlessPeople finds higher ones.
constexpr float kLowestCrouched = 0.45f, kHighestCrouched = 1.2f;
constexpr double kSmallestCrouched = 0.2;                          // m^2 of visible surface
constexpr double kShortestCrouched = 0.3, kLongestCrouched = 1.5;  // m, diagonal
// Shares of the surface: what has settled of a body that moves as a whole, and of one whose drift is known.
constexpr double kMaxSettled = 0.5, kMinSettled = 0.25;
// m, 1/m: drift (root mean square over the cells, which mean over their pixels) of a person at a distance z:
// kSmallestDrift + kDriftNoise z^2, twice that of things or more.
constexpr double kSmallestDrift = 0.002, kDriftNoise = 0.0004;

}  // namespace

CrouchedPeople::Body CrouchedPeople::bodyOf(const PlanView& plan, std::span<const int> cells) {
  using Place = PlanView::Place;
  double area = 0.0, settled = 0.0, known_drift = 0.0, squares = 0.0;
  float top = 0.0f;
  Place sum = Place::Zero(), low = Place::Constant(kInfinity), high = -low;
  for (const int i : cells) {
    const PlanView::Cell& cell = plan.cell(i);
    if (cell.beside_known) return {};
    const Place place = PlanView::placeOf(i);
    const auto cell_area = static_cast<double>(cell.whole), cell_settled = static_cast<double>(cell.settled);
    area += cell_area;
    settled += cell_settled;
    if (cell_settled > 0.5 * cell_area) {
      const auto drift = static_cast<double>(cell.drift);
      known_drift += cell_settled;
      squares += drift * drift / cell_settled;
    }
    sum += cell_area * place;
    top = std::max(top, cell.top);
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  const double longest = (high - low).norm();
  if (top < kLowestCrouched || top >= kHighestCrouched || area < kSmallestCrouched ||
      longest < kShortestCrouched || longest > kLongestCrouched)
    return {};
  Body body;
  body.middle = sum / area;
  body.unsettled = settled <= kMaxSettled * area;
  const double smallest = kSmallestDrift + kDriftNoise * body.middle.squaredNorm();
  body.drifts = known_drift >= kMinSettled * area && squares >= smallest * smallest * known_drift;
  return body;
}

}  // namespace abstand::tracking
