// The last frames of a pass, and what happens between them.
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "app/tune/halt.hpp"
#include "app/tune/watched_pairs.hpp"
#include "core/safety/body_motion.hpp"

namespace abstand::tune {

/// One frame; lists for pairs are in the order of the watched ones, lists for objects in that of the scene.
/// What is named "to next" holds until the next frame and is filled when that one comes.
struct WindowFrame {
  double t{0.0};
  std::vector<Transform> X_WB;
  std::vector<double> q;                   ///< of all robots, one after the other
  std::vector<double> distance, bound;     ///< m, of pairs
  std::vector<Vector3d> on_part, on_link;  ///< m, world, of pairs: the nearest points
  std::vector<double> clearance;           ///< m, of pairs: distance - bound - uncertainty
  std::vector<double> uncertainty;         ///< m, of pairs
  std::vector<bool> lost;                  ///< of pairs: a pose is stale or was rejected
  std::vector<double> between;  ///< to next: m, of pairs: certified least distance, without uncertainty
  std::vector<safety::PoseSegment> motion;  ///< to next, of objects
  std::vector<double> speed;                ///< to next: m/s, of objects, of the fastest point
  std::vector<double> braking_time;         ///< to next: s, of robots, from the speed of the path to rest
};

/// A window over the frames of a recording. One thread.
class MotionWindow {
 public:
  /// `calibration_error`: m, added to what is not known of a pair (PassOptions).
  MotionWindow(const session::Session& session, std::vector<WatchedPair> pairs, const BrakingOptions& options,
               double calibration_error);

  /// From the last frame to this one (SweptCheck), empty in the first frame: `between` of the scene's pairs,
  /// and `motions` of its objects.
  void add(double t, const std::vector<query::PairResult>& results, std::span<const double> between,
           std::span<const safety::PoseSegment> motions);
  void drop() { frames_.pop_front(); }
  /// No frame comes any more.
  void finish() { finished_ = true; }

  bool empty() const { return frames_.empty(); }
  bool finished() const { return finished_; }
  const std::deque<WindowFrame>& frames() const { return frames_; }
  std::deque<WindowFrame>& frames() { return frames_; }
  const std::vector<WatchedPair>& pairs() const { return pairs_; }
  /// Number of the last frame at or before time `t`; the first one for earlier times.
  std::size_t indexAt(double t) const;

  /// How the robot comes to rest that is told to stop at the oldest frame. Nothing where frames are missing
  /// that are still to come.
  std::optional<Halt> haltOfFirst(std::size_t robot) const;

 private:
  const session::Session& session_;
  std::vector<WatchedPair> pairs_;
  BrakingOptions options_;
  double calibration_error_;
  std::deque<WindowFrame> frames_;
  bool finished_{false};
};

}  // namespace abstand::tune
