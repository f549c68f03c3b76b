#include "core/mechanism/joint_limit_watch.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::mechanism {

std::string_view limitName(LimitKind kind) {
  constexpr std::array<std::string_view, kLimitKinds> kNames{"position", "velocity", "acceleration",
                                                             "effort"};
  return kNames[static_cast<std::size_t>(kind)];
}

JointLimitWatch::JointLimitWatch(std::vector<DofLimits> limits) : limits_(std::move(limits)) {
  worst_.resize(kLimitKinds * limits_.size());
  for (std::size_t i = 0; i < worst_.size(); ++i) {
    worst_[i].dof = static_cast<int>(i / kLimitKinds);
    worst_[i].kind = static_cast<LimitKind>(i % kLimitKinds);
  }
}

void JointLimitWatch::compare(std::size_t dof, LimitKind kind, double t, double value, double lower,
                              double upper) noexcept {
  const double limit = value < lower ? lower : upper;
  const double excess = std::max(value - upper, lower - value);
  if (excess <= std::max(kLimitRounding, kLimitShare * std::abs(limit))) return;
  kept_ = false;
  LimitBreach& worst = worst_[kLimitKinds * dof + static_cast<std::size_t>(kind)];
  const double before = std::abs(worst.value - worst.limit);
  if (worst.count++ == 0) worst.since = t;
  // A value that is not finite is the worst, permanently.
  if (worst.count > 1 && !(excess > before) && !std::isnan(excess)) return;
  if (worst.count > 1 && std::isnan(before)) return;
  worst.value = value;
  worst.limit = limit;
  worst.t = t;
}

void JointLimitWatch::check(double t, std::span<const double> q, std::span<const double> qd,
                            std::span<const double> qdd, std::span<const double> efforts) noexcept {
  for (const auto& s : {q, qd, qdd, efforts}) ABSTAND_CHECK(s.empty() || s.size() == limits_.size());
  for (std::size_t k = 0; k < limits_.size(); ++k) {
    const DofLimits& l = limits_[k];
    if (!q.empty()) compare(k, LimitKind::kPosition, t, q[k], l.lower, l.upper);
    if (!qd.empty()) compare(k, LimitKind::kVelocity, t, qd[k], -l.velocity, l.velocity);
    if (!qdd.empty()) compare(k, LimitKind::kAcceleration, t, qdd[k], -l.acceleration, l.acceleration);
    if (!efforts.empty()) compare(k, LimitKind::kEffort, t, efforts[k], -l.effort, l.effort);
  }
}

std::vector<LimitBreach> JointLimitWatch::breaches() const {
  std::vector<LimitBreach> found;
  std::copy_if(worst_.begin(), worst_.end(), std::back_inserter(found),
               [](const LimitBreach& b) { return b.count > 0; });
  return found;
}

std::size_t JointLimitWatch::copyBreaches(std::span<LimitBreach> out) const noexcept {
  if (kept_) return 0;
  std::size_t count = 0;
  for (const LimitBreach& b : worst_) {
    if (b.count == 0) continue;
    if (count < out.size()) out[count] = b;
    ++count;
  }
  return count;
}

}  // namespace abstand::mechanism
