// Estimates the pose of a depth camera whose pose is unknown.
#include "tracking/tracker/camera_stand.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

constexpr int kFloorImages = 5;

/// Pose of a camera above a plane: z up, x along the horizontal part of the optical axis, origin below the
/// camera.
Transform overFloor(const FloorPlane& floor) {
  const Vector3d z = floor.up.normalized();
  Vector3d x = Vector3d::UnitZ() - z.z() * z;
  x = x.norm() > 1e-3 ? Vector3d(x.normalized()) : z.unitOrthogonal();
  Matrix3d R_WC;
  R_WC.row(0) = x.transpose();
  R_WC.row(1) = z.cross(x).transpose();
  R_WC.row(2) = z.transpose();
  Transform X_WC = Transform::Identity();
  X_WC.linear() = R_WC;
  X_WC.translation() = Vector3d(0.0, 0.0, floor.height);
  return X_WC;
}

/// Lowest point (m, z of the world) of any person in an image.
double lowest(const DepthImage& image, const DepthCamera& camera, const PeopleImage& people) {
  double z = kInfinity;
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u)
      if (people.label[static_cast<std::size_t>(v * image.width + u)] != 0)
        z = std::min(z, (camera.X_WC * camera.at(u, v, static_cast<double>(image.at(u, v)))).z());
  return z;
}

DepthCamera levelled(DepthCamera camera) {
  camera.X_WC = overFloor({});
  return camera;
}

}  // namespace

CameraStand::CameraStand(const DepthCamera& camera)
    : camera_(levelled(camera)), finder_(camera), X_WC_(camera_.X_WC) {}

bool CameraStand::see(double t, const DepthImage& image) {
  if (!reason_.empty()) return true;
  const PeopleImage& people = finder_.find(t, image);
  if (people.floor) {
    X_WC_ = overFloor(*people.floor);
    reason_ = "the visible floor is z = 0";
    return true;
  }
  low_ = std::min(low_, lowest(image, camera_, people));
  if (std::isfinite(low_) && ++seen_ == kFloorImages) settle();
  return !reason_.empty();
}

void CameraStand::settle() {
  if (!reason_.empty()) return;
  if (std::isfinite(low_)) X_WC_.translation().z() = -low_;
  reason_ =
      "no visible floor: the camera is assumed level, with the lowest visible point of a person at z = 0";
}

}  // namespace abstand::tracking
