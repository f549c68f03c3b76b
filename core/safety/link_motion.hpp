// A link of a mechanism that brakes, as a motion with certain bounds on its speed.
#pragma once

#include "core/geometry/enclosing_sphere.hpp"
#include "core/mechanism/mechanism.hpp"
#include "core/safety/body_motion.hpp"
#include "core/safety/braking_path.hpp"

namespace abstand::safety {

/// Poses by forward kinematics along the path. The speed of a point of the link is at most the sum, over the
/// joints that carry it, of |qd_i| for a prismatic joint, and |qd_i| times the lever for a revolute one: the
/// way over the frames between from the joint's own origin to the point, which no posture makes longer.
class LinkMotion final : public BodyMotion {
 public:
  /// All that is referred to must live as long as this. The path has the mechanism's dof.
  /// @param frame     index into mechanism.frames; -1: the base
  /// @param X_WB      base in world;  X_FL: link's body in its frame;  sphere_L: holds the link's body
  LinkMotion(const mechanism::Mechanism& mechanism, const BrakingPath& path, int frame, const Transform& X_WB,
             const Transform& X_FL, const geometry::EnclosingSphere& sphere_L);
  Transform pose(double t) noexcept override;
  double slack(double) const noexcept override { return 0.0; }
  double speed(double t0, double t1) const noexcept override;

 private:
  const mechanism::Mechanism& mechanism_;
  const BrakingPath& path_;
  int frame_;
  Transform X_WB_, X_FL_;
  double reach_;  ///< m, of the body's farthest point from its frame's origin
  mechanism::MechanismState state_;
  std::vector<double> q_;
};

}  // namespace abstand::safety
