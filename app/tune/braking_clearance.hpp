// Clearance of a person while the robot brakes to a stop.
#pragma once

#include "app/tune/motion_window.hpp"
#include "core/safety/swept_pair.hpp"

namespace abstand::tune {

/// Certified minimum clearance of each watched pair from the oldest frame of a window until the robot,
/// commanded to stop there, is at rest. The link follows its own path at a decreasing pace (Halt), the person
/// the recording; both are interpolated by PoseSegment. The time after the last frame of a recording is not
/// considered. One thread.
class BrakingClearance {
 public:
  /// m: pairs certainly farther than `limit` + kExact are not refined.
  static constexpr double kExact = 0.02;

  BrakingClearance(const session::Session& session, const MotionWindow& window, double limit);

  /// Sets `out` for all pairs, in order; +infinity if the link does not move. False if frames are needed that
  /// have not arrived yet.
  bool ofFirst(std::vector<double>& out);
  long queries() const { return queries_; }

 private:
  double ofPair(std::size_t pair, const Halt& halt);
  /// m, without uncertainty, which only guides the search.
  double exact(std::size_t pair, const Halt& halt, double duration, double uncertainty);

  const session::Session& session_;
  const MotionWindow& window_;
  double limit_;
  std::vector<Halt> halts_;
  std::vector<query::PairMemory> memories_;
  kernels::PairScratch scratch_;
  query::PairResult result_;
  long queries_{0};
};

}  // namespace abstand::tune
