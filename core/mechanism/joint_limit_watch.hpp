// Which joint limits a motion breaks.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/mechanism/dof_limits.hpp"

namespace abstand::mechanism {

enum class LimitKind { kPosition, kVelocity, kAcceleration, kEffort };
inline constexpr std::size_t kLimitKinds = 4;
std::string_view limitName(LimitKind kind);  ///< "position", "velocity", "acceleration", "effort"

/// Roundings of a joint that moves along its limit: what is beyond by this share of the limit, or by
/// kLimitRounding in the limit's own unit where that is more, still keeps it.
inline constexpr double kLimitShare = 1e-6;
inline constexpr double kLimitRounding = 1e-9;

/// The worst that a dof did against one kind of limit.
struct LimitBreach {
  int dof{0};
  LimitKind kind{LimitKind::kPosition};
  double value{0.0};  ///< SI, with its sign; NaN: was no number
  double limit{0.0};  ///< SI; of a position the limit that was broken, else the limit with the value's sign
  double t{0.0};      ///< s, of the worst moment
  double since{0.0};  ///< s, of the first moment
  long count{0};      ///< moments beyond the limit
};

/// Keeps the worst breach for each dof and kind. One thread; look() does not allocate or throw.
class JointLimitWatch {
 public:
  explicit JointLimitWatch(std::vector<DofLimits> limits);

  /// State at `t` (s). Each span has a number a dof, or none where it is not known. SI.
  void look(double t, std::span<const double> q, std::span<const double> qd, std::span<const double> qdd,
            std::span<const double> efforts) noexcept;
  /// In the order of the dofs, and of LimitKind.
  std::vector<LimitBreach> breaches() const;
  /// The same into `out`, as many as fit; gives how many there are. Does not allocate or throw.
  std::size_t copyBreaches(std::span<LimitBreach> out) const noexcept;
  bool kept() const { return kept_; }  ///< nothing was beyond its limit
  const std::vector<DofLimits>& limits() const { return limits_; }

 private:
  void compare(std::size_t dof, LimitKind kind, double t, double value, double lower, double upper) noexcept;

  std::vector<DofLimits> limits_;
  std::vector<LimitBreach> worst_;  ///< kLimitKinds a dof
  bool kept_{true};
};

}  // namespace abstand::mechanism
