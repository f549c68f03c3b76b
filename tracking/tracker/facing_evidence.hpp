// What one image says about the facing direction of a body.
#pragma once

#include "tracking/tracker/body_tracker.hpp"

namespace abstand::tracking {

/// How well a body explains an image: all of it, and at the feet, which point forward.
struct FacingEvidence {
  static constexpr double kLow = 0.2;  ///< m above the floor: feet and ankles

  double cost{kNaN};         ///< m^2, Misfit::cost
  double low_points{0.0};    ///< number of points below kLow
  double low_cost{0.0};      ///< m^2, sum of their robust squares
  double empty_cost{0.0};    ///< m^2, DepthFit::placeCost of the feet: toes in empty space
  bool kneels{false};        ///< a knee is on the floor: the toes point backwards
  bool shows_little{false};  ///< neither the head nor the feet, or a bent person

  double distance{0.0};                   ///< m, of the pelvis from the nearest camera
  Vector3d p_WP{Vector3d::Zero()};        ///< m, the pelvis
  Vector3d forward_W{Vector3d::UnitX()};  ///< unit, level: facing direction
};

/// Of the image that the tracker saw last. World: the floor is z = 0. No allocation, no throw.
FacingEvidence facingEvidence(const BodyTracker& tracker);

}  // namespace abstand::tracking
