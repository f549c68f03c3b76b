// Camera pose from depth images of bodies with known surfaces and poses.
#include "tracking/depth/calibration/surface_pose.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "tracking/depth/calibration/depth_noise.hpp"
#include "tracking/depth/calibration/refuse.hpp"
#include "tracking/depth/calibration/surface_ray.hpp"
#include "tracking/depth/calibration/surface_rows.hpp"

namespace abstand::tracking {
namespace {

constexpr double kMinPoints = 150.0;
constexpr double kMinExplained = 0.5;
constexpr double kMinConstraint = 1e-3;     // smallest constraint of a dof, as a share of all rows
constexpr double kMaxSpread = 0.1;          // m, the error that a start may have
constexpr std::size_t kMaxPixels = 100000;  // evaluated in all views together, until the best start is known
constexpr std::size_t kEvery = 5;           // uses every kEvery-th point until then
constexpr double kLastPoints = 6000.0;      // on the bodies, in all views together, afterwards
constexpr double kFirstGate = 0.06, kLastGate = 0.025;  // m, at least
constexpr double kGateNoise = 3.0;                      // gate in standard deviations of the depth
constexpr double kBesideBodies = 0.1;                   // m, of points that may belong to the bodies
constexpr int kSteps = 25;
constexpr double kSmallSurfaceStep = 1e-6;
constexpr std::size_t kStarts = 4;
constexpr double kLastTolerance = 0.02;  // m, of the cost that selects among the results of the starts

struct Measured {
  Vector3d p_C;
  double noise;  ///< m, standard deviation of the depth
  std::size_t view;
};

/// Every `step`-th pixel of each row and column.
std::vector<Measured> measuredPoints(const DepthCamera& camera, std::span<const SurfaceView> views,
                                     int step) {
  std::vector<Measured> points;
  for (std::size_t k = 0; k < views.size(); ++k) {
    const DepthImage& image = views[k].image;
    for (int v = step / 2; v < image.height; v += step)
      for (int u = step / 2; u < image.width; u += step) {
        const double z = static_cast<double>(image.at(u, v));
        if (z > 0.0) points.push_back({camera.at(u, v, z), depthNoiseAt(z), k});
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
      : camera_(camera), bodies_(bodies), views_(views) {
    for (const geometry::Surface* body : bodies) boxes_.push_back(body->bounds());
    const auto pixels = static_cast<double>(camera.width * camera.height) * static_cast<double>(views.size());
    step_ = static_cast<int>(std::ceil(std::sqrt(pixels / kMaxPixels)));
    points_ = measuredPoints(camera, views, step_);
  }

  /// Over every `stride`-th point.
  SurfaceSum at(const Transform& X_WC, double gate, std::size_t stride) const {
    std::vector<SurfaceRow> rows;
    SurfaceRow row;
    for (std::size_t i = 0; i < points_.size(); i += stride) {
      const double reach = std::max(gate, kGateNoise * points_[i].noise);
      if (alongRay(points_[i], X_WC, reach, row)) rows.push_back(row);
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

  /// For a pose near the best one: as many points beside the bodies as are useful, and no others.
  void focus(const Transform& X_WC) {
    const auto rows = static_cast<double>(at(X_WC, kLastGate, 1).rows);
    const int step = static_cast<int>(std::lround(step_ * std::sqrt(rows / kLastPoints)));
    points_ = measuredPoints(camera_, views_, std::clamp(step, 1, step_));
    std::erase_if(points_, [&](const Measured& m) { return !isBesideBodies(m, X_WC); });
  }

 private:
  bool isBesideBodies(const Measured& m, const Transform& X_WC) const {
    const double reach = kBesideBodies + kGateNoise * m.noise;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      if (distanceToBox(boxes_[b], views_[m.view].X_WB[b].inverse() * (X_WC * m.p_C)) < reach) return true;
    return false;
  }

  /// The row of a point and the first surface on its ray within `reach` of it. The noise of a point is along
  /// its ray, so the row depends on it by its distance alone: rows of the nearest points of the surfaces, or
  /// at the measured points, are biased by the noise.
  bool alongRay(const Measured& m, const Transform& X_WC, double reach, SurfaceRow& row) const {
    const Vector3d p_W = X_WC * m.p_C, ray_W = (p_W - X_WC.translation()).normalized();
    double nearest = reach;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const Transform& X_WB = views_[m.view].X_WB[b];
      const Transform X_BW = X_WB.inverse();
      const Vector3d p_B = X_BW * p_W;
      if (distanceToBox(boxes_[b], p_B) >= reach) continue;
      const RayHit hit = meet(*bodies_[b], p_B, X_BW.linear() * ray_W, reach);
      if (!(hit.t < nearest)) continue;
      nearest = hit.t;
      row.p_W = p_W + hit.t * ray_W;
      row.n_W = X_WB.linear() * hit.n;
      row.distance = -hit.t * row.n_W.dot(ray_W);
    }
    return nearest < reach;
  }

  const DepthCamera& camera_;
  std::span<const geometry::Surface* const> bodies_;
  std::span<const SurfaceView> views_;
  std::vector<geometry::Bounds> boxes_;
  int step_{1};
  std::vector<Measured> points_;
};

}  // namespace

SurfaceFit fitPoseToSurfaces(const DepthCamera& camera, std::span<const geometry::Surface* const> bodies,
                             std::span<const SurfaceView> views, std::uint64_t seed) {
  ABSTAND_CHECK(!bodies.empty() && !views.empty() && camera.distortion.isZero(0.0));
  SurfaceSearch search(camera, bodies, views, seed);
  Fit fit(camera, bodies, views);
  SurfaceFit best;
  double smallest_cost = kInfinity;
  for (const Transform& start : search.search(kStarts)) {
    const Transform end = fit.from(start, true);
    const double cost = search.cost(end, kLastTolerance);
    if (cost >= smallest_cost) continue;
    smallest_cost = cost;
    best.X_WC = end;
  }
  fit.focus(best.X_WC);
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
  best.rms = std::sqrt(sum.squares / (sum.weights - 6.0));
  best.spread = std::hypot(best.rms, spreadWithin(covarianceOf(sum), best.X_WC.translation() - sum.middle));
  if (!(best.spread <= kMaxSpread))
    refuse(
        "--links: found a position uncertainty of %.0f mm, expected %.0f or less: the robot is too small in "
        "the images, or too little of it is visible",
        1e3 * best.spread, 1e3 * kMaxSpread);
  const Transform moved = camera.X_WC.inverse() * best.X_WC;
  best.moved = moved.translation().norm();
  best.turned = Eigen::AngleAxisd(moved.linear()).angle();
  return best;
}

}  // namespace abstand::tracking
