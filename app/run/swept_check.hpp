// Certified distances between two frames of a scene.
#pragma once

#include <span>
#include <vector>

#include "core/safety/body_motion.hpp"
#include "core/safety/swept_pair.hpp"
#include "core/scene/scene.hpp"

namespace abstand::run {

/// Certified bounds on the distance of each pair over the time between two frames, assuming that every body
/// moves from pose to pose with its centre on a line and a constant rotation rate about one axis
/// (PoseSegment). Nothing is missed between frames, however long the step: a fist that passes through a tool,
/// and is apart from it in both frames, is found. One thread; allocates in the first two frames only.
class SweptCheck {
 public:
  explicit SweptCheck(const scene::Scene& scene);
  /// Only these pairs are looked at.
  SweptCheck(const scene::Scene& scene, std::vector<PairId> pairs)
      : scene_(scene), pairs_(std::move(pairs)) {}

  /// Result of one pair, between the last frame and this one. lower <= smallest distance <= upper, m.
  struct Between {
    double t{0.0};  ///< s, time of the smallest distance found
    double lower{kInfinity}, upper{kInfinity};
  };
  /// Processes a new frame at `t` (s) with its results, in scene order. Empty for the first frame and if time
  /// does not increase (a jump back). `limits`: m, for each pair; the search stops once the distance is
  /// certified above.
  std::span<const Between> frame(double t, const std::vector<query::PairResult>& results,
                                 std::span<const double> limits);
  /// Motion of every object from the last frame but one to the last one; empty if there is none.
  std::span<const safety::PoseSegment> motions() const { return motions_; }
  /// Number of queries so far.
  long queries() const { return queries_; }

 private:
  void begin(double t, const std::vector<query::PairResult>& results);

  const scene::Scene& scene_;
  std::vector<PairId> pairs_;  ///< that are looked at
  std::vector<Between> between_;
  std::vector<Transform> poses_;                   ///< in the last frame
  std::vector<safety::DistanceSample> distances_;  ///< likewise
  std::vector<safety::PoseSegment> motions_;
  std::vector<double> speeds_;  ///< m/s, of the motions
  safety::SweptScratch scratch_;
  std::vector<query::PairMemory> memories_;
  double t_{kNaN};
  long queries_{0};
};

}  // namespace abstand::run
