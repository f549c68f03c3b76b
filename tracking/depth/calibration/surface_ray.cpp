#include "tracking/depth/calibration/surface_ray.hpp"

#include <cmath>

namespace abstand::tracking {
namespace {

constexpr double kTouch = 1e-4;  // m; nearer than this the direction to the surface is not its normal
constexpr int kRaySteps = 20;

Vector3d slopeAt(const geometry::Surface& body, const Vector3d& p) {
  constexpr double kStep = 5e-4;  // m
  Vector3d slope;
  for (int k = 0; k < 3; ++k)
    slope[k] = body.signedDistance(p + kStep * Vector3d::Unit(k)) -
               body.signedDistance(p - kStep * Vector3d::Unit(k));
  return slope.norm() > 0.0 ? slope.normalized() : Vector3d(Vector3d::UnitZ());
}

}  // namespace

RayHit meet(const geometry::Surface& body, const Vector3d& p, const Vector3d& ray, double reach) {
  double t = -reach;
  for (int i = 0; i < kRaySteps && t < reach; ++i) {
    const Vector3d q = p + t * ray;
    const geometry::SurfacePoint found = body.closest(q);
    const double d = body.inside(q, found) ? -found.distance : found.distance;
    if (i == 0 && !(d > 0.0)) return {};
    const Vector3d n = std::abs(d) > kTouch ? Vector3d((q - found.point) / d) : slopeAt(body, q);
    const double slope = n.dot(ray);
    if (slope < -kFlat) {
      t -= d / slope;
      if (std::abs(d) < kTouch && t < reach) return {t, n};
    } else if (d > kTouch) {
      t += d;  // free, and further along the surface may face the camera
    } else {
      return {};
    }
  }
  return {};
}

}  // namespace abstand::tracking
