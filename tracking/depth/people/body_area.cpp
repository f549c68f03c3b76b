// Sums over the cells around a place.
#include "tracking/depth/people/body_area.hpp"

namespace abstand::tracking {

double bodyArea(const PlanView& plan, const PlanView::Place& place, double radius) {
  double area = 0.0;
  plan.around(place, radius, [&](int i, double) { area += static_cast<double>(plan.cell(i).whole); });
  return area;
}

PlanView::Place middleOfBody(const PlanView& plan, PlanView::Place place) {
  for (int round = 0; round < 2; ++round) {
    PlanView::Place sum = PlanView::Place::Zero();
    double area = 0.0;
    plan.around(place, kBodyRadius, [&](int i, double) {
      const auto a = static_cast<double>(plan.cell(i).whole);
      sum += a * PlanView::placeOf(i);
      area += a;
    });
    if (area > 0.0) place = sum / area;
  }
  return place;
}

}  // namespace abstand::tracking
