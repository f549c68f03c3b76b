// Distances to ellipsoids, one by one and many at once.
#include "tracking/tracker/fit_surface.hpp"

#include <cmath>

namespace abstand {

FitSurfaces fitSurfaces(const BodyRig& rig) {
  FitSurfaces surfaces;
  for (std::size_t i = 0; i < kRigSegments; ++i) {
    surfaces[i].centre = rig.parts[i].p_shape.cast<float>();
    const Bounds box = bounds(rig.parts[i].shape);
    surfaces[i].semi = (0.5 * box.extent()).cast<float>();
  }
  return surfaces;
}

SurfaceDistance seenDistance(const FitSurface& s, const Transform& X_WS, const Vector3d& p_W,
                             const Vector3d& eye) {
  constexpr double kFacing = 0.05;  // cosine; flatter counts as seen
  const Vector3d r = s.semi.cast<double>();
  const Vector3d p = X_WS.inverse() * p_W - s.centre.cast<double>();
  const Vector3d view = X_WS.linear().transpose() * (p_W - eye).normalized();
  const Vector3d q = p.cwiseQuotient(r), g = q.cwiseQuotient(r);
  const double level = q.norm(), slope = g.norm();
  SurfaceDistance hit;
  if (slope > 1e-9 && g.dot(view) < kFacing * slope) {
    hit.n = g / slope;
    hit.d = level * (level - 1.0) / slope;
  } else {
    const Vector3d front = -r.cwiseAbs2().cwiseProduct(view) / r.cwiseProduct(view).norm();
    hit.n = -view;
    hit.d = (p - front).dot(hit.n);
  }
  hit.n = X_WS.linear() * hit.n;
  return hit;
}

void scoreOf(const FitSurface& s, const Transform& X_WS, const SeenPoints& points, float normal_weight,
             float* score) {
  const Eigen::Matrix3f R = X_WS.linear().cast<float>();
  const Vector3f c = (X_WS * s.centre.cast<double>()).cast<float>();
  const float r00 = R(0, 0), r10 = R(1, 0), r20 = R(2, 0);
  const float r01 = R(0, 1), r11 = R(1, 1), r21 = R(2, 1);
  const float r02 = R(0, 2), r12 = R(1, 2), r22 = R(2, 2);
  const float ia = 1.0f / s.semi.x(), ib = 1.0f / s.semi.y(), ic = 1.0f / s.semi.z();
  for (std::size_t i = 0; i < points.count; ++i) {
    const float x = points.x[i] - c.x(), y = points.y[i] - c.y(), z = points.z[i] - c.z();
    const float qa = (r00 * x + r10 * y + r20 * z) * ia, qb = (r01 * x + r11 * y + r21 * z) * ib,
                qc = (r02 * x + r12 * y + r22 * z) * ic;
    const float ga = qa * ia, gb = qb * ib, gc = qc * ic;
    const float level = std::sqrt(qa * qa + qb * qb + qc * qc);
    const float inverse = 1.0f / (std::sqrt(ga * ga + gb * gb + gc * gc) + 1e-9f);
    const float nx = points.nx[i], ny = points.ny[i], nz = points.nz[i];
    const float along = ((r00 * nx + r10 * ny + r20 * nz) * ga + (r01 * nx + r11 * ny + r21 * nz) * gb +
                         (r02 * nx + r12 * ny + r22 * nz) * gc) *
                        inverse;
    score[i] = std::abs(level * (level - 1.0f) * inverse) + normal_weight * (1.0f - along);
  }
}

}  // namespace abstand
