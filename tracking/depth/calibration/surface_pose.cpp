// Camera pose from depth images of bodies with known surfaces and poses.
#include "tracking/depth/calibration/surface_pose.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "tracking/depth/calibration/refuse.hpp"
#include "tracking/depth/calibration/surface_rows.hpp"

namespace abstand::tracking {
namespace {

constexpr double kMinPoints = 150.0;
constexpr double kMinExplained = 0.5;
constexpr double kMinConstraint = 1e-3;     // smallest constraint of a dof, as a share of all rows
constexpr std::size_t kMaxPixels = 100000;  // evaluated in all views together
constexpr std::size_t kEvery = 5;           // uses every kEvery-th point until the best start is known
constexpr double kAgree = 0.6;              // smallest cosine between the normals of image and surface
constexpr double kFlat = 0.25;              // cosine to the ray; flatter surfaces are not measured accurately
constexpr double kFirstGate = 0.06, kLastGate = 0.025;  // m
constexpr int kSteps = 25;
constexpr double kSmallSurfaceStep = 1e-6;
constexpr double kTouch = 1e-4;  // m; nearer than this the direction to the surface is not its normal
constexpr std::size_t kStarts = 4;
constexpr double kLastTolerance = 0.02;  // m, of the cost that selects among the results of the starts

struct Measured {
  Vector3d p_C, n_C;
  std::size_t view;
};

/// Points with normals where the image is smooth, on a grid that limits their number.
std::vector<Measured> measuredPoints(const DepthCamera& camera, std::span<const SurfaceView> views) {
  std::vector<Measured> points;
  const std::size_t pixels = static_cast<std::size_t>(camera.width * camera.height) * views.size();
  const int step = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(pixels) / kMaxPixels)));
  const int beside = std::max(1, camera.width / 320);
  for (std::size_t k = 0; k < views.size(); ++k) {
    const DepthImage& image = views[k].image;
    const auto at = [&](int u, int v) { return camera.at(u, v, static_cast<double>(image.at(u, v))); };
    for (int v = beside; v + beside < image.height; v += step)
      for (int u = beside; u + beside < image.width; u += step) {
        const Vector3d p = at(u, v), left = at(u - beside, v), right = at(u + beside, v);
        const Vector3d above = at(u, v - beside), below = at(u, v + beside);
        const double max_step = 0.015 + 0.01 * p.z() * p.z();
        bool smooth = p.z() > 0.0;
        for (const Vector3d* q : {&left, &right, &above, &below})
          smooth = smooth && q->z() > 0.0 && std::abs(q->z() - p.z()) < max_step;
        if (!smooth) continue;
        const Vector3d n = (below - above).cross(right - left);
        const double cosine = -n.dot(p) / (n.norm() * p.norm());
        // The negated form also rejects NaN.
        if (!(std::abs(cosine) > kFlat)) continue;
        points.push_back({p, (cosine > 0.0 ? 1.0 : -1.0) * n.normalized(), k});
      }
  }
  return points;
}

/// Distance (m) from p to a box; 0 inside.
double distanceToBox(const geometry::Bounds& box, const Vector3d& p) {
  return (box.lower - p).cwiseMax(p - box.upper).cwiseMax(0.0).norm();
}

class Fit {
 public:
  Fit(const DepthCamera& camera, std::span<const geometry::Surface* const> bodies,
      std::span<const SurfaceView> views)
      : bodies_(bodies), views_(views), points_(measuredPoints(camera, views)) {
    for (const geometry::Surface* body : bodies) boxes_.push_back(body->bounds());
  }

  /// Over every `stride`-th point.
  SurfaceSum at(const Transform& X_WC, double gate, std::size_t stride) const {
    std::vector<SurfaceRow> rows;
    for (std::size_t i = 0; i < points_.size(); i += stride) {
      const Measured& m = points_[i];
      SurfaceRow row;
      row.p_W = X_WC * m.p_C;
      if (nearest(X_WC.linear() * m.n_C, m.view, gate, row)) rows.push_back(row);
    }
    return sumOf(rows);
  }

  /// Gauss-Newton result; from a `rough` start with a gate that shrinks.
  Transform from(Transform X_WC, bool rough) const {
    for (int i = rough ? 0 : kSteps / 2; i < kSteps; ++i) {
      const double part = std::min(1.0, static_cast<double>(i) / (0.5 * kSteps));
      const SurfaceSum sum = at(X_WC, kFirstGate + part * (kLastGate - kFirstGate), rough ? kEvery : 1);
      if (!(sum.weights > 6.0)) return X_WC;
      const std::optional<Vector6d> step = stepOf(sum);
      if (!step) return X_WC;
      X_WC = movedAbout(sum.middle, X_WC, *step);
      if (part == 1.0 && step->norm() < kSmallSurfaceStep) break;
    }
    return X_WC;
  }

