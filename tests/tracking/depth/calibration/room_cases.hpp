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

/// Of any room and two cameras.
RoomCase roomCase(const std::vector<Box>& boxes, std::array<tracking::DepthCamera, 2> cameras,
                  std::uint64_t seed, int images, const Transform& start);

/// A floor and a wall at x = -2.15, with nothing else.
std::vector<Box> wallRoom();
/// Uprights every 0.4 m along the wall, and five boards: repeated parts that fill the view.
std::vector<Box> shelfRoom();
/// Posts every 0.3 m along the wall.
std::vector<Box> postRoom();
/// Two cameras that look at the wall, 1.7 m from each other.
std::array<tracking::DepthCamera, 2> wallCameras(int width);

}  // namespace abstand::testing
