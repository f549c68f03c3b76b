// Persistent contact manifold: a face that lies on a face has more contacts than one query tells.
#pragma once

#include <array>
#include <vector>

#include "core/control/god_object.hpp"

namespace abstand::control {

/// The nearest points of the last queries of one pair, kept with the bodies while they still face each other:
/// a query gives one, and a held object that is kept off by one corner alone turns into the wall about it.
/// Each is a plane through its point of the other body; a new point takes the place of one that is nearer to
/// it than kApart, or, when there is no room, of the nearest one. [A persistent manifold, as rigid body
/// engines keep: van den Bergen, Collision Detection in Interactive 3D Environments, 2003.] One thread, no
/// allocation.
class ContactManifold {
 public:
  static constexpr std::size_t kMax = 6;
  static constexpr double kApart = 2e-3;  ///< m
  /// m; points that have come farther from each other than this, or slid by as much, are dropped.
  static constexpr double kBreak = 5e-3;

  void clear() noexcept { count_ = 0; }
  std::size_t size() const { return count_; }
  /// A query of the pair with the object at X_WO and the other body at X_WB.
  void update(const query::PairResult& result, bool object_is_a, const Transform& X_WO,
              const Transform& X_WB) noexcept;
  /// Calls visit(constraint) for the newest point, whose gap is the distance itself, and for all that are
  /// kept.
  template <class Visit>
  void each(const Transform& X_WO, const Transform& X_WB, Visit visit) const {
    if (newest_) visit(*newest_);
    for (std::size_t i = 0; i < count_; ++i) visit(constraint(points_[i], X_WO, X_WB));
  }

 private:
  struct Point {
    Vector3d p_O, q_B;  ///< on the object, on the other body
    Vector3d n_B;       ///< unit, out of the other body
  };
  static ContactConstraint constraint(const Point& point, const Transform& X_WO, const Transform& X_WB);

  std::array<Point, kMax> points_;
  std::size_t count_{0};
  std::optional<ContactConstraint> newest_;
};

}  // namespace abstand::control
