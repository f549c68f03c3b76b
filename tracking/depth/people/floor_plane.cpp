// The floor plane in a depth image.
#include "tracking/depth/people/floor_plane.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "tracking/depth/people/floor_consensus.hpp"

namespace abstand::tracking {
namespace {

constexpr int kPlaneTries = 1500;          // most of them are not level and cost nothing
constexpr double kCertainty = 1.0 - 1e-9;  // with less, different seeds give floors of one image that differ
                                           // by 4 cm
constexpr std::size_t kPoints = 2000;
constexpr double kTilt = 35.0;       // degrees
constexpr double kMinHeight = 0.3;   // m, of the camera above the floor
constexpr double kMinShare = 0.03;   // of all points, on the floor
constexpr double kMaxBelow = 0.02;   // of all points, below the floor
constexpr double kMinSpread = 0.15;  // m, standard deviation: that of half a metre evenly covered
constexpr double kFarthest = 8.0;    // m

/// m; deviation of a Kinect's depth, more than its steps (2.9 mm z^2, see kinect_noise.hpp).
double thickness(const Vector3d& p) { return 0.02 + 0.003 * p.z() * p.z(); }

struct Count {
  std::size_t on{0}, below{0};
};

Count countOn(const std::vector<Vector3d>& points, const FloorPlane& plane) {
  Count count;
  for (const Vector3d& p : points) {
    const double h = plane.above(p), t = thickness(p);
    count.on += std::abs(h) < t;
    count.below += h < -3.0 * t;
  }
  return count;
}

bool isLevel(const Vector3d& up) { return -up.y() > std::cos(unit::deg(kTilt)); }

}  // namespace

FloorPlane floorOfWorld(const Transform& X_WC) {
  return {X_WC.linear().transpose() * Vector3d::UnitZ(), X_WC.translation().z()};
}

std::optional<FloorPlane> FloorFinder::find(const DepthImage& image, const DepthCamera& camera,
                                            std::uint64_t seed) {
  const double pixels = static_cast<double>(image.z.size());
  const int step = std::max(1, static_cast<int>(std::sqrt(pixels / static_cast<double>(kPoints))));
  const int columns = (image.width + step - 1) / step, rows = (image.height + step - 1) / step;
  grid_.columns = columns;
  grid_.rows = rows;
  grid_.points.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), Vector3d::Zero());
  points_.clear();
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const auto z = static_cast<double>(image.at(c * step, r * step));
      if (!(z > 0.0 && z < kFarthest)) continue;
      points_.push_back(camera.at(c * step, r * step, z));
      grid_.points[static_cast<std::size_t>(r * columns + c)] = points_.back();
    }
  if (points_.size() < 50) return std::nullopt;
  const auto total = static_cast<double>(points_.size());
  const auto min_count = static_cast<std::size_t>(kMinShare * total);
  const auto count_floor = [&](const FloorPlane& plane) -> std::size_t {
    if (plane.height < kMinHeight) return 0;
    const Count count = countOn(points_, plane);
    return count.on <= min_count || static_cast<double>(count.below) > kMaxBelow * total ? 0 : count.on;
  };
  std::optional<FloorPlane> best =
      consensusPlane(grid_, {unit::deg(kTilt), kCertainty, kPlaneTries, seed}, count_floor);
  if (!best) return std::nullopt;
  for (int round = 0; round < 3; ++round) {
    Vector3d mean = Vector3d::Zero();
    Matrix3d squares = Matrix3d::Zero();
    double n = 0.0;
    for (const Vector3d& p : points_) {
      if (std::abs(best->above(p)) >= thickness(p)) continue;
      mean += p;
      squares += p * p.transpose();
      n += 1.0;
    }
    if (n < 3.0) return std::nullopt;
    mean /= n;
    const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(squares / n - mean * mean.transpose());
    if (std::sqrt(std::max(0.0, axes.eigenvalues()[1])) < kMinSpread) return std::nullopt;
    Vector3d up = axes.eigenvectors().col(0);
    if (up.y() > 0.0) up = -up;
    *best = {up, -up.dot(mean)};
  }
  const Count count = countOn(points_, *best);
  if (!isLevel(best->up) || static_cast<double>(count.below) > kMaxBelow * total ||
      static_cast<double>(count.on) < kMinShare * total)
    return std::nullopt;
  return best;
}

}  // namespace abstand::tracking
