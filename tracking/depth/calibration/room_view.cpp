// Static surfaces in a depth image as points with normals.
#include "tracking/depth/calibration/room_view.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "tracking/depth/calibration/depth_noise.hpp"

namespace abstand::tracking {
namespace {

constexpr double kRoomPatch = 0.07;       // m, radius of the fitted patch, at least
constexpr int kRoomLargestPatch = 8;      // pixels of the grid
constexpr double kRoomSmoothShare = 0.3;  // of the pixels of a square about the patch
constexpr double kRoomGrazing = 0.17;     // cosine to the ray; flatter surfaces are not measured accurately

/// m, distance from the plane or depth step within which a pixel belongs to a surface.
double roomStepAt(double z) { return 0.015 + 0.008 * z * z; }

}  // namespace

RoomView::RoomView(const DepthCamera& camera, const DepthImage& image)
    : camera_{camera}, step_{(image.width + kColumns - 1) / kColumns} {
  ABSTAND_CHECK(camera.distortion.isZero(0.0) && image.width > 0);
  columns_ = (image.width + step_ - 1) / step_;
  rows_ = (image.height + step_ - 1) / step_;
  grid_.resize(static_cast<std::size_t>(columns_ * rows_));
  for (int y = 0; y < rows_; ++y)
    for (int x = 0; x < columns_; ++x) {
      const RoomPoint point = pointAt(image, x * step_, y * step_);
      grid_[static_cast<std::size_t>(y * columns_ + x)] = point;
      if (point.smooth()) points_.push_back(point);
    }
}

RoomPoint RoomView::pointAt(const DepthImage& image, int u, int v) const {
  RoomPoint point;
  const double z = static_cast<double>(image.at(u, v));
  if (z <= 0.0) return point;
  point.p_C = camera_.at(u, v, z);
  const int reach =
      step_ * std::clamp(static_cast<int>(kRoomPatch * camera_.fx / (z * step_)), 2, kRoomLargestPatch);
  const int around = (2 * (reach / step_) + 1) * (2 * (reach / step_) + 1);
  const double radius = std::max(kRoomPatch, 3.0 * depthNoiseAt(z));
  Vector3d mean = Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  int count = 0;
  for (int y = v - reach; y <= v + reach; y += step_)
    for (int x = u - reach; x <= u + reach; x += step_) {
      if (x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
      const double beside = static_cast<double>(image.at(x, y));
      if (beside <= 0.0) continue;
      const Vector3d d = camera_.at(x, y, beside) - point.p_C;
      if (d.squaredNorm() > radius * radius) continue;
      mean += d;
      squares += d * d.transpose();
      ++count;
    }
  if (count < kRoomSmoothShare * around) return point;
  mean /= count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(squares / count - mean * mean.transpose());
  const Vector3d n = axes.eigenvectors().col(0);
  const double cosine = -n.dot(point.p_C.normalized());
  const double thickness = std::sqrt(std::max(0.0, axes.eigenvalues()[0]));
  if (!(std::abs(cosine) > kRoomGrazing) || thickness > 0.4 * roomStepAt(z) ||
      std::abs(n.dot(mean)) > roomStepAt(z))
    return point;
  point.n_C = cosine > 0.0 ? n : Vector3d(-n);
  // On the plane, which averages the noise of its pixels.
  point.p_C += n.dot(mean) * n;
  return point;
}

Vector3d RoomView::middle() const {
  Vector3d sum = Vector3d::Zero();
  for (const RoomPoint& point : points_) sum += point.p_C;
  return points_.empty() ? sum : Vector3d(sum / static_cast<double>(points_.size()));
}

const RoomPoint* RoomView::at(const Vector3d& p_C) const {
  if (p_C.z() <= 0.01) return nullptr;
  const Eigen::Vector2d pixel = camera_.pixelOf(p_C) / step_;
  if (!(pixel.x() > -0.5 && pixel.y() > -0.5 && pixel.x() < columns_ - 0.5 && pixel.y() < rows_ - 0.5))
    return nullptr;
  const int x = static_cast<int>(std::lround(pixel.x())), y = static_cast<int>(std::lround(pixel.y()));
  if (x >= columns_ || y >= rows_ || x < 0 || y < 0) return nullptr;
  const RoomPoint& point = grid_[static_cast<std::size_t>(y * columns_ + x)];
  return point.p_C.z() > 0.0 ? &point : nullptr;
}

}  // namespace abstand::tracking
