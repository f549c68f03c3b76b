// Position and direction of the joint of each degree of freedom.
#pragma once

#include <span>

#include "core/mechanism/mechanism.hpp"

namespace abstand::mechanism {

/// The axis of a joint: a torque on it turns right-handed about `direction`, and a force acts along it, in
/// the sense of an increasing joint value.
struct JointAxis {
  Vector3d p{Vector3d::Zero()};           ///< m, a point on the axis: the origin of the frame that it moves
  Vector3d direction{Vector3d::UnitZ()};  ///< unit
  bool prismatic{false};
};

/// Axes of all degrees of freedom in the base frame; `axes` has size dof. If several joints follow one degree
/// of freedom (mimic joints), the axis is that of the joint that leads. `state` comes from forward(). Degrees
/// of freedom that no joint leads keep their value. No allocation.
void jointAxes(const Mechanism& mechanism, const MechanismState& state, std::span<JointAxis> axes);

}  // namespace abstand::mechanism
