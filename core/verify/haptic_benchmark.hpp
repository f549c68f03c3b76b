// Quality of forces and torques against what they should be: the haptic benchmark of 2010, rebuilt.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// One result a scene (haptic_scenes.hpp). Measured are, along its path, for the thesis's law and the volume
/// law on layers, and the volume law on float and mixed fields: the angle between the force and the true one,
/// the error of its size, its noise (second differences of its error), and the error of both torques. The
/// thesis's law knows no newtons: its forces are scaled by the factor that fits the scene best. Each
/// measurement is divided by its limit, which depends on the field; the result's numbers are these parts.
std::vector<CheckResult> checkHapticBenchmark(const VerifyOptions& options);

}  // namespace abstand::verify
