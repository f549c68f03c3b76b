// Pose uncertainty of a pair in the direction of its nearest points.
#pragma once

#include "core/scene/scene.hpp"

namespace abstand::scene {

/// m: by how much the bodies of a pair may be nearer than `result.distance - result.bound`, at most
/// Scene::pairUncertainty(). `result` belongs to the current poses.
///
/// For any sets A and B and any unit vector n, their distance is at least min_A n . p - max_B n . p. If no
/// point of A or B is displaced along n by more than a and b, it remains at least that minus a + b. With n
/// from the nearest point of B to that of A, the minimum and maximum are those of the convex hulls
/// (SupportMap), a and b those of the ellipsoids. The bound is proven for bodies of any shape; it improves on
/// the radius where the hulls are about as far apart as the bodies. No allocation, no throw.
double directedUncertainty(const Scene& scene, PairId id, const query::PairResult& result);

/// m: largest displacement of a point of the object along the unit vector d.
double reachAlong(const Object& object, const Vector3d& d);

}  // namespace abstand::scene
