// Limits of the degrees of freedom of a mechanism.
#pragma once

#include <vector>

#include "core/mechanism/mechanism.hpp"

namespace abstand::mechanism {

/// JointLimits of the joint that leads a dof, in the units of q instead of the joint's value (they differ by
/// `offset` and `scale`). Infinity: no limit.
struct DofLimits {
  double lower{-kInfinity}, upper{kInfinity};
  double velocity{kInfinity};      ///< rad/s or m/s, absolute value
  double acceleration{kInfinity};  ///< rad/s^2 or m/s^2, absolute value
  double effort{kInfinity};        ///< N m or N, absolute value
};

/// One entry for each dof. Limits of mimic joints are ignored, as they move with the joint that they follow
/// (as in jointRanges()).
std::vector<DofLimits> dofLimits(const Mechanism& mechanism);

/// Names for messages: that of the leading joint, or of its frame if the file names no joint.
std::vector<std::string> dofNames(const Mechanism& mechanism);

/// Range of velocities (rad/s, m/s) that a joint may have after the next step.
struct VelocityBounds {
  double lower{-kInfinity}, upper{kInfinity};
};

/// Bounds on the next velocity that keep position, velocity and acceleration limits in this and all later
/// steps [after Flacco, De Luca, Khatib 2012, Motion control of redundant robots under joint constraints:
/// saturation in the null space, eq. 5 to 7]. With `d` the distance from q to the upper limit, a joint that
/// moves at v for one step h and then decelerates by `braking` stops before the limit if
///   h v + v^2 / (2 braking) <= d,   so   v <= 2 d / (h + sqrt(h^2 + 2 d / braking)),
/// and likewise for the lower limit. Beyond a position limit the bound is 0: the joint may only move back. 0
/// is always within the bounds unless the acceleration limit forbids it.
/// @param braking  rad/s^2 or m/s^2, > 0, guaranteed deceleration; may be infinite
/// @param h        s, > 0
VelocityBounds velocityBounds(const DofLimits& limits, double q, double qd, double braking,
                              double h) noexcept;

}  // namespace abstand::mechanism
