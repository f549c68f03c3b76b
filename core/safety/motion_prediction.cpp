#include "core/safety/motion_prediction.hpp"

#include <cmath>

namespace abstand::safety {

MotionPrediction::MotionPrediction(const PredictionOptions& options, const Vector3d& centre_B)
    : options_(options), centre_B_(centre_B) {
  options.validate();
}

void MotionPrediction::clear() noexcept {
  history_.clear();
  started_ = false;
}

bool MotionPrediction::add(double t, const Transform& X_WB) noexcept {
  if (!std::isfinite(t) || !X_WB.matrix().allFinite()) return false;
  const double dt = t - t_;
  if (started_ && !(dt > 0.0)) return false;
  if (started_ && dt <= options_.longest_gap)
    history_.add(dt, X_WB * centre_B_ - X_WB_ * centre_B_, rotationBetween(X_WB_.linear(), X_WB.linear()));
  else
    history_.clear();
  X_WB_ = X_WB;
  t_ = t;
  started_ = true;
  return true;
}

Transform MotionPrediction::at(double ahead) const noexcept {
  if (!(ahead > 0.0)) return X_WB_;
  const Twist v = velocity();
  Transform X = X_WB_;
  const double angle = v.angular.norm() * ahead;
  if (angle > 0.0)
    X.linear() =
        Eigen::AngleAxisd(angle, v.angular.normalized()).toRotationMatrix() * Matrix3d(X_WB_.linear());
  X.translation() = X_WB_ * centre_B_ + ahead * v.linear - X.linear() * centre_B_;
  return X;
}

}  // namespace abstand::safety
