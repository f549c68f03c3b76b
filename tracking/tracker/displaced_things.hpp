// How far known things are from where they are said to be, and the band around them that hides.
#pragma once

#include <array>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Measures the displacement of known things, as a robot whose joint values are not accurate, in depth
/// images: of each rendered point that nothing hides, the distance to the nearest measured one. Those of a
/// round or flat link that is displaced by d are between 0 and d, evenly distributed over what of it moved.
/// What is nearer to the camera than kFarthest hides the things, unless it is that near to them. One thread.
/// Does not allocate.
class DisplacedThings {
 public:
  /// `known` (m; 0: none): the things, rendered for `image`, which has the same size as `camera`'s. Earlier
  /// images count by `kept` times as much, if any point is compared, which is returned.
  bool add(const DepthImage& image, const DepthImage& known, const DepthCamera& camera, double kept = 1.0);

  /// Share of the points that are within kFarthest of a measured one; NaN: no point was compared.
  double share() const;
  /// Most of kFewest points or more are.
  bool areNear() const { return points_ >= kFewest && share() >= kNear; }
  /// m, estimate of the largest displacement: the kQuantile of the distances of those points, as a share of
  /// it. 0: none was compared.
  double displacement() const;
  /// m: what is so near to the things may be part of them. 0: they are where they are said to be, within the
  /// noise of the depths (noiseAt() at their mean depth). Otherwise the displacement and kMargin.
  double band() const;

  static constexpr double kFarthest = 0.15;  ///< m; things farther away are elsewhere
  static constexpr double kNear = 0.6;
  static constexpr double kFewest = 100.0;
  static constexpr double kQuantile = 0.95;
  static constexpr double kMargin = 0.02;  ///< m
  /// m, at depth z (m): 1.2 to 1.7 times what robots in their place had, 10 mm at 1.9 m to 40 mm at 4.8 m,
  /// by the depth steps of a Kinect and the edges that it does not see.
  static double noiseAt(double z) { return 0.010 + 0.002 * z * z; }

 private:
  static constexpr std::size_t kBins = 30;
  void forget(double kept);

  std::array<double, kBins> near_{};  // points by distance, up to kFarthest
  double points_{0.0}, depths_{0.0};  // number, and the sum of their depths (m)
};

/// Images of known things with a band around them. One thread. Allocates at the first image of a size.
class BandedThings {
 public:
  /// `known`, with all that is within `band` (m) of the surfaces towards the camera and to the sides, as
  /// balls around them. The result is valid until the next call; without a band it is `known` itself.
  const DepthImage& around(const DepthImage& known, const DepthCamera& camera, double band);

 private:
  void stamp(const DepthImage& known, const DepthCamera& camera, int u, int v, double band);
  DepthImage banded_;
};

}  // namespace abstand::tracking
