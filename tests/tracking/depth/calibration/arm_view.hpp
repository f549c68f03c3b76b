// An arm of plain shapes in a room, as a Kinect sees it.
#pragma once

#include <memory>
#include <vector>

#include "core/geometry/surface.hpp"
#include "tracking/depth/calibration/surface_search.hpp"

namespace abstand::testing {

inline Transform movedTo(const Vector3d& p) { return Transform(Eigen::Translation3d(p)); }

/// A column, an upper arm and a forearm, whose elbow is bent by `bend` (rad); 1.3 m high, at the origin.
struct PlainArm {
  PlainArm();
  static std::vector<Transform> at(double bend);

  std::vector<std::unique_ptr<geometry::Surface>> surfaces;
  std::vector<const geometry::Surface*> bodies;
};

/// 320 x 240, looking from `eye` at `target`.
tracking::DepthCamera smallKinect(const Vector3d& eye, const Vector3d& target);

/// What a Kinect sees of the bodies, a floor, a wall, a table beside them and a ball in front.
tracking::SurfaceView armSeen(const tracking::DepthCamera& camera,
                              const std::vector<const geometry::Surface*>& bodies,
                              const std::vector<Transform>& X_WB, std::uint64_t seed);

}  // namespace abstand::testing
