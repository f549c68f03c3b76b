// Where a depth camera stands that does not say it.
#pragma once

#include <string>

#include "tracking/depth/people/people_finder.hpp"

namespace abstand::tracking {

/// Looks for a floor in the first images. Without one until five images showed somebody, the camera is taken
/// to be level, over a floor on which the lowest person of these stands. The world is then z up, x along the
/// level part of the optical axis, the origin below the camera. One thread.
class CameraStand {
 public:
  explicit CameraStand(const DepthCamera& camera);

  /// The next image, `t` (s) rises; true once it is decided, and nothing more is looked at.
  bool see(double t, const DepthImage& image);
  /// Decides by the images that there were.
  void settle();

  const Transform& X_WC() const { return X_WC_; }
  /// How it was decided, for people.
  const std::string& reason() const { return reason_; }

 private:
  DepthCamera camera_;
  PeopleFinder finder_;
  double low_{kInfinity};  ///< m, z of the lowest that was seen of a person, the level camera at 0
  int seen_{0};            ///< images since somebody was seen
  Transform X_WC_;
  std::string reason_;
};

}  // namespace abstand::tracking
