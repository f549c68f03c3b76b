#include "tests/tracking/depth/calibration/room_cases.hpp"

#include <cmath>

#include "core/geometry/shape.hpp"
#include "core/math/random.hpp"
#include "tests/tracking/depth/calibration/pose_errors.hpp"
#include "tracking/depth/calibration/still_image.hpp"
#include "tracking/depth/simulator/depth_render.hpp"
#include "tracking/depth/simulator/kinect_noise.hpp"

namespace abstand::testing {

std::vector<Box> roomOf(const RoomPlan& plan, std::uint64_t seed) {
  Random random(seed, 7);
  std::vector<Box> boxes;
  const auto add = [&](const Vector3d& size, const Vector3d& p, double yaw) {
    boxes.push_back({size, fromXyzRpy(p, {0.0, 0.0, yaw})});
  };
  add({10.0, 10.0, 0.02}, {0.0, 0.0, -0.01}, 0.0);
  if (plan.walls > 0) add({0.02, 10.0, 4.0}, {-1.8, 0.0, 2.0}, 0.0);
  if (plan.walls > 1) add({10.0, 0.02, 4.0}, {0.0, -1.8, 2.0}, 0.0);
  if (!plan.objects) return boxes;
  const double x = random.between(-1.4, -1.0), y = random.between(0.1, 0.7);
  add({0.7, 1.4, 0.9}, {x, y, 0.45}, random.between(-0.2, 0.2));
  for (int i = 0; i < 4; ++i) {
    const double height = random.between(0.25, 0.9), width = random.between(0.2, 0.6);
    const double at_x = random.between(-1.4, 0.9), at_y = random.between(-1.4, 1.4);
    add({width, random.between(0.2, 0.6), height}, {at_x, at_y, 0.5 * height}, random.between(0.0, 1.5));
  }
  return boxes;
}

std::vector<Box> wallRoom() {
  return {{{8.0, 8.0, 0.1}, fromXyzRpy({0.0, 0.0, -0.05}, Vector3d::Zero())},
          {{0.1, 8.0, 3.0}, fromXyzRpy({-2.2, 0.0, 1.5}, Vector3d::Zero())}};
}

std::vector<Box> shelfRoom() {
  std::vector<Box> boxes = wallRoom();
  for (int i = -6; i <= 6; ++i)
    boxes.push_back({{0.4, 0.04, 2.0}, fromXyzRpy({-2.0, 0.4 * i, 1.0}, Vector3d::Zero())});
  for (int i = 1; i <= 5; ++i)
    boxes.push_back({{0.4, 6.0, 0.03}, fromXyzRpy({-2.0, 0.0, 0.4 * i}, Vector3d::Zero())});
  return boxes;
}

std::vector<Box> postRoom() {
  std::vector<Box> boxes = wallRoom();
  for (int i = -8; i <= 8; ++i)
    boxes.push_back({{0.2, 0.12, 1.6}, fromXyzRpy({-2.05, 0.3 * i, 0.8}, Vector3d::Zero())});
  return boxes;
}

namespace {

tracking::DepthCamera roomCamera(int width) {
  tracking::DepthCamera camera;
  camera.width = width;
  camera.height = width * 3 / 4;
  camera.fx = camera.fy = 580.0 * width / 640.0;
  camera.cx = 0.5 * (camera.width - 1);
  camera.cy = 0.5 * (camera.height - 1);
  return camera;
}

}  // namespace

std::array<tracking::DepthCamera, 2> wallCameras(int width) {
  std::array<tracking::DepthCamera, 2> cameras{roomCamera(width), roomCamera(width)};
  cameras[0].X_WC = tracking::lookingAt({2.2, 0.3, 1.7}, {-1.0, -0.3, 0.7});
  cameras[1].X_WC = tracking::lookingAt({1.6, 1.9, 1.8}, {-1.0, -0.3, 0.7});
  return cameras;
}

std::array<tracking::DepthCamera, 2> camerasOf(std::uint64_t seed, int width) {
  Random random(seed, 3);
  const double middle = random.between(0.3, 1.2), angle = unit::deg(random.between(30.0, 60.0));
  std::array<tracking::DepthCamera, 2> cameras;
  for (int i = 0; i < 2; ++i) {
    tracking::DepthCamera& camera = cameras[static_cast<std::size_t>(i)];
    camera = roomCamera(width);
    const double phi = middle + (i - 0.5) * angle, d = random.between(2.2, 3.0);
    const Vector3d eye(d * std::cos(phi) - 0.3, d * std::sin(phi) - 0.3, random.between(1.4, 2.4));
    const double x = random.between(-0.6, -0.1), y = random.between(-0.6, -0.1);
    camera.X_WC = tracking::lookingAt(eye, {x, y, random.between(0.4, 0.9)});
  }
  return cameras;
}

tracking::DepthImage rendered(const tracking::DepthCamera& camera, const std::vector<Box>& boxes) {
  tracking::DepthRender render(camera);
  const Transform X_CW = camera.X_WC.inverse();
  for (const Box& box : boxes)
    render.draw(geometry::tessellate(geometry::Cuboid{box.size}, 1e-3), X_CW * box.X_WB);
  return render.image();
}

std::vector<Vector3d> trueNormals(const tracking::DepthCamera& camera, const tracking::DepthImage& ideal) {
  std::vector<Vector3d> normals(ideal.z.size(), Vector3d::Zero());
  const auto at = [&](int u, int v) { return camera.at(u, v, static_cast<double>(ideal.at(u, v))); };
  for (int v = 1; v + 1 < ideal.height; ++v)
    for (int u = 1; u + 1 < ideal.width; ++u) {
      const Vector3d p = at(u, v);
      const Vector3d n = (at(u, v + 1) - p).cross(at(u + 1, v) - p).normalized();
      const Vector3d m = (p - at(u, v - 1)).cross(p - at(u - 1, v)).normalized();
      // Both sides of an edge differ.
      if (!(n.dot(m) > 0.9999) || p.z() <= 0.0) continue;
      normals[static_cast<std::size_t>(v * ideal.width + u)] = n.dot(p) < 0.0 ? n : Vector3d(-n);
    }
  return normals;
}

tracking::DepthImage roomSeen(const tracking::DepthCamera& camera, const std::vector<Box>& boxes,
                              std::uint64_t seed, int images) {
  const tracking::DepthImage ideal = rendered(camera, boxes);
  std::vector<tracking::DepthImage> noisy;
  for (int i = 0; i < images; ++i)
    noisy.push_back(tracking::seenByKinect(ideal, camera, tracking::kinectNoiseIn(camera), seed,
                                           static_cast<std::uint64_t>(i)));
  return tracking::stillImage(noisy);
}

RoomCase roomCase(const RoomPlan& plan, std::uint64_t seed, int width, int images, double move, double turn) {
  const std::array<tracking::DepthCamera, 2> cameras = camerasOf(seed, width);
  return roomCase(roomOf(plan, seed), cameras, seed, images, wrong(cameras[1].X_WC, move, turn, seed));
}

RoomCase roomCase(const std::vector<Box>& boxes, std::array<tracking::DepthCamera, 2> cameras,
                  std::uint64_t seed, int images, const Transform& start) {
  auto& [known, camera] = cameras;
  const tracking::DepthImage of_known = roomSeen(known, boxes, 2 * seed, images),
                             of_camera = roomSeen(camera, boxes, 2 * seed + 1, images);
  const Transform truth = camera.X_WC;
  camera.X_WC = start;
  return {tracking::RoomView(known, of_known), tracking::RoomView(camera, of_camera), truth};
}

}  // namespace abstand::testing
