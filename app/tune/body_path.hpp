// One body's poses over time, with how far it gets within any stretch of it.
#pragma once

#include <vector>

#include "core/geometry/enclosing_sphere.hpp"
#include "core/safety/body_motion.hpp"

namespace abstand::tune {

/// Poses at rising times, between them PoseSegment. Constant after the last add().
class BodyPath {
 public:
  explicit BodyPath(const geometry::EnclosingSphere& sphere_B) : sphere_B_(sphere_B) {}

  /// `uncertainty`: m, of the pose; holds until the next one, too.
  void add(double t, const Transform& X_WB, double uncertainty = 0.0);

  double begin() const { return t_.front(); }
  double end() const { return t_.back(); }
  bool empty() const { return t_.empty(); }
  Transform at(double t) const;
  /// m: no point of the body is farther from where at(middle of the stretch) has it, within [t0, t1].
  double reach(double t0, double t1) const;
  /// m, the largest within [t0, t1].
  double uncertainty(double t0, double t1) const;

 private:
  std::size_t indexAt(double t) const;
  /// m, way of the body's farthest point from begin() to t.
  double way(double t) const;

  geometry::EnclosingSphere sphere_B_;
  std::vector<double> t_, uncertainty_, way_;
  std::vector<Transform> X_WB_;
  std::vector<safety::PoseSegment> motion_;
};

}  // namespace abstand::tune
