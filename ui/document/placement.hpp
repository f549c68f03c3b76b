// Where a person, a robot or an object stands instead of where the files say.
#pragma once

#include "core/math/transform.hpp"

namespace abstand::ui {

/// Pose in the world as in scene files. A person only turns about z.
struct Placement {
  Vector3d xyz{Vector3d::Zero()};  ///< m
  Vector3d rpy{Vector3d::Zero()};  ///< rad, about the fixed axes x, y and z, in this order

  Transform X_W() const { return fromXyzRpy(xyz, rpy); }
  bool operator==(const Placement& other) const { return xyz == other.xyz && rpy == other.rpy; }
};

}  // namespace abstand::ui
