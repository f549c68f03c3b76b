#include "core/safety/braking_path.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::safety {

BrakingPath::BrakingPath(const BrakingOptions& options, int dof)
    : kind_(options.kind), reaction_time_(options.reaction_time) {
  config::requireNumbers(options);
  max_deceleration_ = config::forJoints(BrakingOptions::kName, "deceleration", options.deceleration, dof,
                                        BrakingOptions::kDecelerationRule);
  deceleration_ = max_deceleration_;
  q_.assign(max_deceleration_.size(), 0.0);
  qd_ = q_;
}

bool BrakingPath::start(std::span<const double> q, std::span<const double> qd) noexcept {
  ABSTAND_CHECK(q.size() == q_.size() && qd.size() == q_.size());
  const auto finite = [](double x) { return std::isfinite(x); };
  const bool known = std::all_of(q.begin(), q.end(), finite) && std::all_of(qd.begin(), qd.end(), finite);
  double longest = 0.0;
  for (std::size_t i = 0; i < q_.size(); ++i) {
    q_[i] = q[i];
    qd_[i] = known ? qd[i] : 0.0;
    longest = std::max(longest, std::abs(qd_[i]) / max_deceleration_[i]);
  }
  for (std::size_t i = 0; i < q_.size(); ++i)
    deceleration_[i] =
        kind_ == BrakingKind::kTogether && longest > 0.0 ? std::abs(qd_[i]) / longest : max_deceleration_[i];
  stop_time_ = longest > 0.0 ? reaction_time_ + longest : 0.0;
  return known;
}

double BrakingPath::stopTime(int joint) const noexcept {
  const auto i = static_cast<std::size_t>(joint);
  return qd_[i] != 0.0 ? reaction_time_ + std::abs(qd_[i]) / deceleration_[i] : 0.0;
}

double BrakingPath::qd(int joint, double t) const noexcept {
  const auto i = static_cast<std::size_t>(joint);
  const double slowed = deceleration_[i] * std::max(0.0, t - reaction_time_);
  return std::copysign(std::max(0.0, std::abs(qd_[i]) - slowed), qd_[i]);
}

double BrakingPath::q(int joint, double t) const noexcept {
  const auto i = static_cast<std::size_t>(joint);
  if (qd_[i] == 0.0) return q_[i];
  const double until = std::min(std::max(0.0, t), stopTime(joint));
  const double braking = std::max(0.0, until - reaction_time_);
  return q_[i] + qd_[i] * until - std::copysign(0.5 * deceleration_[i] * braking * braking, qd_[i]);
}

void BrakingPath::at(double t, std::span<double> q_at) const noexcept {
  for (int i = 0; i < dof(); ++i) q_at[static_cast<std::size_t>(i)] = q(i, t);
}

double BrakingPath::fastest(int joint, double t0) const noexcept {
  return std::abs(qd(joint, t0));  // the speed never increases
}

double BrakingPath::brakingDistance(int joint) const noexcept {
  return q(joint, kInfinity) - q_[static_cast<std::size_t>(joint)];
}

}  // namespace abstand::safety
