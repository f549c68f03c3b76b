// How near a person comes while the robot is brought to rest.
#pragma once

#include "app/tune/motion_window.hpp"
#include "core/safety/swept_pair.hpp"

namespace abstand::tune {

/// Certified least clearance of each watched pair from the oldest frame of a window until the robot, told to
/// stop there, is at rest. The link goes along its own path with a falling pace (Halt), the person as
/// recorded; both between frames as PoseSegment. Nothing lies behind the last frame of a recording. One
/// thread.
class BrakingClearance {
 public:
  /// m: pairs that certainly stay farther than `limit` + kExact are not looked at more closely.
  static constexpr double kExact = 0.02;

  BrakingClearance(const session::Session& session, const MotionWindow& window, double limit);

  /// Of all pairs into `out`, in their order; +infinity where the link does not move. False where frames are
  /// missing that are still to come.
  bool ofFirst(std::vector<double>& out);
  long queries() const { return queries_; }

 private:
  double ofPair(std::size_t pair, const Halt& halt);
  /// m, without uncertainty, by which only the search is guided.
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
