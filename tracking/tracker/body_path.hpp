// Poses of a body over time.
#pragma once

#include <vector>

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// Poses of a body in the first kMaxPoses images in which it was found. One thread. Allocates.
class BodyPath {
 public:
  struct Point {
    double t;  ///< s
    RigPose pose;
  };
  static constexpr std::size_t kMaxPoses = 300;

  /// `t` increases. Ignored if there are enough poses.
  void add(double t, const RigPose& pose);
  /// Turns each pose round in place.
  void turn();
  /// The pose nearest in time; null if there is none.
  const Point* nearest(double t) const;
  /// s, of the first pose; infinite if there is none.
  double start() const { return points_.empty() ? kInfinity : points_.front().t; }

 private:
  std::vector<Point> points_;
};

}  // namespace abstand::tracking
