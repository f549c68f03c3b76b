// Fast certified lower bounds of the distance of two bodies. Internal to the engine.
#pragma once

#include "core/query/placed_body.hpp"

namespace abstand::query {

/// m; rounding of a separating plane, for bodies within a million metres.
inline constexpr double kPlaneRounding = 1e-8;

/// Width (m) of the slab across the unit vector n (from B to A, world axes) that separates the hulls;
/// negative if they overlap along n. Lower bound of the distance; equal to it if the bodies are convex near
/// the witness points and n is parallel to their line. `closely`: evaluates all hull vertices, exact up to
/// float rounding.
double separationAlong(const Vector3d& n, const PlacedBody& a, const PlacedBody& b, bool closely) noexcept;

/// Motion bound (m) of the body between two poses: the displacement of its bounding sphere's centre, plus the
/// radius times the longest chord of the rotation, 2 sin(angle / 2) = |R_1 - R_0|_F / sqrt 2.
double maxDisplacement(const geometry::EnclosingSphere& bounding_sphere, const Transform& X_0,
                       const Transform& X_1) noexcept;

}  // namespace abstand::query
