// Camera pose from depth images of bodies with known surfaces and poses, such as a robot's links.
#pragma once

#include "tracking/depth/calibration/surface_search.hpp"

namespace abstand::tracking {

struct SurfaceFit {
  Transform X_WC{Transform::Identity()};
  double rms{0.0};                 ///< m, weighted, distances from measured points to the surfaces
  std::size_t points{0};           ///< number of measured points used, by weight
  double explained{0.0};           ///< share of the expected visible surface that is observed
  double moved{0.0}, turned{0.0};  ///< m, rad, change from the start pose
  /// m, standard deviation along the worst axis of the camera's position, and of points as far from the
  /// bodies, 1 m at least: rms and covarianceOf() the pose, by spreadWithin(). rms is not divided by the
  /// square root of the number of points, since depth errors of a camera and joint errors of a robot do not
  /// average out. The covariance grows with the distance of the camera, which is the lever arm of its
  /// rotation about the bodies.
  double spread{0.0};
};

/// Pose from a start camera.X_WC with an error up to SurfaceSearch::kReach and kTurn. Coarse poses by
/// SurfaceSearch, then Gauss-Newton on the distances of measured points from the surfaces that their rays
/// meet, along the normals (Chen, Medioni 1991), within three standard deviations of the depth, 25 mm at
/// least, with Geman-McClure weights whose scale follows the median. Needs no segmentation: points far from
/// all bodies are ignored. Throws UsageError if fewer than 150 points see the bodies, if less than half of
/// the expected visible surface is observed, if the bodies leave a degree of freedom undetermined, as a ball
/// does, and if the spread exceeds 0.1 m. Deterministic for a seed.
SurfaceFit fitPoseToSurfaces(const DepthCamera& camera, std::span<const geometry::Surface* const> bodies,
                             std::span<const SurfaceView> views, std::uint64_t seed);

}  // namespace abstand::tracking
