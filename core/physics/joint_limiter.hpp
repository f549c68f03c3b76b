// Motor efforts that keep joints within their limits.
#pragma once

#include <span>
#include <vector>

#include "core/mechanism/dof_limits.hpp"
#include "core/mechanism/mass_matrix.hpp"
#include "core/physics/box_lcp.hpp"

namespace abstand::physics {

/// One step of a mechanism. All spans have the size dof.
struct LimitedStep {
  double h{0.0};                    ///< s
  std::span<const double> q, qd;    ///< before the step
  std::span<const double> bias;     ///< N m or N: C qd + g - J^T w, so that M qdd = efforts - bias
  std::span<const double> command;  ///< commanded efforts, within the effort limits
  std::span<double> next;           ///< in: qd after the step under `command`; out: under `efforts`
  std::span<double> efforts;        ///< out
};

/// Changes the efforts of a step if the next velocities would leave the bounds of velocityBounds(). Efforts
/// stay within their limits.
///
/// First the effort of each joint that would leave its bound is changed as little as possible: the change of
/// the velocities has the least kinetic energy (Gauss's principle of least constraint). This is a
/// box-constrained problem with one row for each joint at a bound: with A = M^-1 and the impulse x of a row,
/// next' = next + A x, and for an upper bound
///   -h (limit + command) <= x <= 0,  next' <= upper,  next' = upper if x is between its bounds.
/// If a motor cannot hold its joint against the other joints' motors, all commands are moved together towards
/// the efforts that keep the present velocities (or, beyond a bound, lead back to it), by the smallest share
/// that kHalvings bisections find sufficient. If that is not enough either, because external forces exceed
/// the motors' efforts, velocities leave the bounds with the efforts at their limits.
///
/// Bounds by Flacco, De Luca, Khatib 2012 (see velocityBounds()); the deceleration they assume is half of the
/// remaining effort, kBrakingShare (limit - |bias|) / M_ii. One thread; limit() does not allocate or throw.
class JointLimiter {
 public:
  static constexpr double kBrakingShare = 0.5;
  /// Smallest share of an effort limit that is assumed available for braking.
  static constexpr double kMinReserve = 0.1;
  static constexpr int kHalvings = 6;

  explicit JointLimiter(std::vector<mechanism::DofLimits> limits);

  /// `mass`: factored, at step.q. `free`: dofs to ignore, because something else drives them; empty: none.
  void limit(const mechanism::MassMatrix& mass, const LimitedStep& step,
             const std::vector<bool>& free = {}) noexcept;
  /// Deceleration (rad/s^2 or m/s^2) of a dof that its motor can provide in this posture.
  double braking(const mechanism::MassMatrix& mass, std::span<const double> bias,
                 std::size_t dof) const noexcept;
  const std::vector<mechanism::DofLimits>& limits() const { return limits_; }

 private:
  double keepBounds(const mechanism::MassMatrix& mass, const LimitedStep& step,
                    const std::vector<bool>& free) noexcept;
  double keepBoundsAt(double share, const mechanism::MassMatrix& mass, const LimitedStep& step,
                      const std::vector<bool>& free) noexcept;
  void findHolding(const mechanism::MassMatrix& mass, const LimitedStep& step) noexcept;
  void addRow(const mechanism::MassMatrix& mass, const LimitedStep& step, std::size_t dof,
              bool upper) noexcept;
  void aim(const LimitedStep& step, Eigen::Index row, bool upper) noexcept;

  std::vector<mechanism::DofLimits> limits_;
  std::vector<mechanism::VelocityBounds> bounds_;
  BoxLcp rows_;
  std::vector<std::size_t> dofs_;     ///< of each row
  std::vector<Eigen::Index> row_of_;  ///< of each dof, -1: none
  std::vector<bool> at_upper_;        ///< of each row
  Eigen::MatrixXd responses_;         ///< one column for each row: velocity change by a unit of its impulse
  std::vector<double> command_, without_;  ///< efforts before the rows' changes, and `next` under them
  std::vector<double> wanted_;             ///< `next` under step.command
  std::vector<double> holding_, held_;     ///< efforts that keep the velocities, and `next` under them
};

}  // namespace abstand::physics
