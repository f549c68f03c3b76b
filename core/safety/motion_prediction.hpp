// Short-term motion prediction by a weighted average of the last velocities.
#pragma once

#include "core/config/number_rule.hpp"
#include "core/math/object_motion.hpp"

namespace abstand::safety {

struct PredictionOptions {
  static constexpr const char* kName = "prediction";
  /// Weight of a step relative to the next one: 1: all equal, 0: only the last step.
  double fade{0.7};
  /// s. A longer gap between poses, as after a loss of tracking, restarts the history.
  double longest_gap{0.2};

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("fade", o.fade, config::NumberRule{0.0, 1.0});
    visit("longest_gap", o.longest_gap, config::NumberRule{0.0, 60.0, "s", true});
  }
  void validate() const { config::requireNumbers(*this); }  ///< throws UsageError
};

/// Constant-velocity prediction of a body. Each body part is predicted by itself, so limbs may move
/// differently; averaging suppresses the noise of single poses [Balan and Bone 2006, Real-time 3D collision
/// avoidance method for safe human and robot coexistence; thesis 2.1, its [2]]. Weights decrease
/// geometrically with age (own choice): v = sum of fade^k d_k / sum of fade^k dt_k over the last kSteps
/// displacements d_k, k = 0 the newest. An estimate without certificate; for certified bounds see
/// reach_set.hpp. One thread, no allocation.
class MotionPrediction {
 public:
  static constexpr int kSteps = 8;

  /// Throws UsageError for invalid options. `centre_B`: point of the body whose displacement is averaged, and
  /// centre of its rotation.
  explicit MotionPrediction(const PredictionOptions& options = {}, const Vector3d& centre_B = {0, 0, 0});

  void clear() noexcept;
  /// Adds a measured pose at time t (s). False, and ignored, if it is not finite or not later than the last
  /// pose.
  bool add(double t, const Transform& X_WB) noexcept;

  bool started() const { return started_; }
  double t() const { return t_; }  ///< s, of the last pose
  /// Linear velocity of the centre and angular velocity, world axes; zero with fewer than two poses.
  Twist velocity() const noexcept { return history_.fadedMean(options_.fade); }
  /// Predicted pose `ahead` s after the last one, at constant velocity; the last pose for ahead <= 0.
  Transform at(double ahead) const noexcept;

 private:
  PredictionOptions options_;
  Vector3d centre_B_;
  MotionHistory<kSteps + 1> history_;
  Transform X_WB_{Transform::Identity()};
  double t_{0.0};
  bool started_{false};
};

}  // namespace abstand::safety
