// Assignment by components and distance.
#include "tracking/depth/people/cell_owners.hpp"

#include "tracking/depth/people/body_area.hpp"

namespace abstand::tracking {
namespace {

constexpr double kArmReach = 1.0;  // from the middle of a body to the end of an arm
// Parts disconnected from their trunk in this view: those that do not stand on the floor (share of their
// surface below half a metre), such as arms and head of someone bowing towards the camera, or small ones
// (m^2), such as a foot.
constexpr double kMaxStanding = 0.1, kSmallPiece = 0.12, kPieceReach = 0.7;

}  // namespace

void assignCells(std::span<const std::optional<PlanView::Place>> people, PlanView& plan) {
  for (std::size_t k = 0; k < plan.components(); ++k) {
    const auto cells = plan.component(k);
    double whole = 0.0, standing = 0.0;
    for (const int i : cells) {
      const PlanView::Cell& c = plan.cell(i);
      whole += static_cast<double>(c.whole);
      standing += static_cast<double>(c.area[0] + c.area[1]);
    }
    const double piece = standing < kMaxStanding * whole ? kArmReach
                         : whole < kSmallPiece           ? kPieceReach
                                                         : 0.0;
    std::array<bool, kMaxOwners> has_trunk{};
    for (std::size_t p = 0; p < people.size(); ++p) {
      if (!people[p]) continue;
      double trunk = 0.0;
      for (const int i : cells)
        if ((PlanView::placeOf(i) - *people[p]).norm() < kBodyRadius)
          trunk += static_cast<double>(plan.cell(i).whole);
      has_trunk[p] = trunk >= 0.5 * kMinBody;
    }
    for (const int i : cells) {
      double nearest = kInfinity;
      for (std::size_t p = 0; p < people.size(); ++p) {
        if (!people[p]) continue;
        const double distance = (PlanView::placeOf(i) - *people[p]).norm();
        const double reach = has_trunk[p] ? kArmReach : piece;
        if (distance < std::min(nearest, reach)) {
          nearest = distance;
          plan.cell(i).owner = static_cast<std::int16_t>(p);
        }
      }
    }
  }
  // Cells with too little surface get the owner of a neighbour cell.
  for (const int i : plan.used()) {
    if (plan.occupied(i)) continue;
    plan.around(PlanView::placeOf(i), 1.5 * PlanView::kCell, [&](int beside, double) {
      if (plan.cell(beside).owner >= 0) plan.cell(i).owner = plan.cell(beside).owner;
    });
  }
}

}  // namespace abstand::tracking
