// A room around the people of a simulated clip.
#pragma once

#include <span>
#include <vector>

#include "app/depth/clip_people.hpp"
#include "core/geometry/triangle_mesh.hpp"
#include "tracking/depth/camera/depth_camera.hpp"

namespace abstand::depth {

/// A floor at z = 0 and, in front of each camera, a wall 1.5 m behind the person farthest away, in world. The
/// room is the same for all cameras: no wall is in front of another camera's eye, but 0.5 m behind it. Throws
/// UsageError if a camera looks straight down.
std::vector<geometry::TriangleMesh> roomOf(std::span<const tracking::DepthCamera> cameras,
                                           const ClipPeople& people, std::span<const double> times);

}  // namespace abstand::depth