 private:
  /// Completes the row by the surface within `gate` of its point with a consistent normal.
  bool nearest(const Vector3d& n_image, std::size_t view, double gate, SurfaceRow& row) const {
    const Vector3d& p_W = row.p_W;
    double best = gate;
    std::size_t body = bodies_.size();
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const Vector3d p_B = views_[view].X_WB[b].inverse() * p_W;
      if (distanceToBox(boxes_[b], p_B) >= best) continue;
      const geometry::SurfacePoint found = bodies_[b]->closest(p_B);
      if (found.distance >= best) continue;
      best = found.distance;
      body = b;
    }
    if (body == bodies_.size()) return false;
    const Transform& X_WB = views_[view].X_WB[body];
    const Vector3d p_B = X_WB.inverse() * p_W;
    const geometry::SurfacePoint found = bodies_[body]->closest(p_B);
    row.distance = bodies_[body]->inside(p_B, found) ? -found.distance : found.distance;
    const Vector3d n_B = std::abs(row.distance) > kTouch ? Vector3d((p_B - found.point) / row.distance)
                                                         : slopeAt(*bodies_[body], p_B);
    row.n_W = X_WB.linear() * n_B;
    return row.n_W.dot(n_image) > kAgree;
  }

  static Vector3d slopeAt(const geometry::Surface& body, const Vector3d& p) {
    constexpr double kStep = 5e-4;  // m
    Vector3d slope;
    for (int k = 0; k < 3; ++k)
      slope[k] = body.signedDistance(p + kStep * Vector3d::Unit(k)) -
                 body.signedDistance(p - kStep * Vector3d::Unit(k));
    return slope.norm() > 0.0 ? slope.normalized() : Vector3d(Vector3d::UnitZ());
  }

  std::span<const geometry::Surface* const> bodies_;
  std::span<const SurfaceView> views_;
  std::vector<Measured> points_;
  std::vector<geometry::Bounds> boxes_;
};

}  // namespace

SurfaceFit fitPoseToSurfaces(const DepthCamera& camera, std::span<const geometry::Surface* const> bodies,
                             std::span<const SurfaceView> views, std::uint64_t seed) {
  ABSTAND_CHECK(!bodies.empty() && !views.empty() && camera.distortion.isZero(0.0));
  SurfaceSearch search(camera, bodies, views, seed);
  const Fit fit(camera, bodies, views);
  SurfaceFit best;
  double smallest_cost = kInfinity;
  for (const Transform& start : search.search(kStarts)) {
    const Transform end = fit.from(start, true);
    const double cost = search.cost(end, kLastTolerance);
    if (cost >= smallest_cost) continue;
    smallest_cost = cost;
    best.X_WC = end;
  }
  best.X_WC = fit.from(best.X_WC, false);
  const SurfaceSum sum = fit.at(best.X_WC, kLastGate, 1);
  best.points = static_cast<std::size_t>(sum.weights);
  if (!(sum.weights >= kMinPoints))
    refuse(
        "--links: found %zu points on the robot, expected %.0f or more: it is not visible, or the camera's "
        "start "
        "is more than 0.1 m or 10 degrees off",
        best.points, kMinPoints);
  best.explained = search.explained(best.X_WC);
  if (!(best.explained >= kMinExplained))
    refuse(
        "--links: found %.0f %% of the visible robot surface, expected half or more: its joint values are "
        "wrong, or the camera's start is more than 0.1 m or 10 degrees off",
        100.0 * best.explained);
  if (!(weakestConstraint(sum.JTJ / sum.weights) >= kMinConstraint))
    throw UsageError(
        "--links: found surfaces that do not determine every degree of freedom of the camera, as a sphere "
        "does, expected links "
        "that "
        "point to different sides");
  const double sigma2 = sum.squares / (sum.weights - 6.0);
  best.rms = std::sqrt(sigma2);
  best.spread = std::hypot(best.rms, spreadAt(sigma2 * sum.JTJ.inverse(), kUsedWithin));
  const Transform moved = camera.X_WC.inverse() * best.X_WC;
  best.moved = moved.translation().norm();
  best.turned = Eigen::AngleAxisd(moved.linear()).angle();
  return best;
}

}  // namespace abstand::tracking
