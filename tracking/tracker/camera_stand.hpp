// Estimates the pose of a depth camera whose pose is unknown.
#pragma once

#include <optional>
#include <string>

#include "tracking/depth/people/people_finder.hpp"

namespace abstand::tracking {

/// Searches a floor plane in the first images. If none is found until five images have shown a person, the
/// camera is assumed level, above a floor at the lowest point of these persons. If the lower border of most
/// of these images cuts them off, their feet are lower: the floor is then assumed at their stature below the
/// highest point, unless they were seen lower. World frame: z up, x along
/// the horizontal part of the optical axis, origin below the camera. One thread.
class CameraStand {
 public:
  /// `stature` (m) of a person who is cut off; unset: the usual one.
  explicit CameraStand(const DepthCamera& camera, std::optional<double> stature = std::nullopt);

  /// Processes the next image, `t` (s) increases; true once decided, further images are ignored.
  bool see(double t, const DepthImage& image);
  /// Decides from the images so far.
  void settle();

  const Transform& X_WC() const { return X_WC_; }
  /// Explanation of the decision, for messages.
  const std::string& reason() const { return reason_; }

 private:
  DepthCamera camera_;
  double stature_;
  PeopleFinder finder_;
  double low_{kInfinity}, high_{-kInfinity};  ///< m, z of the lowest and highest point seen of a person,
                                              ///< level camera at 0
  int seen_{0};                               ///< images since a person was first seen
  int cut_off_{0};                            ///< of these, with a person at the lower border
  Transform X_WC_;
  std::string reason_;
};

}  // namespace abstand::tracking
