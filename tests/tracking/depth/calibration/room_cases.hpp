// Rooms of boxes that two cameras see.
#pragma once

#include <array>
#include <vector>

#include "tracking/depth/calibration/room_view.hpp"

namespace abstand::testing {

struct Box {
  Vector3d size;
  Transform X_WB;
};

/// A floor, up to two walls, and objects that depend on the seed.
struct RoomPlan {
  int walls{2};
  bool objects{true};
};

std::vector<Box> roomOf(const RoomPlan& plan, std::uint64_t seed);

/// Two cameras 2.2 to 3 m from the room's middle, 30 to 60 degrees from each other.
std::array<tracking::DepthCamera, 2> camerasOf(std::uint64_t seed, int width);

/// The surfaces without noise.
tracking::DepthImage rendered(const tracking::DepthCamera& camera, const std::vector<Box>& boxes);

/// Unit normals of the image without noise, towards the camera; zero at edges and unmeasured pixels.
std::vector<Vector3d> trueNormals(const tracking::DepthCamera& camera, const tracking::DepthImage& ideal);

/// What a Kinect sees of the boxes in `images` images.
tracking::DepthImage roomSeen(const tracking::DepthCamera& camera, const std::vector<Box>& boxes,
                              std::uint64_t seed, int images);

struct RoomCase {
  tracking::RoomView known, camera;
  Transform truth;
};

/// The start is `move` (m) and `turn` (rad) off.
RoomCase roomCase(const RoomPlan& plan, std::uint64_t seed, int width, int images, double move = 0.1,
                  double turn = unit::deg(10.0));

}  // namespace abstand::testing
