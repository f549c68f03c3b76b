// Looks for the pose of a camera, roughly, in which known things explain its depth images.
#pragma once

#include "tracking/depth/calibration/surface_samples.hpp"
#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// An image, and where the known bodies were.
struct SurfaceView {
  DepthImage image;
  std::vector<Transform> X_WB;  ///< of each body
};

/// How well known surfaces explain images, by points on them: a point that faces the camera should be where
/// the pixel that it falls on has its depth. Where the camera sees past it, it is not there; where something
/// is nearer, it may be hidden.
class SurfaceSearch {
 public:
  /// Without distortion. The views must outlive this.
  SurfaceSearch(const DepthCamera& camera, std::span<const geometry::Surface* const> bodies,
                std::span<const SurfaceView> views, std::uint64_t seed);

  /// Up to `most` poses with the least cost, best first, of some thousands around camera.X_WC: within
  /// kReach (m) and kTurn (rad) along and about each axis, then nearer and nearer to the best ones.
  std::vector<Transform> search(std::size_t most);
  /// Mean over the points that face the camera, 0 to 1; `tolerance` in m.
  double cost(const Transform& X_WC, double tolerance) const;
  /// Of the points that face the camera at measured pixels and are not hidden: the share that is there.
  double explained(const Transform& X_WC) const;

  static constexpr double kReach = 0.12, kTurn = 0.21;  ///< m, rad (12 degrees)

 private:
  struct Point {
    Vector3d p_W, n_W;
    std::size_t view;
  };
  /// Calls visit(behind, z) for each point that faces the camera: m that the measured surface lies behind it,
  /// NaN where nothing was measured or the pixel is beside the image, and its depth.
  template <class Visit>
  void look(const Transform& X_WC, const Visit& visit) const;

  DepthCamera camera_;
  std::span<const SurfaceView> views_;
  std::vector<Point> points_;
  std::uint64_t seed_;
};

}  // namespace abstand::tracking
