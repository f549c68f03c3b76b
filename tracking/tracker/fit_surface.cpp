// Distances of single points to surfaces.
#include "tracking/tracker/fit_surface.hpp"

#include <cmath>

namespace abstand::tracking {

FitSurfaces fitSurfaces(const BodyRig& rig) {
  FitSurfaces surfaces;
  for (std::size_t i = 0; i < kRigSegments; ++i) {
    surfaces[i].centre = rig.parts[i].p_shape.cast<float>();
    const geometry::Bounds box = geometry::bounds(rig.parts[i].shape);
    surfaces[i].semi = (0.5 * box.extent()).cast<float>();
    surfaces[i].drum = i < 2;
  }
  return surfaces;
}

double FitSurface::level(const Vector3d& p, Vector3d& gradient) const {
  const Vector3d r = semi.cast<double>(), q = p.cwiseQuotient(r);
  if (!drum) {
    const double k = q.norm();
    gradient = q.cwiseQuotient(r) / std::max(k, 1e-9);
    return k;
  }
  const double round = q.x() * q.x() + q.y() * q.y(), flat = q.z() * q.z();
  const double k = std::sqrt(std::sqrt(round * round + flat * flat));
  gradient =
      Vector3d{round * q.x(), round * q.y(), flat * q.z()}.cwiseQuotient(r) / std::max(k * k * k, 1e-9);
  return k;
}

SurfaceDistance seenDistance(const FitSurface& s, const Transform& X_WS, const Transform& X_SW,
                             const Vector3d& p_W, const Vector3d& ray) {
  constexpr double kFacing = 0.05;  // cosine; flatter counts as visible
  const Vector3d p = X_SW * p_W - s.centre.cast<double>();
  const Vector3d view = X_WS.linear().transpose() * ray;
  Vector3d g;
  const double level = s.level(p, g), slope = g.norm();
  SurfaceDistance hit;
  if (slope > 1e-9 && g.dot(view) < kFacing * slope) {
    hit.n = g / slope;
    hit.d = (level - 1.0) / slope;
  } else {
    // For a drum, that of the inscribed ellipsoid.
    const Vector3d r = s.semi.cast<double>();
    const Vector3d front = -r.cwiseAbs2().cwiseProduct(view) / r.cwiseProduct(view).norm();
    hit.n = -view;
    hit.d = (p - front).dot(hit.n);
  }
  hit.n = X_WS.linear() * hit.n;
  return hit;
}

}  // namespace abstand::tracking
