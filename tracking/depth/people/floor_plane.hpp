// The floor in a depth image.
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
  Vector3d up{0.0, -1.0, 0.0};  ///< of length 1, away from the floor
  double height{0.0};           ///< m, of the camera over it

  /// m over the floor; negative below.
  double above(const Vector3d& p_C) const { return up.dot(p_C) + height; }
};

/// The floor z = 0 of the world that a camera's pose is given in.
FloorPlane floorOfWorld(const Transform& X_WC);

/// Finds the lowest plane that is level to within 35 degrees of the image's up: of the planes through three
/// of some two thousand points, near to each other in the image, the one with most points on it and next to
/// none below, then its least squares (Fischler, Bolles 1981). The same for the same seed. Nothing where less
/// than 3 % of the points lie on such a plane, or they do not spread over half a metre both ways, as under
/// the feet of one person.
class FloorFinder {
 public:
  std::optional<FloorPlane> find(const DepthImage& image, const DepthCamera& camera, std::uint64_t seed);

 private:
  PointGrid grid_;
  std::vector<Vector3d> points_;  ///< those that are not 0
};

}  // namespace abstand::tracking
