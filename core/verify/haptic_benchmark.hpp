// Check of the accuracy of forces and torques: reconstruction of the haptic benchmark of 2010.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// One result for each scene (haptic_scenes.hpp). Measured along its path, for the thesis's law and the
/// volume law on layers, and the volume law on float and mixed fields: angle between the force and the true
/// one, error of its magnitude, its noise (second differences of the error), and the error of both torques.
/// The thesis's law has no physical unit: its forces are scaled by the factor that fits the scene best. Each
/// value is divided by its limit, which depends on the field.
std::vector<CheckResult> checkHapticBenchmark(const VerifyOptions& options);

}  // namespace abstand::verify
