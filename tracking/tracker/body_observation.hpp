// Observation of one person at one moment by one or several depth cameras.
#pragma once

#include "tracking/body/body_rig.hpp"
#include "tracking/tracker/body_view.hpp"

namespace abstand::tracking {

/// One person at one moment: a view for each camera that sees the person, and the points of all of them.
/// update() allocates nothing after the first images of a size.
class BodyObservation {
 public:
  static constexpr std::size_t kMaxViews = 4;

  /// `cells`: largest number of grid cells of the person in each view; determines the grids' steps in pixels.
  explicit BodyObservation(std::size_t cells = 1200) : max_cells_{cells} {}

  /// `images`: at most kMaxViews, further ones are ignored; from the same moment, in one world.
  void update(std::span<const PersonImage> images);

  /// Applies markStanding() to the points until the next update().
  void markStanding();
  void unmarkStanding();

  /// If the person of this pose sits: moves the points of the seat from points() to seat()
  /// (moveSeatPoints()). Returns whether there are any.
  bool setSeatAside(const BodyRig& rig, const RigPlacement& X_WS);

  const SeenPoints& points() const { return points_; }
  /// Points that belong to no person; empty after update().
  const SeenPoints& seat() const { return seat_; }
  std::span<const BodyView> views() const { return {views_.data(), count_}; }
  /// Position (m, world) of the camera that saw a point.
  const Vector3d& eyeOf(std::size_t point) const { return views_[points_.view[point]].eye(); }

 private:
  std::size_t max_cells_;
  std::array<BodyView, kMaxViews> views_;
  std::size_t count_{0};
  SeenPoints points_, seat_;
};

}  // namespace abstand::tracking
