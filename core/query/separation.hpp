// Certified lower bounds of the distance of two bodies from what is cheap to know. Internal to the engine.
#pragma once

#include "core/query/placed_body.hpp"

namespace abstand::query {

/// m; of a plane between bodies within a million metres.
inline constexpr double kPlaneRounding = 1e-8;

/// The bodies lie on both sides of a slab of this width (m) across the unit vector n (from B to A, world
/// axes), so no two points of theirs are nearer; negative when their hulls overlap along n. Where the bodies
/// are convex about the nearest points and n points from one to the other, it is their distance.
/// `closely`: looks at all corners of hulls, to lose nothing but float rounding.
double separationAlong(const Vector3d& n, const PlacedBody& a, const PlacedBody& b, bool closely) noexcept;

/// No point of the body has moved by more (m) between two poses: the way of its bounding sphere's centre, and
/// the radius times the length of the longest chord of the rotation, 2 sin(angle / 2) = |R_1 - R_0|_F /
/// sqrt 2.
double mostMotion(const geometry::EnclosingSphere& bounding_sphere, const Transform& X_0,
                  const Transform& X_1) noexcept;

}  // namespace abstand::query
