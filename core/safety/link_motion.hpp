// A link of a braking mechanism as a motion with certified speed bounds.
#pragma once

#include "core/geometry/enclosing_sphere.hpp"
#include "core/mechanism/mechanism.hpp"
#include "core/safety/body_motion.hpp"
#include "core/safety/braking_path.hpp"

namespace abstand::safety {

/// Poses by forward kinematics along the braking path. The speed of a point of the link is at most the sum,
/// over the joints that carry it, of |qd_i| for a prismatic joint, and |qd_i| times the lever arm for a
/// revolute one: the length of the chain of frames from the joint's origin to the point, which is the largest
/// distance in any posture.
class LinkMotion final : public BodyMotion {
 public:
  /// All references must outlive this object. The path has the mechanism's dof.
  /// @param frame     index into mechanism.frames; -1: the base
  /// @param X_WB      base in world;  X_FL: link's body in its frame;  sphere_L: contains the link's body
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
  double reach_;  ///< m, largest distance of the body's points from its frame's origin
  mechanism::MechanismState state_;
  std::vector<double> q_;
};

}  // namespace abstand::safety
