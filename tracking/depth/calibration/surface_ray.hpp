// Where the ray of a measured point meets a known surface.
#pragma once

#include "core/geometry/surface.hpp"

namespace abstand::tracking {

struct RayHit {
  double t{kInfinity};           ///< m, along the ray from the point: negative before it; infinite: no hit
  Vector3d n{Vector3d::Zero()};  ///< unit, outward normal of the surface
};

/// First point that faces the camera on the line p + t ray with |t| < `reach` (m), in the frame of the body;
/// `ray` is a unit vector away from the camera. Newton's method on the signed distance from outside: the
/// distance from a convex body is convex along a line, so the steps never pass its surface. No hit if the
/// line starts inside, and on surfaces flatter than kFlat.
RayHit meet(const geometry::Surface& body, const Vector3d& p, const Vector3d& ray, double reach);

/// Smallest cosine between a ray and the normal of a surface that is used: what is seen along the surface
/// determines a block that is seen from nearly ahead.
inline constexpr double kFlat = 0.05;

}  // namespace abstand::tracking
