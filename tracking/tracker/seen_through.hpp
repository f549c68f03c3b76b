// People whom one camera measures where another one sees through.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// An image of a camera with a pose in the world. `labels`: not 0 for pixels of people.
struct LabelledImage {
  const DepthImage* image;
  const DepthCamera* camera;
  std::span<const std::uint8_t> labels;
};

/// Points of people of one camera in the view of another one. If both poses are right, none of them is
/// clearly in front of what the other one measures: a wrong pose puts the edge of a body into free space.
struct SeenThrough {
  std::size_t compared{0};  ///< points at which the other camera measures a depth
  /// m, of those that it sees through by more than farFrom(), to all sides: how far aside the nearest pixel
  /// that does not see through is, up to kFarthest.
  std::vector<double> off;

  double share() const {
    return compared > 0 ? static_cast<double>(off.size()) / static_cast<double>(compared) : 0.0;
  }
  void add(const LabelledImage& from, const LabelledImage& to);

  /// m, estimate of the displacement: the kQuantile of `off`, as a share of it. 0: none.
  double displacement() const;

  static constexpr double kFarthest = 0.4;  ///< m
  static constexpr double kQuantile = 0.9;
  /// m, at depth z (m): nearer points are there within the noise of both cameras.
  static double farFrom(double z) { return 0.03 + 0.003 * z * z; }
};

}  // namespace abstand::tracking
