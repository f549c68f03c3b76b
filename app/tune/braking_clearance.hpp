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
  /// Successive pairs [begin, end).
  struct PairRange {
    std::size_t begin, end;
  };
  static Eigen::Map<Eigen::ArrayXd> values(std::vector<double>& of_pairs, const PairRange& range);
  static Eigen::Map<const Eigen::ArrayXd> values(const std::vector<double>& of_pairs, const PairRange& range);
  /// Sets the values of all pairs of a robot from the frames until it rests.
  void gather(std::size_t robot);
  double ofPair(std::size_t pair, const Halt& halt);
  /// m, without uncertainty, which only guides the search.
  double exact(std::size_t pair, const Halt& halt, double duration, double uncertainty);

  const session::Session& session_;
  const MotionWindow& window_;
  double limit_;
  std::vector<Halt> halts_;                         ///< of robots, from the oldest frame
  std::vector<std::vector<PairRange>> pairs_of_;    ///< of robots
  std::vector<std::vector<std::size_t>> links_of_;  ///< of robots: object indices
  /// Of pairs, until their robot rests: m, smallest certified distance without uncertainty, had it not
  /// braked; m, largest uncertainty.
  std::vector<double> in_step_, uncertainty_;
  /// m/s, of objects, until their robot rests: highest speed, and that on the path on which it brakes.
  std::vector<double> fastest_, braking_;
  std::vector<query::PairMemory> memories_;
  kernels::PairScratch scratch_;
  query::PairResult result_;
  long queries_{0};
};

}  // namespace abstand::tune
