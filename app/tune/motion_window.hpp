// Sliding window over the last frames of a pass and the motion between them.
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "app/tune/halt.hpp"
#include "app/tune/watched_pairs.hpp"
#include "core/safety/body_motion.hpp"

namespace abstand::tune {

/// One frame. Lists for pairs are in the order of the watched ones, lists for objects in that of the scene.
/// Members "to next" refer to the interval to the next frame and are set when that one arrives.
struct WindowFrame {
  double t{0.0};
  std::vector<Transform> X_WB;
  std::vector<double> q;                   ///< of all robots, concatenated
  std::vector<double> distance, bound;     ///< m, of pairs
  std::vector<Vector3d> on_part, on_link;  ///< m, world, of pairs: nearest points
  std::vector<double> clearance;           ///< m, of pairs: distance - bound - uncertainty
  std::vector<double> uncertainty;         ///< m, of pairs
  std::vector<double> age_uncertainty;     ///< m, of pairs: share of it due to the age of poses
  std::vector<bool> lost;                  ///< of pairs: a pose is stale or was rejected
  std::vector<double> between;  ///< to next: m, of pairs: certified least distance, without uncertainty
  std::vector<safety::PoseSegment> motion;  ///< to next, of objects
  std::vector<double> speed;                ///< to next: m/s, of objects: speed of the fastest point
  std::vector<double> braking_time;         ///< to next: s, of robots: braking time from the speed of the
                                            ///< path
};

/// What is not known of poses besides what the scene says.
struct ExtraUncertainty {
  double calibration_error{0.0};  ///< m, of each pair (PassOptions)
  std::vector<double> latency{};  ///< m, of each object (latencyUncertainty); empty: none
};

/// A window over the frames of a recording. One thread.
class MotionWindow {
 public:
  MotionWindow(const session::Session& session, std::vector<WatchedPair> pairs, const BrakingOptions& options,
               ExtraUncertainty extra);

  /// m, of a pair: share of its uncertainty due to the latency of the person's pose.
  double latencyOf(const WatchedPair& pair) const {
    return extra_.latency.empty() ? 0.0 : extra_.latency[pair.part];
  }
  /// m, of a pair now: of both poses in the scene, and what is added to it.
  double uncertaintyOf(const WatchedPair& pair) const;

  /// Adds a frame. From the last frame to this one (SweptCheck; empty in the first frame): `between` of the
  /// scene's pairs, and `motions` of its objects.
  void add(double t, const std::vector<query::PairResult>& results, std::span<const double> between,
           std::span<const safety::PoseSegment> motions);
  void drop() {
    spare_.push_back(std::move(frames_.front()));
    frames_.pop_front();
  }
  /// Declares that no more frames follow.
  void finish() { finished_ = true; }

  bool empty() const { return frames_.empty(); }
  bool finished() const { return finished_; }
  const std::deque<WindowFrame>& frames() const { return frames_; }
  std::deque<WindowFrame>& frames() { return frames_; }
  const std::vector<WatchedPair>& pairs() const { return pairs_; }
  /// Index of the last frame at or before time `t`; the first one for earlier times.
  std::size_t indexAt(double t) const;

  /// Braking of the robot if commanded to stop at the oldest frame. nullopt if frames are needed that have
  /// not arrived yet.
  std::optional<Halt> haltOfFirst(std::size_t robot) const;

 private:
  WindowFrame emptyFrame();

  const session::Session& session_;
  std::vector<WatchedPair> pairs_;
  BrakingOptions options_;
  ExtraUncertainty extra_;
  std::deque<WindowFrame> frames_;
  std::vector<bool> lost_;          ///< of objects, in the frame that is added
  std::vector<WindowFrame> spare_;  ///< dropped ones, whose memory is used again
  bool finished_{false};
};

}  // namespace abstand::tune
