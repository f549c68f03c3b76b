#include "core/physics/joint_limiter.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::physics {
namespace {

// Share of a bound: less is rounding of the solution that set the velocity there.
constexpr double kAtBound = 1e-12;

}  // namespace

JointLimiter::JointLimiter(std::vector<mechanism::DofLimits> limits) : limits_(std::move(limits)) {
  const std::size_t n = limits_.size();
  bounds_.resize(n);
  rows_.reserve(static_cast<Eigen::Index>(n));
  dofs_.reserve(n);
  row_of_.resize(n);
  at_upper_.reserve(n);
  responses_.setZero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  for (auto* v : {&command_, &without_, &wanted_, &holding_, &held_}) v->resize(n);
}

double JointLimiter::braking(const mechanism::MassMatrix& mass, std::span<const double> bias,
                             std::size_t k) const noexcept {
  const auto i = static_cast<Eigen::Index>(k);
  const double max_effort = limits_[k].effort;
  const double reserve = std::max(max_effort - std::abs(bias[k]), kMinReserve * max_effort);
  return std::min(kBrakingShare * reserve / mass.M(i, i), limits_[k].acceleration);
}

/// Sets which bound the row keeps.
void JointLimiter::aim(const LimitedStep& step, Eigen::Index row, bool upper) noexcept {
  const std::size_t k = dofs_[static_cast<std::size_t>(row)];
  const double max_effort = limits_[k].effort;
  at_upper_[static_cast<std::size_t>(row)] = upper;
  rows_.b[row] = (upper ? bounds_[k].upper : bounds_[k].lower) - without_[k];
  rows_.lower[row] = upper ? std::min(0.0, step.h * (-max_effort - command_[k])) : 0.0;
  rows_.upper[row] = upper ? 0.0 : std::max(0.0, step.h * (max_effort - command_[k]));
}

void JointLimiter::addRow(const mechanism::MassMatrix& mass, const LimitedStep& step, std::size_t dof,
                          bool upper) noexcept {
  const auto row = static_cast<Eigen::Index>(dofs_.size());
  dofs_.push_back(dof);
  at_upper_.push_back(upper);
  row_of_[dof] = row;
  auto response = responses_.col(row);
  response.setZero();
  response[static_cast<Eigen::Index>(dof)] = 1.0;
  mechanism::solveMass(mass, {response.data(), limits_.size()});
  for (Eigen::Index i = 0; i <= row; ++i)
    rows_.A(i, row) = rows_.A(row, i) =
        response[static_cast<Eigen::Index>(dofs_[static_cast<std::size_t>(i)])];
  aim(step, row, upper);
}

/// For the efforts command_ and next velocities without_. Returns the largest remaining excess of a joint
/// over its bound (rad/s, m/s), 0 if none.
double JointLimiter::keepBounds(const mechanism::MassMatrix& mass, const LimitedStep& step,
                                const std::vector<bool>& free) noexcept {
  const std::size_t n = limits_.size();
  std::copy(command_.begin(), command_.end(), step.efforts.begin());
  std::copy(without_.begin(), without_.end(), step.next.begin());
  std::fill(row_of_.begin(), row_of_.end(), -1);
  dofs_.clear();
  at_upper_.clear();
  double worst = 0.0;
  // Rows are added as their bounds are violated; a row may have to switch to its other bound after others
  // were added. Every round except the last adds or switches at least one.
  for (std::size_t round = 0; round < 3 * n; ++round) {
    bool changed = false;
    worst = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      if (k < free.size() && free[k]) continue;
      const mechanism::VelocityBounds& b = bounds_[k];
      const bool above = step.next[k] > b.upper + kAtBound * (1.0 + std::abs(b.upper));
      const bool below = step.next[k] < b.lower - kAtBound * (1.0 + std::abs(b.lower));
      if (!above && !below) continue;
      worst = std::max(worst, above ? step.next[k] - b.upper : b.lower - step.next[k]);
      if (row_of_[k] < 0)
        addRow(mass, step, k, above);
      else if (at_upper_[static_cast<std::size_t>(row_of_[k])] != above)
        aim(step, row_of_[k], above);
      else
        continue;  // the effort is at its limit
      changed = true;
    }
    if (!changed) break;
    solveBoxLcp(rows_, static_cast<Eigen::Index>(dofs_.size()));
    std::copy(without_.begin(), without_.end(), step.next.begin());
    for (std::size_t r = 0; r < dofs_.size(); ++r)
      for (std::size_t k = 0; k < n; ++k)
        step.next[k] += rows_.x[static_cast<Eigen::Index>(r)] *
                        responses_(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(r));
  }
  for (std::size_t r = 0; r < dofs_.size(); ++r) {
    const std::size_t k = dofs_[r];
    const double effort = command_[k] + rows_.x[static_cast<Eigen::Index>(r)] / step.h;
    step.efforts[k] = std::clamp(effort, -limits_[k].effort, limits_[k].effort);
  }
  return worst;
}

/// Efforts, within their limits, that keep the present velocities or lead back to their bounds.
void JointLimiter::findHolding(const mechanism::MassMatrix& mass, const LimitedStep& step) noexcept {
  const std::size_t n = limits_.size();
  for (std::size_t k = 0; k < n; ++k)
    held_[k] = std::clamp(step.qd[k], bounds_[k].lower, bounds_[k].upper) - step.qd[k];
  for (std::size_t k = 0; k < n; ++k) {
    double effort = step.bias[k];
    for (std::size_t i = 0; i < n; ++i)
      effort += mass.M(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) * held_[i] / step.h;
    holding_[k] = std::clamp(effort, -limits_[k].effort, limits_[k].effort);
  }
  for (std::size_t k = 0; k < n; ++k) held_[k] = step.h * (holding_[k] - step.bias[k]);
  mechanism::solveMass(mass, held_);
  for (std::size_t k = 0; k < n; ++k) held_[k] += step.qd[k];
}

double JointLimiter::keepBoundsAt(double share, const mechanism::MassMatrix& mass, const LimitedStep& step,
                                  const std::vector<bool>& free) noexcept {
  for (std::size_t k = 0; k < limits_.size(); ++k) {
    command_[k] = holding_[k] + share * (step.command[k] - holding_[k]);
    without_[k] = held_[k] + share * (wanted_[k] - held_[k]);
  }
  return keepBounds(mass, step, free);
}

void JointLimiter::limit(const mechanism::MassMatrix& mass, const LimitedStep& step,
                         const std::vector<bool>& free) noexcept {
  const std::size_t n = limits_.size();
  ABSTAND_CHECK(step.next.size() == n && step.efforts.size() == n);
  for (std::size_t k = 0; k < n; ++k)
    bounds_[k] =
        mechanism::velocityBounds(limits_[k], step.q[k], step.qd[k], braking(mass, step.bias, k), step.h);
  std::copy(step.command.begin(), step.command.end(), command_.begin());
  std::copy(step.next.begin(), step.next.end(), without_.begin());
  wanted_ = without_;
  const double worst = keepBounds(mass, step, free);
  if (worst == 0.0) return;
  findHolding(mass, step);
  const double smallest = keepBoundsAt(0.0, mass, step, free);
  if (smallest > 0.0) {
    // Not even the holding efforts suffice: uses the one that violates less.
    if (worst <= smallest) keepBoundsAt(1.0, mass, step, free);
    return;
  }
  double kept = 0.0, broken = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double share = 0.5 * (kept + broken);
    (keepBoundsAt(share, mass, step, free) > 0.0 ? broken : kept) = share;
  }
  keepBoundsAt(kept, mass, step, free);
}

}  // namespace abstand::physics
