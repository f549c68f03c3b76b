// Distances of bodies that move, by an engine that remembers, against exact distances of meshes.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// Moves pairs of adversarial bodies on from adversarial poses, in steps from a micrometre to a centimetre
/// with turns that go with them, and asks queryPair each time with what it remembers of the step before, as
/// every cycle does. One pose in five of options.poses. The result bound.moving is what checkCertifiedBound()
/// calls bound.FIELD; the table has one row for each size of step.
std::vector<CheckResult> checkMovingBound(const VerifyOptions& options);

}  // namespace abstand::verify
