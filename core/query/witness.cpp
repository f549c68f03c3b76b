#include "core/query/witness.hpp"

#include <algorithm>

namespace abstand::query {
namespace {

constexpr int kProjections = 8;                // more alternating projections gain little
constexpr int kDepthSteps = 6;                 // halvings of the step inside
constexpr double kMinStep = 0.2;               // share of the first step
constexpr double kMinSlope = 0.03;             // smallest slope of the depth along the surface for a step
constexpr double kMinSlopeAtMedialAxis = 0.2;  // the same if the field showed none
constexpr double kConverged = 1e-6;            // m: smaller gains are not worth a query
constexpr double kConvergedShare = 1e-3;  // the same as a share of the distance; the reported bound covers it
constexpr double kDepthShare = 0.002;     // share of the depth, for steps by the field

/// Projections onto the two surfaces, in the frame F; keeps the last location as a hint.
class Surfaces {
 public:
  Surfaces(const geometry::Surface& points, const geometry::Surface& field, const Transform& X_FP, Witness& w)
      : points_(points), field_(field), X_FP_(X_FP), X_PF_(X_FP.inverse()), w_(w) {}

  Vector3d toPoints(const Vector3d& p_F) {
    const geometry::SurfacePoint s = points_.closest(X_PF_ * p_F, w_.hint_points);
    w_.hint_points = s.hint;
    return X_FP_ * s.point;
  }
  Vector3d toField(const Vector3d& p_F) {
    const geometry::SurfacePoint s = field_.closest(p_F, w_.hint_field);
    w_.hint_field = s.hint;
    return s.point;
  }
  /// Nearest point of p_F on F, and whether p_F is inside of F.
  Vector3d toField(const Vector3d& p_F, bool& inside) {
    const geometry::SurfacePoint s = field_.closest(p_F, w_.hint_field);
    w_.hint_field = s.hint;
    inside = field_.inside(p_F, s);
    return s.point;
  }
  /// Moves both points to the nearest points of their two triangles.
  void slide() {
    geometry::TriangleCorners a, b;
    if (!points_.triangle(w_.hint_points, a) || !field_.triangle(w_.hint_field, b)) return;
    for (Vector3d& corner : a) corner = X_FP_ * corner;
    const geometry::NearestPair nearest = geometry::nearestPoints(a, b);
    if (!(nearest.distance < w_.distance)) return;
    w_.on_points = nearest.on_a;
    w_.on_field = nearest.on_b;
    w_.distance = nearest.distance;
  }

