// Estimates the pose of a depth camera whose pose is unknown.
#include "tracking/tracker/camera_stand.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tracking/tracker/stature.hpp"

namespace abstand::tracking {
namespace {

constexpr int kFloorImages = 5;
// Of the rows, at the lower border: a person who reaches them is cut off. Without a floor, the lowest percent
// of the points belongs to nobody (PeopleFinder).
constexpr double kBorder = 0.03;

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

/// Of all people in an image.
struct Extent {
  double low{kInfinity}, high{-kInfinity};  // m, z of the world
  bool cut_off{false};                      // by the lower border
};

Extent extentOf(const DepthImage& image, const DepthCamera& camera, const PeopleImage& people) {
  const int border = image.height - std::max(1, static_cast<int>(kBorder * image.height));
  Extent extent;
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) {
      if (people.label[static_cast<std::size_t>(v * image.width + u)] == 0) continue;
      const double z = (camera.X_WC * camera.at(u, v, static_cast<double>(image.at(u, v)))).z();
      extent.low = std::min(extent.low, z);
      extent.high = std::max(extent.high, z);
      extent.cut_off |= v >= border;
    }
  return extent;
}

DepthCamera levelled(DepthCamera camera) {
  camera.X_WC = overFloor({});
  return camera;
}

}  // namespace

CameraStand::CameraStand(const DepthCamera& camera, std::optional<double> stature)
    : camera_(levelled(camera)),
      stature_{stature.value_or(Stature::kUsual)},
      finder_(camera),
      X_WC_(camera_.X_WC) {}

bool CameraStand::see(double t, const DepthImage& image) {
  if (!reason_.empty()) return true;
  const PeopleImage& people = finder_.find(t, image);
  if (people.floor) {
    X_WC_ = overFloor(*people.floor);
    reason_ = "the visible floor is z = 0";
    return true;
  }
  const Extent extent = extentOf(image, camera_, people);
  low_ = std::min(low_, extent.low);
  high_ = std::max(high_, extent.high);
  cut_off_ += extent.cut_off;
  if (std::isfinite(low_) && ++seen_ == kFloorImages) settle();
  return !reason_.empty();
}

void CameraStand::settle() {
  if (!reason_.empty()) return;
  const double floor = high_ - stature_;
  if (2 * cut_off_ > seen_ && floor < low_) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "no visible floor, and the feet are below the image: the camera is assumed level, with the "
                  "highest visible point of a person at z = %.2f m",
                  stature_);
    X_WC_.translation().z() = -floor;
    reason_ = text;
    return;
  }
  if (std::isfinite(low_)) X_WC_.translation().z() = -low_;
  reason_ =
      "no visible floor: the camera is assumed level, with the lowest visible point of a person at z = 0";
}

}  // namespace abstand::tracking
