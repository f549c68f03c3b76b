// Checks a recorded motion against the limits of its robot.
#pragma once

#include "core/mechanism/joint_limit_watch.hpp"
#include "core/mechanism/motion_file.hpp"

namespace abstand::mechanism {

/// Interpolation between the rows of a motion. kLinear: as MotionTable; velocities are the slopes between
/// rows; accelerations are infinite at the rows and not checked, nor are efforts. kSmooth: as SmoothMotion,
/// with accelerations, and with efforts if the mechanism has masses; checked at kSmoothSamples times between
/// two rows.
enum class MotionLine { kLinear, kSmooth };
inline constexpr int kSmoothSamples = 8;

/// Violations of the mechanism's limits from `start` to `end` (s); the motion is at rest before its first and
/// after its last row. `gravity_B`: m/s^2, base axes, for efforts.
std::vector<LimitBreach> motionBreaches(const Mechanism& mechanism, const MotionTable& motion,
                                        MotionLine line, double start, double end, const Vector3d& gravity_B);

}  // namespace abstand::mechanism
