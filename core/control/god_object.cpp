#include "core/control/god_object.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/control/pair_direction.hpp"
#include "core/math/object_motion.hpp"

namespace abstand::control {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;

// Rounds of projected Gauss-Seidel over the multipliers. A remaining violation is corrected in the next
// update.
constexpr int kRounds = 200;
// m; iteration ends when no contact changes by more than this.
constexpr double kSettled = 1e-12;

Vector3d limitLength(const Vector3d& v, double max_length) {
  const double length = v.norm();
  return length > max_length ? Vector3d(v * (max_length / length)) : v;
}

/// Rows of the constraints, scaled so that the metric is the identity.
struct Rows {
  std::array<Vector6d, GodObject::kMaxConstraints> row;
  std::array<double, GodObject::kMaxConstraints> min_change, weight, multiplier;
  std::size_t count{0};

  /// The allowed point nearest to `x`.
  Vector6d project(Vector6d x) {
    for (int round = 0; round < kRounds; ++round) {
      double change = 0.0;
      for (std::size_t i = 0; i < count; ++i) {
        const double deficit = min_change[i] - row[i].dot(x);
        const double now = std::max(0.0, multiplier[i] + deficit / weight[i]);
        x += (now - multiplier[i]) * row[i];
        change = std::max(change, std::abs(now - multiplier[i]) * weight[i]);
        multiplier[i] = now;
      }
      if (change <= kSettled) break;
    }
    return x;
  }
};

}  // namespace

std::optional<ContactConstraint> constraintOf(const query::PairResult& result, bool object_is_a,
                                              bool certain) noexcept {
  const Vector3d n = partingDirection(result);
  const Vector3d& p = object_is_a ? result.witness_a : result.witness_b;
  const double gap = certain ? result.distance - result.bound : result.distance;
  if (!(n.squaredNorm() > 0.5) || !p.allFinite() || std::isnan(gap)) return std::nullopt;
  return ContactConstraint{p, object_is_a ? n : Vector3d(-n), gap};
}

GodObject::GodObject(const GodObjectOptions& options, const geometry::EnclosingSphere& sphere_O)
    : o_(options), sphere_O_(sphere_O) {
  options.validate();
  // A point has no extent; any length works.
  sphere_O_.radius = std::max(sphere_O.radius, 1e-6);
}

void GodObject::reset(const Transform& X_WO) noexcept {
  X_WO_ = X_WO;
  hand_ = X_WO * sphere_O_.centre;
  wrench_ = {};
  moved_ = 0.0;
}

void GodObject::update(const Transform& X_WH, std::span<const ContactConstraint> constraints) noexcept {
  const Vector3d c = X_WO_ * sphere_O_.centre;
  const double rho = std::sqrt(0.4) * sphere_O_.radius;

  // Displacement to the hand's pose, in length units.
  Vector6d desired;
  desired << X_WH * sphere_O_.centre - c, rho * rotationBetween(X_WO_.linear(), X_WH.linear());
  if (!desired.allFinite()) desired.setZero();  // an invalid hand pose does not move the object
  const auto farthestDisplacement = [&](const Vector6d& x) {
    return x.head<3>().norm() + x.tail<3>().norm() * sphere_O_.radius / rho;
  };
  if (const double length = farthestDisplacement(desired); length > o_.step) desired *= o_.step / length;

  Rows rows;
  for (const ContactConstraint& k : constraints) {
    // Contacts beyond two steps and the gap cannot be reached; a contact without a free slot replaces the
    // farthest.
    if (!(k.gap <= 2.0 * o_.step + o_.gap) || !k.p_W.allFinite() || !(k.normal_W.squaredNorm() > 0.5))
      continue;
    std::size_t at = rows.count;
    if (at == kMaxConstraints) {
      at = static_cast<std::size_t>(std::min_element(rows.min_change.begin(), rows.min_change.end()) -
                                    rows.min_change.begin());
      if (o_.gap - k.gap <= rows.min_change[at]) continue;
    } else {
      ++rows.count;
    }
    rows.row[at] << k.normal_W, Vector3d(k.p_W - c).cross(k.normal_W) / rho;
    rows.min_change[at] = std::min(o_.gap - k.gap, o_.step);
    rows.weight[at] = rows.row[at].squaredNorm();
    rows.multiplier[at] = 0.0;
  }
  Vector6d x = rows.project(desired);
  // Contradicting contacts must not cause a large displacement.
  if (const double length = farthestDisplacement(x); length > 2.0 * o_.step) x *= 2.0 * o_.step / length;
  moved_ = farthestDisplacement(x);

  const Vector3d turn = x.tail<3>() / rho;
  const double angle = turn.norm();
  if (angle > 0.0) {
    const Matrix3d R = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * Matrix3d(X_WO_.linear());
    X_WO_.linear() = Quaterniond(R).normalized().toRotationMatrix();  // re-normalises against rounding drift
  }
  X_WO_.translation() = c + x.head<3>() - X_WO_.linear() * sphere_O_.centre;

  if (!X_WH.matrix().allFinite()) {
    wrench_ = {};
    return;
  }
  hand_ = X_WH * sphere_O_.centre;
  wrench_.force = limitLength(o_.stiffness * (X_WO_ * sphere_O_.centre - hand_), o_.force);
  wrench_.torque =
      limitLength(o_.rotation_stiffness * rotationBetween(X_WH.linear(), X_WO_.linear()), o_.torque);
}

}  // namespace abstand::control
