#include "core/mechanism/inverse_kinematics.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::mechanism {
namespace {

constexpr double kFirstLambda = 1e-2, kMinLambda = 1e-6, kMaxLambda = 1e4;
constexpr double kLower = 0.3, kRaise = 4.0;  // factors of lambda after a step that comes nearer, or does not
constexpr double kSmallestStep = 1e-12;       // rad or m, of all joints together

}  // namespace

PointReach::PointReach(const Mechanism& mechanism, int frame, const Options& options)
    : mechanism_(mechanism),
      frame_(frame),
      options_(options),
      limits_(dofLimits(mechanism)),
      dq_(mechanism.dof),
      next_(static_cast<std::size_t>(mechanism.dof), 0.0) {
  if (frame < 0 || static_cast<std::size_t>(frame) >= mechanism.frames.size())
    throw UsageError("found frame " + std::to_string(frame) + ", expected one of " +
                     std::to_string(mechanism.frames.size()) + " frames of the mechanism");
  J_frame_.setZero(6, mechanism.dof);
  J_.setZero(3, mechanism.dof);
  J_free_.setZero(3, mechanism.dof);
  forward(mechanism_, next_, state_);
}

Vector3d PointReach::point(std::span<const double> q, const Vector3d& p_F) {
  forward(mechanism_, q, state_);
  return state_.X_BF[static_cast<std::size_t>(frame_)] * p_F;
}

/// Of the point `p_B` of the frame, at the values of the last point().
void PointReach::findJacobian(const Vector3d& p_B) {
  jacobian(mechanism_, state_, frame_, J_frame_);
  const Vector3d arm = p_B - state_.X_BF[static_cast<std::size_t>(frame_)].translation();
  for (Eigen::Index k = 0; k < J_.cols(); ++k)
    J_.col(k) = J_frame_.col(k).head<3>() + Vector3d(J_frame_.col(k).tail<3>()).cross(arm);
}

bool PointReach::isHeld(std::span<const double> q, Eigen::Index joint, double direction) const {
  const auto i = static_cast<std::size_t>(joint);
  return (direction > 0.0 && q[i] >= limits_[i].upper) || (direction < 0.0 && q[i] <= limits_[i].lower);
}

/// Sets dq_ and next_; returns the length of the step after clamping. Joints that would leave a limit at
/// which they stand are taken out, one round after the other, as the others then do their part.
double PointReach::step(std::span<const double> q, const Vector3d& error, double lambda) {
  J_free_ = J_;
  for (int round = 0; round <= mechanism_.dof; ++round) {
    Matrix3d A = J_free_ * J_free_.transpose();
    A.diagonal().array() += lambda * lambda;
    const Vector3d y = A.ldlt().solve(error);
    dq_.noalias() = J_free_.transpose() * y;
    bool changed = false;
    for (Eigen::Index k = 0; k < dq_.size(); ++k) {
      if (dq_[k] == 0.0 || !isHeld(q, k, dq_[k])) continue;
      J_free_.col(k).setZero();
      changed = true;
    }
    if (!changed) break;
  }
  double squared = 0.0;
  for (Eigen::Index k = 0; k < dq_.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    next_[i] = std::clamp(q[i] + dq_[k], limits_[i].lower, limits_[i].upper);
    squared += (next_[i] - q[i]) * (next_[i] - q[i]);
  }
  return std::sqrt(squared);
}

PointReach::Result PointReach::solve(const Vector3d& p_F, const Vector3d& p_B, std::span<double> q) noexcept {
  ABSTAND_CHECK(q.size() == next_.size());
  Result result;
  if (!p_F.allFinite() || !p_B.allFinite() ||
      !std::all_of(q.begin(), q.end(), [](double v) { return std::isfinite(v); }))
    return result;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = std::clamp(q[i], limits_[i].lower, limits_[i].upper);
  Vector3d p = point(q, p_F);
  result.distance = (p_B - p).norm();
  double lambda = kFirstLambda;
  bool is_new = true;
  while (result.distance > options_.tolerance && result.iterations < options_.iterations) {
    ++result.iterations;
    if (is_new) findJacobian(p);
    if (!(step(q, p_B - p, lambda) > kSmallestStep)) break;
    const Vector3d next = point(next_, p_F);
    const double distance = (p_B - next).norm();
    is_new = distance < result.distance;
    if (!is_new) {
      lambda *= kRaise;
      if (lambda > kMaxLambda) break;
      continue;
    }
    std::copy(next_.begin(), next_.end(), q.begin());
    p = next;
    result.distance = distance;
    lambda = std::max(kMinLambda, kLower * lambda);
  }
  return result;
}

}  // namespace abstand::mechanism
