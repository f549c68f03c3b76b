#include "app/coverage/sensor.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "tracking/depth/simulator/kinect_noise.hpp"

namespace abstand::coverage {
namespace {

constexpr double kKinectV2Nearest = 0.5, kKinectV2Farthest = 4.5;  // m

Sensor withKinectRange(const tracking::DepthCamera& camera) {
  const tracking::KinectNoise kinect;
  return {camera, kinect.nearest, kinect.farthest};
}

}  // namespace

std::vector<std::string> sensorNames() { return {"kinect", "kinect_v2"}; }

Sensor sensorNamed(const std::string& name) {
  if (name == "kinect") return withKinectRange({});
  if (name != "kinect_v2") throw UsageError("found the sensor '" + name + "', expected kinect or kinect_v2");
  tracking::DepthCamera camera;
  camera.width = 512;
  camera.height = 424;
  camera.fx = camera.fy = 365.5;
  camera.cx = 255.5;
  camera.cy = 211.5;
  return {camera, kKinectV2Nearest, kKinectV2Farthest};
}

Sensor sensorOfFile(const std::filesystem::path& file) {
  Sensor sensor = withKinectRange(tracking::loadDepthCamera(file));
  sensor.camera.distortion.setZero();
  return sensor;
}

tracking::DepthCamera reduced(const tracking::DepthCamera& camera, int columns) {
  if (camera.width <= columns) return camera;
  tracking::DepthCamera small = camera;
  small.width = columns;
  small.height = std::max(1, static_cast<int>(std::lround(1.0 * camera.height * columns / camera.width)));
  const double across = static_cast<double>(small.width) / camera.width;
  const double down = static_cast<double>(small.height) / camera.height;
  small.fx *= across;
  small.fy *= down;
  // The centre of the first pixel is at 0, the edge of the image half a pixel before.
  small.cx = (camera.cx + 0.5) * across - 0.5;
  small.cy = (camera.cy + 0.5) * down - 0.5;
  return small;
}

}  // namespace abstand::coverage
