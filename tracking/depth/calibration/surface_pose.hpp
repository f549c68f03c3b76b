// Where a camera stands, from depth images of things whose surfaces and places are known, like a robot's
// links.
#pragma once

#include "tracking/depth/calibration/surface_search.hpp"

namespace abstand::tracking {

struct SurfaceFit {
  Transform X_WC{Transform::Identity()};
  double rms{0.0};                 ///< m, weighted, of the distances from measured points to the surfaces
  std::size_t points{0};           ///< measured points that count, by their weights
  double explained{0.0};           ///< share of what would be seen of the bodies that is there
  double moved{0.0}, turned{0.0};  ///< m, rad, from the start
  /// m, standard deviation of an axis of a point that the camera sees: rms and the covariance of the pose, as
  /// for boards (board_pose.hpp). rms is not divided by the root of the points' number, since a camera's
  /// error of depth and a robot's of its joints do not average out.
  double spread{0.0};
};

/// From a start camera.X_WC that is wrong by up to SurfaceSearch::kReach and kTurn. Rough poses of
/// SurfaceSearch, then Gauss-Newton on the signed distance of measured points to the nearest surface (its
/// gradient is the row; Chen, Medioni 1991), of points whose normals agree, with weights of Geman and McClure
/// whose width follows the median. Needs no segmentation: what is not near a body does not count.
/// Throws UsageError where fewer than 150 points see the bodies, where less than half of what would be seen
/// is there, and where the bodies leave a freedom open, as a ball does. The same for the same seed.
SurfaceFit fitPoseToSurfaces(const DepthCamera& camera, std::span<const geometry::Surface* const> bodies,
                             std::span<const SurfaceView> views, std::uint64_t seed);

}  // namespace abstand::tracking
