#include "tracking/tracker/body_observation.hpp"

#include <algorithm>

#include "tracking/tracker/seat_points.hpp"
#include "tracking/tracker/standing_columns.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kFullViews = 2;  // with more views each has fewer cells, so that the fit stays as fast

}  // namespace

void BodyObservation::update(std::span<const PersonImage> images) {
  count_ = std::min(images.size(), kMaxViews);
  const std::size_t cells = count_ > kFullViews ? max_cells_ * kFullViews / count_ : max_cells_;
  points_.count = seat_.count = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    views_[i].update(images[i], cells);
    views_[i].appendPoints(static_cast<std::uint8_t>(i), points_);
  }
}

void BodyObservation::markStanding() { tracking::markStanding(points_); }

bool BodyObservation::setSeatAside(const BodyRig& rig, const RigPlacement& X_WS) {
  return sitsOnSeat(rig, X_WS) && moveSeatPoints(rig, X_WS, points_, seat_) > 0;
}

void BodyObservation::unmarkStanding() { std::fill_n(points_.no_arm.begin(), points_.count, 0.0f); }

}  // namespace abstand::tracking
