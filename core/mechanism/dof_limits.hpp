// What the degrees of freedom of a mechanism may do.
#pragma once

#include <vector>

#include "core/mechanism/mechanism.hpp"

namespace abstand::mechanism {

/// JointLimits of the joint that leads a dof, in the units of q instead of the joint's value (they differ by
/// `offset` and `scale`). Infinity where nothing is known.
struct DofLimits {
  double lower{-kInfinity}, upper{kInfinity};
  double velocity{kInfinity};      ///< rad/s or m/s, of its size
  double acceleration{kInfinity};  ///< rad/s^2 or m/s^2, of its size
  double effort{kInfinity};        ///< N m or N, of its size
};

/// One a dof. Joints that mimic another one are moved with it, so their own limits are not asked
/// (as in jointRanges()).
std::vector<DofLimits> dofLimits(const Mechanism& mechanism);

/// For messages: the leading joint's name, or its frame's where the file names no joint.
std::vector<std::string> dofNames(const Mechanism& mechanism);

/// Velocities (rad/s, m/s) that a joint may have after the next step.
struct VelocityBounds {
  double lower{-kInfinity}, upper{kInfinity};
};

/// Bounds on the next velocity that keep position, velocity and acceleration limits, also in all later steps
/// [after Flacco, De Luca, Khatib 2012, Motion control of redundant robots under joint constraints:
/// saturation in the null space, eq. 5 to 7]. With `d` the distance from q to the upper limit, a joint that
/// moves at v for one step of h and then slows down by `braking` stops in front of the limit when
///   h v + v^2 / (2 braking) <= d,   so   v <= 2 d / (h + sqrt(h^2 + 2 d / braking)),
/// and likewise for the lower one. Beyond a position limit the bound is 0: the joint may only go back. 0 is
/// always within the bounds unless the acceleration limit forbids it.
/// @param braking  rad/s^2 or m/s^2, > 0, deceleration that can be relied on; may be infinite
/// @param h        s, > 0
VelocityBounds velocityBounds(const DofLimits& limits, double q, double qd, double braking,
                              double h) noexcept;

}  // namespace abstand::mechanism
