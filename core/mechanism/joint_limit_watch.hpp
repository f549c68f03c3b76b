// Detects violations of joint limits over a motion.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/mechanism/dof_limits.hpp"

namespace abstand::mechanism {

enum class LimitKind { kPosition, kVelocity, kAcceleration, kEffort };
inline constexpr std::size_t kLimitKinds = 4;
std::string_view limitName(LimitKind kind);  ///< "position", "velocity", "acceleration", "effort"

/// Rounding allowance: an excess up to this share of the limit, or up to kLimitRounding in the limit's unit
/// if that is more, is not a violation.
inline constexpr double kLimitShare = 1e-6;
inline constexpr double kLimitRounding = 1e-9;

/// The worst violation of one kind of limit by one dof.
struct LimitBreach {
  int dof{0};
  LimitKind kind{LimitKind::kPosition};
  double value{0.0};  ///< SI, signed; NaN if the value was not finite
  double limit{0.0};  ///< SI; for positions the violated limit, otherwise the limit with the value's sign
  double t{0.0};      ///< s, time of the largest excess
  double since{0.0};  ///< s, time of the first violation
  long count{0};      ///< number of samples beyond the limit
};

/// Records the worst violation for each dof and kind. One thread; check() does not allocate or throw.
class JointLimitWatch {
 public:
  explicit JointLimitWatch(std::vector<DofLimits> limits);

  /// Checks the state at time `t` (s). Each span has one value (SI) for each dof, or is empty if unknown.
  void check(double t, std::span<const double> q, std::span<const double> qd, std::span<const double> qdd,
             std::span<const double> efforts) noexcept;
  /// Violations in the order of dof, then LimitKind.
  std::vector<LimitBreach> breaches() const;
  /// The same into `out`, as many as fit; returns their total number. Does not allocate or throw.
  std::size_t copyBreaches(std::span<LimitBreach> out) const noexcept;
  bool kept() const { return kept_; }  ///< no limit was violated
  const std::vector<DofLimits>& limits() const { return limits_; }

 private:
  void compare(std::size_t dof, LimitKind kind, double t, double value, double lower, double upper) noexcept;

  std::vector<DofLimits> limits_;
  std::vector<LimitBreach> worst_;  ///< kLimitKinds for each dof
  bool kept_{true};
};

}  // namespace abstand::mechanism
