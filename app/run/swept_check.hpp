// What happens between two frames of a scene.
#pragma once

#include <span>
#include <vector>

#include "core/safety/body_motion.hpp"
#include "core/safety/swept_pair.hpp"
#include "core/scene/scene.hpp"

namespace abstand::run {

/// Certified bounds on the distance of each pair over the time between two frames, in which every body goes
/// from pose to pose with its centre on a line and turns about one axis at a constant rate (PoseSegment). So
/// between two frames that are both far enough nothing is missed, however long the step: a fist that goes
/// through a tool, and is apart from it in both frames, is found. One thread; allocates in the first two
/// frames only.
class SweptCheck {
 public:
  explicit SweptCheck(const scene::Scene& scene) : scene_(scene) {}

  /// Of one pair, between the last frame and this one. lower <= smallest distance <= upper, m.
  struct Between {
    double t{0.0};  ///< s, of the smallest distance that was found
    double lower{kInfinity}, upper{kInfinity};
  };
  /// A new frame at `t` (s) with its results, in the scene's order. Nothing lies before the first one, nor
  /// between frames of the same or an earlier time: a jump back. `limits`: m, of each pair; what is certain
  /// to be above it is not looked at more closely.
  std::span<const Between> frame(double t, const std::vector<query::PairResult>& results,
                                 std::span<const double> limits);
  /// Of every object from the last frame but one to the last one; empty where nothing lies between.
  std::span<const safety::PoseSegment> motions() const { return motions_; }
  /// Pairs and times that were queried, so far.
  long queries() const { return queries_; }

 private:
  void begin(double t, const std::vector<query::PairResult>& results);

  const scene::Scene& scene_;
  std::vector<Between> between_;
  std::vector<Transform> poses_;                   ///< of the last frame
  std::vector<safety::DistanceSample> distances_;  ///< likewise
  std::vector<safety::PoseSegment> motions_;
  std::vector<double> speeds_;  ///< m/s, of them
  safety::SweptScratch scratch_;
  std::vector<query::PairMemory> memories_;
  double t_{kNaN};
  long queries_{0};
};

}  // namespace abstand::run
