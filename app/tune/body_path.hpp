// Poses of one body over time, with motion bounds within time intervals.
#pragma once

#include <vector>

#include "core/geometry/enclosing_sphere.hpp"
#include "core/safety/body_motion.hpp"

namespace abstand::tune {

/// Poses at increasing times, interpolated by PoseSegment. Constant after the last add().
class BodyPath {
 public:
  explicit BodyPath(const geometry::EnclosingSphere& sphere_B) : sphere_B_(sphere_B) {}

  /// `uncertainty`: m, of the pose; applies until the next one, too.
  void add(double t, const Transform& X_WB, double uncertainty = 0.0);

  double begin() const { return t_.front(); }
  double end() const { return t_.back(); }
  bool empty() const { return t_.empty(); }
  Transform at(double t) const;
  /// m: motion bound within [t0, t1] relative to the pose at the middle of the interval.
  double reach(double t0, double t1) const;
  /// m, largest uncertainty within [t0, t1].
  double uncertainty(double t0, double t1) const;

 private:
  std::size_t indexAt(double t) const;
  /// m, path length of the body's farthest point from begin() to t.
  double travelled(double t) const;

  geometry::EnclosingSphere sphere_B_;
  std::vector<double> t_, uncertainty_, travelled_;
  std::vector<Transform> X_WB_;
  std::vector<safety::PoseSegment> motion_;
};

}  // namespace abstand::tune
