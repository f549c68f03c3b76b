// Registration of two point clouds without correspondences.
#pragma once

#include <memory>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::tracking {

/// Two clouds, thinned by voxel grids from coarse to fine, aligned by generalised ICP (Segal, Haehnel, Thrun,
/// RSS 2009): plane to plane, with the nearest point within a distance that shrinks. Wraps PCL. Not shared
/// between threads.
class CloudRegistration {
 public:
  /// Points (m) of each cloud in its own frame.
  CloudRegistration(const std::vector<Vector3d>& source, const std::vector<Vector3d>& target);
  ~CloudRegistration();
  CloudRegistration(const CloudRegistration&) = delete;
  CloudRegistration& operator=(const CloudRegistration&) = delete;

  /// Pose of the source's frame in that of the target, from a start; the start itself if the clouds have too
  /// few points or no neighbours within the first distance.
  Transform align(const Transform& X_TS) const;

 private:
  struct Clouds;
  std::unique_ptr<Clouds> clouds_;
};

}  // namespace abstand::tracking
