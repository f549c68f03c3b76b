// Global search for the camera pose in which known bodies explain depth images.
#include "tracking/depth/calibration/surface_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/random.hpp"
#include "tracking/depth/calibration/depth_noise.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kSearchPoints = 1200;  // in all views together
constexpr std::size_t kCoarse = 6000, kKept = 16;
constexpr int kRounds = 8, kTries = 60;
constexpr double kFirstTolerance = 0.1, kFinestTolerance = 0.03;  // m
constexpr double kNotSeen = 0.6;  // cost of a point that is occluded or has no measurement

struct Candidate {
  double cost;
  Transform X_WC;
};

/// Uniformly distributed offset in a box: translated and rotated about the camera's own axes.
Transform perturbed(const Transform& X_WC, double reach, double turn, Random& random) {
  const Vector3d move = random.inCube(reach), angles = random.inCube(turn);
  return X_WC * fromXyzRpy(move, angles);
}

}  // namespace

SurfaceSearch::SurfaceSearch(const DepthCamera& camera, std::span<const geometry::Surface* const> bodies,
                             std::span<const SurfaceView> views, std::uint64_t seed)
    : camera_(camera), views_(views), seed_(seed) {
  for (std::size_t k = 0; k < views.size(); ++k)
    for (const SurfaceSample& s : sampleSurfaces(bodies, kSearchPoints / views.size(), seed + k)) {
      const Transform& X_WB = views[k].X_WB[s.body];
      points_.push_back({X_WB * s.p, X_WB.linear() * s.normal, k});
    }
}

template <class Visit>
void SurfaceSearch::forEachVisible(const Transform& X_WC, const Visit& visit) const {
  const Transform X_CW = X_WC.inverse();
  const Vector3d eye = X_WC.translation();
  for (const Point& point : points_) {
    if (point.n_W.dot(point.p_W - eye) >= 0.0) continue;
    const Vector3d p_C = X_CW * point.p_W;
    if (!(p_C.z() > 0.1)) continue;
    const double u = std::round(camera_.fx * p_C.x() / p_C.z() + camera_.cx);
    const double v = std::round(camera_.fy * p_C.y() / p_C.z() + camera_.cy);
    const DepthImage& image = views_[point.view].image;
    double behind = kNaN;
    if (u >= 0.0 && v >= 0.0 && u < image.width && v < image.height) {
      const float z = image.at(static_cast<int>(u), static_cast<int>(v));
      if (z > 0.0f) behind = static_cast<double>(z) - p_C.z();
    }
    visit(behind, p_C.z());
  }
}

double SurfaceSearch::cost(const Transform& X_WC, double tolerance) const {
  double sum = 0.0, count = 0.0;
  forEachVisible(X_WC, [&](double behind, double z) {
    count += 1.0;
    const double allowed = std::max(tolerance, 2.0 * depthNoiseAt(z));
    if (std::isnan(behind) || behind < -allowed)
      sum += kNotSeen;
    else
      sum += std::min(1.0, behind * behind / (allowed * allowed));
  });
  return count > 0.0 ? sum / count : 1.0;
}

double SurfaceSearch::explained(const Transform& X_WC) const {
  double there = 0.0, count = 0.0;
  forEachVisible(X_WC, [&](double behind, double z) {
    const double tolerance = 0.03 + 0.006 * z * z;  // two steps of a Kinect's disparity, and its edge effects
    if (!(behind > -tolerance)) return;
    count += 1.0;
    if (behind < tolerance) there += 1.0;
  });
  return count > 0.0 ? there / count : 0.0;
}

std::vector<Transform> SurfaceSearch::search(std::size_t max_count) {
  const auto cheaper = [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; };
  Random random(seed_, 1);
  std::vector<Candidate> found{{cost(camera_.X_WC, kFirstTolerance), camera_.X_WC}};
  for (std::size_t i = 0; i < kCoarse; ++i) {
    const Transform X = perturbed(camera_.X_WC, kReach, kTurn, random);
    found.push_back({cost(X, kFirstTolerance), X});
  }
  std::stable_sort(found.begin(), found.end(), cheaper);
  found.resize(kKept);
  for (Candidate& best : found)
    for (int round = 0; round < kRounds; ++round) {
      const double part = static_cast<double>(round) / (kRounds - 1);
      const double tolerance = kFirstTolerance + part * (kFinestTolerance - kFirstTolerance);
      const double smaller = 0.3 * std::pow(0.7, round);
      best.cost = cost(best.X_WC, tolerance);
      for (int i = 0; i < kTries; ++i) {
        const Transform X = perturbed(best.X_WC, smaller * kReach, smaller * kTurn, random);
        const double c = cost(X, tolerance);
        if (c < best.cost) best = {c, X};
      }
    }
  std::stable_sort(found.begin(), found.end(), cheaper);
  std::vector<Transform> poses;
  for (std::size_t i = 0; i < std::min(max_count, found.size()); ++i) poses.push_back(found[i].X_WC);
  return poses;
}

}  // namespace abstand::tracking
