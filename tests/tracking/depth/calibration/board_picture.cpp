// Pictures of a chessboard whose pose is known.
#include "tests/tracking/depth/calibration/board_picture.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/random.hpp"

namespace abstand::testing {
namespace {

constexpr double kWhite = 210.0, kBlack = 35.0, kAround = 120.0;

/// The ray (z = 1) that the camera sees at (u, v): Brown's model backwards, by fixed-point steps.
Vector3d rayAt(const tracking::DepthCamera& camera, double u, double v) {
  const Vector3d seen = camera.at(u, v, 1.0);
  Vector3d ray = seen;
  if (camera.distortion.isZero(0.0)) return ray;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector2d p = camera.pixelOf(ray);
    ray += seen - camera.at(p.x(), p.y(), 1.0);
  }
  return ray;
}

double brightness(const tracking::Chessboard& board, double x, double y) {
  const double column = std::floor(x / board.square) + 1.0, row = std::floor(y / board.square) + 1.0;
  if (column < -1.0 || row < -1.0 || column > board.columns || row > board.rows) return kAround;
  if (column < 0.0 || row < 0.0 || column >= board.columns || row >= board.rows) return kWhite;
  return static_cast<int>(column + row) % 2 == 0 ? kBlack : kWhite;
}

}  // namespace

tracking::GreyImage pictureOf(const tracking::DepthCamera& camera, const tracking::Chessboard& board,
                              const Transform& X_WO, const BoardPictureOptions& options) {
  const Transform X_OC = X_WO.inverse() * camera.X_WC;
  tracking::GreyImage image(camera.width, camera.height);
  Random random(options.seed, 0);
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) {
      double sum = 0.0;
      const Vector3d ray = rayAt(camera, u, v);
      for (int k = 0; k < options.samples * options.samples; ++k) {
        const double du = (k % options.samples + 0.5) / options.samples - 0.5;
        const double dv = (k / options.samples + 0.5) / options.samples - 0.5;
        const Vector3d way = X_OC.linear() * (ray + Vector3d(du / camera.fx, dv / camera.fy, 0.0));
        const double far = -X_OC.translation().z() / way.z();
        const Vector3d p = X_OC.translation() + far * way;
        sum += far > 0.0 ? brightness(board, p.x(), p.y()) : kAround;
      }
      // Three uniform numbers are nearly a normal one; their variance is a quarter.
      const double noise = 2.0 * (random.unit() + random.unit() + random.unit() - 1.5);
      const double level = sum / (options.samples * options.samples) + options.noise * noise;
      image.at(u, v) = static_cast<std::uint8_t>(std::clamp(std::round(level), 0.0, 255.0));
    }
  return image;
}

tracking::DepthCamera cameraBefore(const tracking::Chessboard& board, const Transform& X_WO, double distance,
                                   double lean, double side, double roll) {
  tracking::DepthCamera camera;
  const Vector3d middle(0.5 * board.square * (board.columns - 2), 0.5 * board.square * (board.rows - 2), 0.0);
  Transform X_OC = Transform::Identity();
  X_OC.linear() = (Eigen::AngleAxisd(side, Vector3d::UnitZ()) * Eigen::AngleAxisd(lean, Vector3d::UnitX()) *
                   Eigen::AngleAxisd(kPi, Vector3d::UnitX()) * Eigen::AngleAxisd(roll, Vector3d::UnitZ()))
                      .toRotationMatrix();
  X_OC.translation() = middle - distance * X_OC.linear().col(2);
  camera.X_WC = X_WO * X_OC;
  return camera;
}

}  // namespace abstand::testing
