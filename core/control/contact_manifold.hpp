// Persistent contact manifold: a face on a face has more contact points than one query reports.
#pragma once

#include <array>
#include <vector>

#include "core/control/god_object.hpp"

namespace abstand::control {

/// The nearest points of the last queries of one pair, kept as long as the bodies still face each other
/// there. A query reports one; with a single contact point, a held object would rotate into the wall about
/// it. Each contact is a plane through its point of the other body. A new point replaces one that is nearer
/// to it than kApart or, if there is no room, the nearest one. [Persistent manifold as in rigid body engines:
/// van den Bergen, Collision Detection in Interactive 3D Environments, 2003.] One thread, no allocation.
class ContactManifold {
 public:
  static constexpr std::size_t kMax = 6;
  static constexpr double kApart = 2e-3;  ///< m
  /// m; contacts whose points have separated or slid by more than this are dropped.
  static constexpr double kBreak = 5e-3;

  void clear() noexcept { count_ = 0; }
  std::size_t size() const { return count_; }
  /// Adds a query of the pair with the object at X_WO and the other body at X_WB.
  void update(const query::PairResult& result, bool object_is_a, const Transform& X_WO,
              const Transform& X_WB) noexcept;
  /// Calls visit(constraint) for the newest point, whose gap is the distance of the query, and for all kept
  /// points.
  template <class Visit>
  void each(const Transform& X_WO, const Transform& X_WB, Visit visit) const {
    if (newest_) visit(*newest_);
    for (std::size_t i = 0; i < count_; ++i) visit(constraint(points_[i], X_WO, X_WB));
  }

 private:
  struct Point {
    Vector3d p_O, q_B;  ///< on the object, on the other body
    Vector3d n_B;       ///< unit, outward normal of the other body
  };
  static ContactConstraint constraint(const Point& point, const Transform& X_WO, const Transform& X_WB);

  std::array<Point, kMax> points_;
  std::size_t count_{0};
  std::optional<ContactConstraint> newest_;
};

}  // namespace abstand::control
