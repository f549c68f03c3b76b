// Gain and limit of contact efforts.
#pragma once

#include <span>

#include "core/config/number_rule.hpp"

namespace abstand::control {

/// kEach: every joint is clipped to its own limit. kTogether: all are scaled by the same factor, which keeps
/// the direction in joint space and hence the direction in which the robot yields.
enum class TorqueCut { kEach, kTogether };

struct TorqueLimitOptions {
  static constexpr const char* kName = "torque";
  double gain{1.0};                       ///< on the contact efforts; found by trial in the thesis
  config::JointNumbers limit{kInfinity};  ///< N m or N, absolute value, of each joint or one for all
  TorqueCut cut{TorqueCut::kTogether};

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("gain", o.gain, config::NumberRule{0.0, 1e6});
  }
  template <class Self, class Visit>
  static void eachList(Self& o, Visit visit) {
    visit("limit", o.limit, config::NumberRule{0.0, kInfinity, "N m or N"});
  }
};

/// "Transformed empirically into an acceptable torque range through a gain and limited to a maximum" [thesis
/// 5.4]: tau_i = sat(gain tau_i, +-limit_i). One thread, no allocation after construction.
class TorqueLimit {
 public:
  /// Throws UsageError for options that are not valid for `dof` joints.
  TorqueLimit(const TorqueLimitOptions& options, int dof);

  double gain() const { return gain_; }
  double limit(int joint) const { return max_torque_[static_cast<std::size_t>(joint)]; }
  /// Clips the torques in place, without the gain. Returns the joint that exceeded its limit most, or -1.
  /// Values that are not finite become 0 and count as exceeding.
  int cut(std::span<double> torque) const noexcept;
  /// gain * efforts, clipped. Sizes are dof.
  int update(std::span<const double> efforts, std::span<double> torque) const noexcept;

 private:
  double gain_;
  TorqueCut cut_;
  config::JointNumbers max_torque_;
};

}  // namespace abstand::control
