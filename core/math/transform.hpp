// Poses, wrenches and twists. SI units; right-handed; X_WB takes points of B into W.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <numbers>

namespace abstand {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector3i;
using Transform = Eigen::Isometry3d;

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Force (N) and torque (N m) about a stated point, both in the axes of a stated frame.
struct Wrench {
  Vector3d force{Vector3d::Zero()};
  Vector3d torque{Vector3d::Zero()};
  Wrench& operator+=(const Wrench& other) {
    force += other.force;
    torque += other.torque;
    return *this;
  }
};

/// Linear (m/s) and angular (rad/s) velocity of a body, in world axes.
struct Twist {
  Vector3d linear{Vector3d::Zero()};
  Vector3d angular{Vector3d::Zero()};
};

namespace unit {
constexpr double mm(double v) { return v * 1e-3; }
constexpr double cm(double v) { return v * 1e-2; }
constexpr double inch(double v) { return v * 0.0254; }
constexpr double deg(double v) { return v * kPi / 180.0; }
}  // namespace unit

/// Fixed-axis roll, pitch, yaw as in URDF: R = Rz(yaw) Ry(pitch) Rx(roll), radians.
inline Transform fromXyzRpy(const Vector3d& xyz, const Vector3d& rpy) {
  Transform X = Transform::Identity();
  X.linear() = (Eigen::AngleAxisd(rpy.z(), Vector3d::UnitZ()) *
                Eigen::AngleAxisd(rpy.y(), Vector3d::UnitY()) * Eigen::AngleAxisd(rpy.x(), Vector3d::UnitX()))
                   .toRotationMatrix();
  X.translation() = xyz;
  return X;
}

/// True if every entry is finite and the rotation is orthonormal and right-handed within `tolerance`.
inline bool isPose(const Transform& X, double tolerance = 1e-6) {
  if (!X.matrix().allFinite()) return false;
  const Matrix3d R = X.linear();
  return (R * R.transpose() - Matrix3d::Identity()).cwiseAbs().maxCoeff() <= tolerance &&
         R.determinant() > 0.0;
}

}  // namespace abstand
