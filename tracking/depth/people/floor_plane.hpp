// The floor plane in a depth image.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"
#include "tracking/depth/people/point_grid.hpp"

namespace abstand::tracking {

/// A plane below the camera, in the camera's frame C.
struct FloorPlane {
  Vector3d up{0.0, -1.0, 0.0};  ///< unit, away from the floor
  double height{0.0};           ///< m, of the camera above the floor

  /// Height (m) above the floor; negative below.
  double above(const Vector3d& p_C) const { return up.dot(p_C) + height; }
};

/// The floor z = 0 of the world frame of a camera's pose.
FloorPlane floorOfWorld(const Transform& X_WC);

/// Finds the lowest plane within 35 degrees of the image's horizontal: of the planes through three of some
/// two thousand points, near each other in the image, the one with most points on it and hardly any below,
/// refined by least squares (RANSAC; Fischler, Bolles 1981). Deterministic for a seed. nullopt if less than 3
/// % of the points lie on such a plane, or they extend over less than half a metre in either direction, as
/// under the feet of one person.
class FloorFinder {
 public:
  std::optional<FloorPlane> find(const DepthImage& image, const DepthCamera& camera, std::uint64_t seed);

 private:
  PointGrid grid_;
  std::vector<Vector3d> points_;  ///< without unmeasured ones
};

}  // namespace abstand::tracking
