// Global search for the camera pose in which known bodies explain depth images.
#pragma once

#include "tracking/depth/calibration/surface_samples.hpp"
#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// A depth image and the poses of the known bodies.
struct SurfaceView {
  DepthImage image;
  std::vector<Transform> X_WB;  ///< of each body
};

/// Consistency of known surfaces with images, by sample points: a point that faces the camera should have the
/// depth of the pixel it projects to. If the camera sees past it, it is missing; if something is nearer, it
/// may be occluded.
class SurfaceSearch {
 public:
  /// `camera` without distortion. The views must outlive this object.
  SurfaceSearch(const DepthCamera& camera, std::span<const geometry::Surface* const> bodies,
                std::span<const SurfaceView> views, std::uint64_t seed);

  /// Up to `max_count` poses with the lowest cost, best first, from some thousands around camera.X_WC: within
  /// kReach (m) and kTurn (rad) along and about each axis, then in decreasing ranges around the best ones.
  std::vector<Transform> search(std::size_t max_count);
  /// Mean cost, 0 to 1, over the points that face the camera; `tolerance` in m, at least two standard
  /// deviations of the depth.
  double cost(const Transform& X_WC, double tolerance) const;
  /// Share of matching points among those that face the camera at measured pixels and are not occluded.
  double explained(const Transform& X_WC) const;

  static constexpr double kReach = 0.12, kTurn = 0.21;  ///< m, rad (12 degrees)

 private:
  struct Point {
    Vector3d p_W, n_W;
    std::size_t view;
  };
  /// Calls visit(behind, z) for each point that faces the camera: distance (m) of the measured surface behind
  /// it, NaN without measurement or outside of the image, and its depth.
  template <class Visit>
  void forEachVisible(const Transform& X_WC, const Visit& visit) const;

  DepthCamera camera_;
  std::span<const SurfaceView> views_;
  std::vector<Point> points_;
  std::uint64_t seed_;
};

}  // namespace abstand::tracking
