#include "core/scene/directed_uncertainty.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::scene {
namespace {

constexpr double kNoDirection = 1e-9;  // m; nearest points that are closer do not determine a direction

/// m: upper bound of n . p over the body.
double supportOf(const Object& object, const Vector3d& n) {
  const Vector3d n_B = object.X_WB.linear().transpose() * n;
  return n.dot(object.X_WB.translation()) + object.spec.structure->support.closeUpper(n_B);
}

}  // namespace

double reachAlong(const Object& object, const Vector3d& d) {
  if (object.pose_ellipsoid.isZero(0.0)) return object.pose_uncertainty;
  const double reach =
      object.pose_age_uncertainty + std::sqrt(std::max(0.0, d.dot(object.pose_ellipsoid * d)));
  return std::min(reach, object.pose_uncertainty);
}

double directedUncertainty(const Scene& scene, PairId id, const query::PairResult& result) {
  const double radius = scene.pairUncertainty(id);
  const Pair& pair = scene.pairs()[id.index()];
  const Object &a = scene.object(pair.a), &b = scene.object(pair.b);
  if (a.pose_ellipsoid.isZero(0.0) && b.pose_ellipsoid.isZero(0.0)) return radius;
  const Vector3d away = result.witness_a - result.witness_b;
  const double length = away.norm();
  if (!std::isfinite(radius) || !(length > kNoDirection) || !(result.distance > 0.0)) return radius;
  const Vector3d n = away / length;
  const double separation = -supportOf(a, -n) - supportOf(b, n);
  const double nearest = separation - reachAlong(a, n) - reachAlong(b, n);
  const double directed = result.distance - result.bound - nearest;
  return directed < radius ? std::max(0.0, directed) : radius;
}

}  // namespace abstand::scene