 private:
  const geometry::Surface& points_;
  const geometry::Surface& field_;
  Transform X_FP_, X_PF_;
  Witness& w_;
};

void set(Witness& w, const Vector3d& p, const Vector3d& q, double distance) {
  w.on_points = p;
  w.on_field = q;
  w.distance = distance;
}

void approach(Surfaces& surfaces, Witness& w) {
  for (int i = 0; i < kProjections; ++i) {
    surfaces.slide();
    const Vector3d p = surfaces.toPoints(w.on_field);
    const Vector3d q = surfaces.toField(p);
    const double d = (p - q).norm();
    const double gain = w.distance - d;
    if (gain <= 0.0) return;
    set(w, p, q, d);
    if (gain < std::max(kConverged, kConvergedShare * d)) return;
  }
}

void increaseDepth(Surfaces& surfaces, Witness& w, double step) {
  for (int i = 0; i < kDepthSteps; ++i) {
    const double depth = -w.distance;
    if (depth < 1e-12) return;
    const Vector3d inward = (w.on_points - w.on_field) / depth;
    const Vector3d p = surfaces.toPoints(w.on_points + step * inward);
    bool inside;
    const Vector3d q = surfaces.toField(p, inside);
    const double deeper = (p - q).norm();
    if (deeper > depth && inside) {
      const double gain = deeper - depth;
      set(w, p, q, -deeper);
      if (gain < kConverged) return;
    } else {
      step *= 0.5;
    }
  }
}

/// Moves to a deeper point of P's surface near p, as deep as the samples of the near field show. `normal`: of
/// P's surface there, unit, in F's axes.
Vector3d descendInField(Surfaces& surfaces, const field::NearField& near, Vector3d p, const Vector3d& normal,
                        double step) {
  float s, gradient[3];
  const auto at = [&](const Vector3d& q) {
    const Vector3f f = q.cast<float>();
    return near.sampleGradient(f.x(), f.y(), f.z(), s, gradient) && s < 0.0f;
  };
  if (!at(p)) return p;
  float deepest = s;
  Vector3d down = -Vector3d(gradient[0], gradient[1], gradient[2]);
  const double min_step = kMinStep * step;
  while (step > min_step) {
    // Tangential component: only motion along the surface counts.
    const Vector3d along = down - normal * normal.dot(down);
    const double slope = along.norm();
    if (!(slope > kMinSlope * down.norm())) return p;
    const Vector3d next = surfaces.toPoints(p + (step / slope) * along);
    if (at(next) && s < deepest) {
      const double gain = deepest - s;
      p = next;
      deepest = s;
      down = -Vector3d(gradient[0], gradient[1], gradient[2]);
      if (gain < kDepthShare * -deepest) return p;
    } else {
      step *= 0.5;
    }
  }
  return p;
}

}  // namespace

Witness refineWitness(const structure::HapticStructure& P, const structure::HapticStructure& F,
                      const Transform& X_FP, const WitnessStart& start) noexcept {
  const field::NearField* const near = structure::nearField(F);
  Witness w;
  w.hint_field = start.hint;
  Surfaces surfaces(*P.surface, *F.surface, X_FP, w);
  bool inside;
  const Vector3d p =
      near ? descendInField(surfaces, *near, start.point, start.normal, start.step) : start.point;
  const Vector3d q = surfaces.toField(p, inside);
  set(w, p, q, (p - q).norm());
  if (inside) {
    w.distance = -w.distance;
    // At a medial axis several directions out are equally short and the field is too coarse for a gradient.
    const Vector3d inward = (p - q).normalized();
    if (!near || (inward - start.normal * start.normal.dot(inward)).norm() > kMinSlopeAtMedialAxis)
      increaseDepth(surfaces, w, start.step);
  } else {
    approach(surfaces, w);
  }
  return w;
}

Witness footWitness(const geometry::Surface& field, const Vector3d& start, std::uint32_t hint,
                    double max_distance) noexcept {
  geometry::SurfacePoint foot = field.nearby(start, hint);
  if (foot.distance > max_distance) foot = field.closest(start, foot.hint);
  return {start, foot.point, foot.distance, geometry::kNoHint, foot.hint};
}

void slideWitness(const geometry::Surface& points, const geometry::Surface& field, const Transform& X_FP,
                  Witness& w) noexcept {
  Surfaces(points, field, X_FP, w).slide();
}

bool projectWitness(const geometry::Surface& points, const geometry::Surface& field, const Transform& X_FP,
                    Witness& w) noexcept {
  const Transform X_PF = X_FP.inverse();
  if (w.hint_points == geometry::kNoHint && !points.shape())
    w.hint_points = points.closest(X_PF * w.on_points).hint;
  if (w.hint_field == geometry::kNoHint && !field.shape()) w.hint_field = field.closest(w.on_field).hint;
  const geometry::SurfacePoint on_points = points.nearby(X_PF * w.on_field, w.hint_points);
  const Vector3d p = X_FP * on_points.point;
  const geometry::SurfacePoint on_field = field.nearby(p, w.hint_field);
  const double gain = w.distance - on_field.distance;
  if (!(gain > 0.0)) return false;
  set(w, p, on_field.point, on_field.distance);
  w.hint_points = on_points.hint;
  w.hint_field = on_field.hint;
  return gain >= std::max(kConverged, kConvergedShare * w.distance);
}

void convergeWitness(const geometry::Surface& points, const geometry::Surface& field, const Transform& X_FP,
                     Witness& w) noexcept {
  Surfaces surfaces(points, field, X_FP, w);
  approach(surfaces, w);
}

}  // namespace abstand::query
