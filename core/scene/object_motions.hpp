// Motion state of the objects of a scene.
#pragma once

#include <vector>

#include "core/base/id.hpp"
#include "core/math/object_motion.hpp"
#include "core/scene/motion_bound.hpp"
#include "core/scene/scene_object.hpp"
#include "core/scene/speed_watch.hpp"

namespace abstand::scene {

/// Velocities, motion bounds and violations of speed bounds of all objects, updated with every pose. One
/// thread; update() allocates nothing.
class ObjectMotions {
 public:
  static constexpr int kMeanSamples = 10;       ///< poses in the mean velocity
  static constexpr double kMinTimeStep = 1e-9;  ///< s; poses closer in time count as one

  void addObject(const geometry::EnclosingSphere& sphere_B);

  /// Call before `object` gets the pose X_WB at `t`: sets its velocities, interruptions and speed_state. True
  /// if the pose differs from the current one.
  bool update(ObjectId id, Object& object, const Transform& X_WB, double t);

  /// Motion bound of each object.
  const std::vector<MotionBound>& bounds() const { return bounds_; }
  const SpeedWatch& speedWatch() const { return speed_watch_; }

 private:
  std::vector<MotionHistory<kMeanSamples>> histories_;
  std::vector<MotionBound> bounds_;
  SpeedWatch speed_watch_;
};

}  // namespace abstand::scene
