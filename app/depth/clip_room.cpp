#include "app/depth/clip_room.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::depth {
namespace {

constexpr double kWallBehind = 1.5, kWallBehindEye = 0.5;  // m
constexpr double kWallHeight = 3.0, kRoomBreadth = 8.0;    // m

geometry::TriangleMesh rectangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return {{a, b, c, a + c - b}, {{0, 1, 2}, {0, 2, 3}}};
}

Vector3d aheadOf(const tracking::DepthCamera& camera) {
  Vector3d ahead = camera.X_WC.linear().col(2);
  ahead.z() = 0.0;
  if (!(ahead.norm() > 1e-6))
    throw UsageError("--room: the camera looks straight down, expected one that sees a wall");
  return ahead.normalized();
}

}  // namespace

std::vector<geometry::TriangleMesh> roomOf(std::span<const tracking::DepthCamera> cameras,
                                           const ClipPeople& people, std::span<const double> times) {
  std::vector<geometry::TriangleMesh> room;
  for (const tracking::DepthCamera& camera : cameras) {
    const Vector3d eye = camera.X_WC.translation(), ahead = aheadOf(camera);
    double farthest = 0.0;
    for (std::size_t i = 0; i < people.size(); ++i)
      for (const double t : times)
        for (const Vector3d& p : people.at(i, t).p)
          if (p.allFinite()) farthest = std::max(farthest, (p - eye).dot(ahead));
    double wall = farthest + kWallBehind;
    for (const tracking::DepthCamera& other : cameras)
      wall = std::max(wall, (other.X_WC.translation() - eye).dot(ahead) + kWallBehindEye);
    const Vector3d aside = 0.5 * kRoomBreadth * ahead.cross(Vector3d::UnitZ());
    Vector3d near = eye - ahead, foot = eye + wall * ahead;
    near.z() = foot.z() = 0.0;
    const Vector3d up = kWallHeight * Vector3d::UnitZ();
    room.push_back(rectangle(near - aside, near + aside, foot + aside));
    room.push_back(rectangle(foot - aside, foot + aside, foot + aside + up));
  }
  return room;
}

}  // namespace abstand::depth
