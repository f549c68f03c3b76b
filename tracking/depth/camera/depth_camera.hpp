// Pinhole depth camera and its file format.
#pragma once

#include <filesystem>
#include <string>

#include "core/math/transform.hpp"

namespace abstand::tracking {

/// Optical axes: x right, y down, z forward. The centre of the pixel in column u and row v is at (u, v).
struct DepthCamera {
  static constexpr int kMaxPixels = 4096;  ///< along a side

  int width{640}, height{480};
  double fx{580.0}, fy{580.0}, cx{319.5}, cy{239.5};  ///< pixels
  double depth_scale{1000.0};                         ///< units of an image per metre
  /// k1, k2, p1, p2, k3 of OpenCV's model.
  Eigen::Matrix<double, 5, 1> distortion{Eigen::Matrix<double, 5, 1>::Zero()};
  Transform X_WC{Transform::Identity()};  ///< camera in world
  double spread{0.0};  ///< m, standard deviation along the worst axis due to X_WC; 0: unknown

  /// The point in the camera's frame at pixel (u, v) and depth z (m) along the optical axis. Without
  /// distortion.
  Vector3d at(double u, double v, double z) const { return {(u - cx) / fx * z, (v - cy) / fy * z, z}; }
  /// Pixel (u, v) of a point in front of the camera, with distortion (Brown's model in OpenCV's order).
  Eigen::Vector2d pixelOf(const Vector3d& p_C) const;
};

/// Reads a camera file: YAML with `width, height, fx, fy, cx, cy, depth_scale`, and optionally `distortion:
/// [k1, k2, p1, p2, k3]`, `T_WC: {xyz, rpy}` and `spread`. Throws ParseError with line and column.
DepthCamera loadDepthCamera(const std::filesystem::path& file);
DepthCamera parseDepthCamera(const std::string& text, const std::string& file);
/// Text that parseDepthCamera() reads back to exactly the same numbers.
std::string describeDepthCamera(const DepthCamera& camera);

/// Camera pose at `eye` with the optical axis towards `target` and level rows; world z is up. Throws
/// UsageError if they coincide or one is above the other.
Transform lookingAt(const Vector3d& eye, const Vector3d& target);

}  // namespace abstand::tracking
