// What a scene certifies of a tracked person against the true body.
#pragma once

#include "tests/tracking/tracker/simulated_clip.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::testing {

/// Balls of kBall on a ring about the place of the person, at several heights and distances, so that
/// different parts are the nearest ones. For each image and ball: certified distance, which is the smallest
/// over the parts of the tracked person of distance - bound - pose uncertainty, and true distance to the skin
/// of the true body.
struct CertifiedDistances {
  std::vector<double> certified,
      of_radius;                         ///< m; along the nearest points, and with the pose uncertainty alone
  std::vector<double> truth;             ///< m, 0 where the true body touches the ball
  static constexpr double kBall = 0.10;  ///< m, radius

  double held() const;              ///< share with certified <= true; 1 without any
  double largestViolation() const;  ///< m, certified - true
  /// m: median of true - certified distance: what the certified distance gives away. NaN without any.
  static double medianSlack(const std::vector<double>& certified, const std::vector<double>& truth);
  void add(const CertifiedDistances& other);
};

/// Of the person who was found in the most images, in all images from the first to the last with the person,
/// also those in which the person was lost. The scene is posed as for a recording of the tracked joints.
CertifiedDistances certifiedDistances(const SimulatedClip& clip, const tracking::ClipTrack& track);

}  // namespace abstand::testing
