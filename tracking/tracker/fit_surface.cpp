// Distances to surfaces, for single points and in batches.
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

SurfaceDistance seenDistance(const FitSurface& s, const Transform& X_WS, const Vector3d& p_W,
                             const Vector3d& eye) {
  constexpr double kFacing = 0.05;  // cosine; flatter counts as visible
  const Vector3d p = X_WS.inverse() * p_W - s.centre.cast<double>();
  const Vector3d view = X_WS.linear().transpose() * (p_W - eye).normalized();
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

namespace {

/// scoreOf() with the kind of surface as a template parameter, so that the loop has no branch.
template <bool kDrum>
void scoreAs(const FitSurface& s, const Transform& X_WS, const SeenPoints& points, float normal_weight,
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
    const float round = qa * qa + qb * qb, flat = qc * qc;
    const float level = kDrum ? std::sqrt(std::sqrt(round * round + flat * flat)) : std::sqrt(round + flat);
    // Gradient times level^3 (drum) or level.
    const float ga = (kDrum ? round * qa : qa) * ia, gb = (kDrum ? round * qb : qb) * ib,
                gc = (kDrum ? flat * qc : qc) * ic;
    const float scale = kDrum ? level * level * level : level;
    const float inverse = 1.0f / (std::sqrt(ga * ga + gb * gb + gc * gc) + 1e-9f);
    const float nx = points.nx[i], ny = points.ny[i], nz = points.nz[i];
    const float along = ((r00 * nx + r10 * ny + r20 * nz) * ga + (r01 * nx + r11 * ny + r21 * nz) * gb +
                         (r02 * nx + r12 * ny + r22 * nz) * gc) *
                        inverse;
    score[i] = std::abs((level - 1.0f) * scale * inverse) + normal_weight * (1.0f - along);
  }
}

}  // namespace

void scoreOf(const FitSurface& s, const Transform& X_WS, const SeenPoints& points, float normal_weight,
             float* score) {
  (s.drum ? scoreAs<true> : scoreAs<false>)(s, X_WS, points, normal_weight, score);
}

}  // namespace abstand::tracking
