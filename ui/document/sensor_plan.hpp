// A depth camera that is not there yet.
#pragma once

#include <QMetaType>
#include <QString>
#include <cmath>
#include <optional>

#include "core/math/transform.hpp"
#include "ui/document/camera_view.hpp"
#include "ui/document/sensor_lens.hpp"

namespace abstand::ui {

/// SensorPlan::sensor of a plan with the lens of a camera file.
inline const QString kFileSensor = QStringLiteral("file");

/// Kind and pose of a planned depth camera, which looks along a direction in the world.
struct SensorPlan {
  QString sensor{QStringLiteral("kinect")};  ///< as `--sensor` of `abstand coverage`, or kFileSensor
  std::optional<SensorLens> lens;            ///< of the camera file that was read last
  Vector3d xyz{3.0, 0.0, 1.5};               ///< m, world
  double azimuth{kPi};                       ///< rad, of the direction, about z; 0: along x
  double elevation{0.0};                     ///< rad, of the direction, above the horizon
  double roll{
      0.0};  ///< rad, about the direction; 0: level rows, positive: the right side of the image is lower

  /// The optical frame (x right, y down, z forward) in the world.
  Transform X_W() const {
    const double c = std::cos(azimuth), s = std::sin(azimuth);
    Transform X = Transform::Identity();
    Matrix3d R;
    R.col(2) = Vector3d(c * std::cos(elevation), s * std::cos(elevation), std::sin(elevation));
    R.col(0) = Vector3d(s, -c, 0.0);
    R.col(1) = R.col(2).cross(R.col(0));
    X.linear() = R * Eigen::AngleAxisd(roll, Vector3d::UnitZ());
    X.translation() = xyz;
    return X;
  }
  bool operator==(const SensorPlan& other) const {
    return sensor == other.sensor && lens == other.lens && xyz == other.xyz && azimuth == other.azimuth &&
           elevation == other.elevation && roll == other.roll;
  }
};

/// `plan` with this optical frame (x right, y down, z forward) in the world. Where it looks along the
/// vertical, the azimuth is 0.
inline SensorPlan withPose(SensorPlan plan, const Transform& X_W) {
  constexpr double kVertical = 1e-9;  // horizontal part of a direction that has no azimuth
  const Vector3d ahead = X_W.linear().col(2);
  const double across = std::hypot(ahead.x(), ahead.y());
  plan.xyz = X_W.translation();
  plan.azimuth = across > kVertical ? std::atan2(ahead.y(), ahead.x()) : 0.0;
  plan.elevation = std::atan2(ahead.z(), across);
  plan.roll = 0.0;
  const Vector3d right = plan.X_W().linear().transpose() * X_W.linear().col(0);
  plan.roll = std::atan2(right.y(), right.x());
  return plan;
}

/// `plan` at the eye of a view, in its direction, level.
inline SensorPlan fromView(SensorPlan plan, const CameraView& view) {
  const Vector3d back(std::cos(view.azimuth) * std::cos(view.elevation),
                      std::sin(view.azimuth) * std::cos(view.elevation), std::sin(view.elevation));
  plan.xyz = view.focus + view.distance * back;
  plan.azimuth = std::remainder(view.azimuth + kPi, 2.0 * kPi);
  plan.elevation = -view.elevation;
  plan.roll = 0.0;
  return plan;
}

}  // namespace abstand::ui

Q_DECLARE_METATYPE(abstand::ui::SensorPlan)
