// Uncertainty of joints of visible segments.
#pragma once

#include "tracking/body/body_solver.hpp"

namespace abstand::tracking {

/// Standard deviation (m) of each joint along its worst axis, of the raw error; three independent terms:
/// - Model difference: recordings define joints differently, and bodies differ from the model: a constant for
///   each joint.
/// - Fit: covariance of the last fit (jointSpreads) times `residual` (m, RMS of the points), times 3, as
/// errors
///   of neighbouring points are correlated.
/// - Occlusion: the less of a segment is visible, the likelier it is fitted to something else: depends on
///   `visible` (for each segment; for hands and feet the worse of itself and the segment that carries
///   it; for knees the better of thigh and calf).
/// The constants are calibrated so that kSpreadQuantile times the result contains 99 % of the raw errors of
/// the simulated captures (tests/tracking/tracker, docs/tracking.md). Does not allocate or throw.
std::array<double, humanmodel::kJointCount> trackedSpreads(const BodyRig& rig, const BodySolver& problem,
                                                           double residual,
                                                           const std::array<double, kRigSegments>& visible);

}  // namespace abstand::tracking
