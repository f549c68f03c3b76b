// The rig's shapes as the depth fit sees them, and how far many points are from them.
#pragma once

#include <array>

#include "tracking/body/body_rig.hpp"
#include "tracking/tracker/body_observation.hpp"

namespace abstand::tracking {

/// One segment's surface: the points whose level is 1. An ellipsoid has the level |q|, q = p / semi; a drum,
/// round across and blunt along z, ((qx^2 + qy^2)^2 + qz^4)^(1/4). The trunk is two drums. A cuboid (foot)
/// counts as the ellipsoid of its size.
struct FitSurface {
  Vector3f centre{Vector3f::Zero()};  ///< in the segment's frame
  Vector3f semi{Vector3f::Ones()};    ///< m
  bool drum{false};

  /// The level of p (from the centre, axes of the segment), and its gradient.
  double level(const Vector3d& p, Vector3d& gradient) const;
};
using FitSurfaces = std::array<FitSurface, kRigSegments>;
FitSurfaces fitSurfaces(const BodyRig& rig);

/// Signed distance to first order, n the outward normal: d = (level - 1) / |gradient|; exact on the surface,
/// its sign exact everywhere.
struct SurfaceDistance {
  double d{0.0};
  Vector3d n{Vector3d::UnitZ()};
};

/// Of a point p_W that a camera at `eye` sees: where the nearest surface faces away from the camera, which
/// cannot be, the surface that faces it (the tangent plane at right angles to the view).
SurfaceDistance seenDistance(const FitSurface& s, const Transform& X_WS, const Vector3d& p_W,
                             const Vector3d& eye);

/// For every point |d| plus `normal_weight` (m) times (1 - n . normal of the point): how ill it fits to the
/// segment, into `score`.
void scoreOf(const FitSurface& s, const Transform& X_WS, const SeenPoints& points, float normal_weight,
             float* score);

}  // namespace abstand::tracking
