// Line between two joints.
#pragma once

#include <algorithm>

#include "core/math/transform.hpp"

namespace abstand::tracking {

/// From one joint to the next (m).
struct Bone {
  Vector3d from, to;

  double distanceTo(const Vector3d& p) const {
    const Vector3d along = to - from;
    const double share = std::clamp((p - from).dot(along) / std::max(along.squaredNorm(), 1e-9), 0.0, 1.0);
    return (p - from - share * along).norm();
  }
};

}  // namespace abstand::tracking
