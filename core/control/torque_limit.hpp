// Contact efforts made fit for a robot: a gain and a limit.
#pragma once

#include <span>

#include "core/config/number_rule.hpp"

namespace abstand::control {

/// kEach: every joint is cut at its own limit. kTogether: all are scaled down by the same factor, so that the
/// direction in joint space stays, and with it where the robot yields to.
enum class TorqueCut { kEach, kTogether };

struct TorqueLimitOptions {
  static constexpr const char* kName = "torque";
  double gain{1.0};                       ///< on the contact efforts; the thesis chose its own by trial
  config::JointNumbers limit{kInfinity};  ///< N m or N, of its size, of each joint or one for all
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
/// 5.4]: tau_i = sat(gain tau_i, +-limit_i). One thread, no allocation after it is made.
class TorqueLimit {
 public:
  /// Throws UsageError for options that are not allowed for `dof` joints.
  TorqueLimit(const TorqueLimitOptions& options, int dof);

  double gain() const { return gain_; }
  double limit(int joint) const { return most_[static_cast<std::size_t>(joint)]; }
  /// Cuts the torques in place, without the gain. Gives the joint that was farthest beyond its limit, or -1
  /// when none was. What is not finite becomes 0 and counts as beyond.
  int cut(std::span<double> torque) const noexcept;
  /// gain * efforts, cut. Sizes are dof.
  int update(std::span<const double> efforts, std::span<double> torque) const noexcept;

 private:
  double gain_;
  TorqueCut cut_;
  config::JointNumbers most_;
};

}  // namespace abstand::control
