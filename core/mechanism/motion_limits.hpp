// Whether a robot can do what its recorded motion asks for.
#pragma once

#include "core/mechanism/joint_limit_watch.hpp"
#include "core/mechanism/motion_file.hpp"

namespace abstand::mechanism {

/// How the rows of a motion are joined. kLinear: as MotionTable has it; velocities are the slopes between
/// rows, accelerations at the rows are not finite and not looked at, nor are efforts. kSmooth: as
/// SmoothMotion has it, with accelerations, and with efforts where the mechanism has masses; looked at in
/// kSmoothSamples moments between two rows.
enum class MotionLine { kLinear, kSmooth };
inline constexpr int kSmoothSamples = 8;

/// What the motion breaks of the mechanism's limits from `start` to `end` (s); before its first and after its
/// last row it rests. `gravity_B`: m/s^2, in the base's axes, for efforts.
std::vector<LimitBreach> motionBreaches(const Mechanism& mechanism, const MotionTable& motion,
                                        MotionLine line, double start, double end, const Vector3d& gravity_B);

}  // namespace abstand::mechanism
