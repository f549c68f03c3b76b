// Where a body is likely to be in a moment: by the weighted average of its last velocities.
#pragma once

#include "core/config/number_rule.hpp"
#include "core/math/object_motion.hpp"

namespace abstand::safety {

struct PredictionOptions {
  static constexpr const char* kName = "prediction";
  /// How much a step between two poses counts beside the one after it: 1 all alike, 0 the last one alone.
  double fade{0.7};
  /// s. A gap between poses longer than this, as when tracking was lost, starts the history anew.
  double longest_gap{0.2};

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("fade", o.fade, config::NumberRule{0.0, 1.0});
    visit("longest_gap", o.longest_gap, config::NumberRule{0.0, 60.0, "s", true});
  }
  void validate() const { config::requireNumbers(*this); }  ///< throws UsageError
};

/// Each body part is predicted by itself, so limbs may go different ways; averaging keeps the noise of single
/// poses out [Balan and Bone 2006, Real-time 3D collision avoidance method for safe human and robot
/// coexistence; thesis 2.1, its [2]]. The weights are ours and fall geometrically with age:
/// v = sum of fade^k way_k / sum of fade^k dt_k over the last kSteps steps, k = 0 the newest. It is a guess,
/// nothing is certified: that is what reach_set.hpp is for. One thread, no allocation.
class MotionPrediction {
 public:
  static constexpr int kSteps = 8;

  /// Throws UsageError for options that are not allowed. `centre_B` is the point of the body whose way is
  /// averaged, and about which it turns.
  explicit MotionPrediction(const PredictionOptions& options = {}, const Vector3d& centre_B = {0, 0, 0});

  void clear() noexcept;
  /// A measured pose at time t (s). What is not finite, or not after the last pose, is left out: false.
  bool add(double t, const Transform& X_WB) noexcept;

  bool started() const { return started_; }
  double t() const { return t_; }  ///< s, of the last pose
  /// Linear of the centre; zero with fewer than two poses. World axes.
  Twist velocity() const noexcept { return history_.fadedMean(options_.fade); }
  /// The pose `ahead` s after the last one, at constant velocity; the last pose itself for ahead <= 0.
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
