#include "core/control/contact_manifold.hpp"

namespace abstand::control {

ContactConstraint ContactManifold::constraint(const Point& point, const Transform& X_WO,
                                              const Transform& X_WB) {
  const Vector3d p_W = X_WO * point.p_O, n_W = X_WB.linear() * point.n_B;
  return {p_W, n_W, n_W.dot(p_W - X_WB * point.q_B)};
}

void ContactManifold::update(const query::PairResult& result, bool object_is_a, const Transform& X_WO,
                             const Transform& X_WB) noexcept {
  for (std::size_t i = 0; i < count_;) {
    const ContactConstraint c = constraint(points_[i], X_WO, X_WB);
    const Vector3d offset = c.p_W - X_WB * points_[i].q_B;
    if (c.gap <= kBreak && (offset - c.gap * c.normal_W).norm() <= kBreak)
      ++i;
    else
      points_[i] = points_[--count_];
  }
  newest_ = constraintOf(result, object_is_a);
  if (!newest_ || newest_->gap > kBreak) return;
  const Vector3d& q_W = object_is_a ? result.witness_b : result.witness_a;
  if (!q_W.allFinite()) return;
  const Point fresh{X_WO.inverse() * newest_->p_W, X_WB.inverse() * q_W,
                    X_WB.linear().transpose() * newest_->normal_W};
  std::size_t nearest = count_;
  double smallest = kInfinity;
  for (std::size_t i = 0; i < count_; ++i) {
    const double d = (points_[i].p_O - fresh.p_O).norm();
    if (d < smallest) smallest = d, nearest = i;
  }
  if (smallest < kApart || count_ == kMax)
    points_[nearest] = fresh;
  else
    points_[count_++] = fresh;
}

}  // namespace abstand::control
