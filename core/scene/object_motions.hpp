// How the objects of a scene move.
#pragma once

#include <vector>

#include "core/base/id.hpp"
#include "core/math/object_motion.hpp"
#include "core/scene/motion_bound.hpp"
#include "core/scene/scene_object.hpp"
#include "core/scene/speed_watch.hpp"

namespace abstand::scene {

/// Velocities, motion bounds and breaches of speed bounds of all objects, from one pose to the next. One
/// thread; update() allocates nothing.
class ObjectMotions {
 public:
  static constexpr int kMeanSamples = 10;       ///< poses in the mean velocity
  static constexpr double kMinTimeStep = 1e-9;  ///< s; poses closer in time count as one

  void addObject(const geometry::EnclosingSphere& sphere_B);

  /// Before `object` takes the pose X_WB at `t`: sets its velocities, interruptions and speed_state. True
  /// when the pose differs from the one that it has.
  bool update(ObjectId id, Object& object, const Transform& X_WB, double t);

  /// Of each object.
  const std::vector<MotionBound>& bounds() const { return bounds_; }
  const SpeedWatch& speedWatch() const { return speed_watch_; }

 private:
  std::vector<MotionHistory<kMeanSamples>> histories_;
  std::vector<MotionBound> bounds_;
  SpeedWatch speed_watch_;
};

}  // namespace abstand::scene
