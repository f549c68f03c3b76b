// Fast certified lower bounds of the distance of two bodies.
#include "core/query/separation.hpp"

namespace abstand::query {

double separationAlong(const Vector3d& n, const PlacedBody& a, const PlacedBody& b, bool closely) noexcept {
  const Vector3d towards_b = a.X_WB.linear().transpose() * -n, towards_a = b.X_WB.linear().transpose() * n;
  const double apart = n.dot(a.X_WB.translation() - b.X_WB.translation());
  return closely ? apart - a.body.support.closeUpper(towards_b) - b.body.support.closeUpper(towards_a)
                 : apart - a.body.support.upper(towards_b) - b.body.support.upper(towards_a);
}

double maxDisplacement(const geometry::EnclosingSphere& bounding_sphere, const Transform& X_0,
                       const Transform& X_1) noexcept {
  const Vector3d displacement = X_1 * bounding_sphere.centre - X_0 * bounding_sphere.centre;
  const double chord = (X_1.linear() - X_0.linear()).norm() / std::numbers::sqrt2;
  return displacement.norm() + bounding_sphere.radius * chord;
}

}  // namespace abstand::query
