// What of a surface a depth camera sees at one moment.
#pragma once

#include <span>
#include <vector>

#include "app/coverage/cause.hpp"
#include "app/coverage/sensor.hpp"
#include "tracking/depth/calibration/surface_samples.hpp"
#include "tracking/depth/simulator/depth_render.hpp"

namespace abstand::coverage {

/// Depth images of the occluders of a scene, one for the robots, one for the things, one for each person. Not
/// shared between threads.
class OcclusionView {
 public:
  /// m. The own body hides a surface only if it is farther in front of it. The tracker counts a pixel with
  /// such a depth as that of the segment (kSeenWithin in tracking/tracker/depth_fit.cpp): overlapping ends of
  /// neighbouring parts hide nothing.
  static constexpr double kOwnGap = 0.08;
  /// m, likewise for all other bodies: a tenth of that, above the depth differences within a pixel.
  static constexpr double kOtherGap = 0.008;

  /// Images of at most `columns`.
  OcclusionView(const Sensor& sensor, std::size_t people, int columns);

  void clear();
  void drawRobot(const geometry::TriangleMesh& mesh, const Transform& X_WB) { draw(kRobots, mesh, X_WB); }
  void drawThing(const geometry::TriangleMesh& mesh, const Transform& X_WB) { draw(kThings, mesh, X_WB); }
  void drawPerson(std::size_t person, const geometry::TriangleMesh& mesh, const Transform& X_WB) {
    draw(kPeople + person, mesh, X_WB);
  }

  /// By cause, of the part of a person's surface that faces the camera. Each sample of it weighs as the solid
  /// angle that it takes up at the camera, so the shares are those of the pixels that a convex part would
  /// fill in an image without borders. A part around the camera faces it nowhere: out of range. What is in
  /// front counts by the nearest body.
  Shares shares(std::size_t person, std::span<const tracking::SurfaceSample> samples,
                const Transform& X_WB) const;

  int columns() const { return camera_.width; }
  int rows() const { return camera_.height; }

 private:
  static constexpr std::size_t kRobots = 0, kThings = 1, kPeople = 2;
  void draw(std::size_t layer, const geometry::TriangleMesh& mesh, const Transform& X_WB);
  Cause causeOf(std::size_t person, const Vector3d& p_C) const;

  tracking::DepthCamera camera_;
  double nearest_, farthest_;  ///< m
  Transform X_CW_;
  std::vector<tracking::DepthRender> layers_;
};

}  // namespace abstand::coverage
