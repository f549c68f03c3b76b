// Surfaces of the rig for the depth fit, and distances to them.
#pragma once

#include <array>

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// Surface of one segment: the points with level 1. Ellipsoid: level |q|, q = p / semi; drum, round across
/// and blunt along z: ((qx^2 + qy^2)^2 + qz^4)^(1/4). The trunk is two drums. A cuboid (foot) is approximated
/// by the ellipsoid of its size.
struct FitSurface {
  Vector3f centre{Vector3f::Zero()};  ///< in the segment's frame
  Vector3f semi{Vector3f::Ones()};    ///< m
  bool drum{false};

  /// Level of p (relative to the centre, axes of the segment), and its gradient.
  double level(const Vector3d& p, Vector3d& gradient) const;
};
using FitSurfaces = std::array<FitSurface, kRigSegments>;
FitSurfaces fitSurfaces(const BodyRig& rig);

/// Signed distance to first order, n the outward normal: d = (level - 1) / |gradient|; exact on the surface,
/// with the exact sign everywhere.
struct SurfaceDistance {
  double d{0.0};
  Vector3d n{Vector3d::UnitZ()};
};

/// For a point p_W seen by a camera along `ray` (unit, from the camera, world): if the nearest surface faces
/// away from the camera, which is impossible, the surface that faces it (the tangent plane perpendicular to
/// the view) is used. X_SW is the inverse of X_WS.
SurfaceDistance seenDistance(const FitSurface& s, const Transform& X_WS, const Transform& X_SW,
                             const Vector3d& p_W, const Vector3d& ray);

}  // namespace abstand::tracking
