// How well the joints of segments are known that the camera sees.
#pragma once

#include "tracking/body/body_solver.hpp"

namespace abstand::tracking {

/// Standard deviation (m) of each joint along its worst axis, of the raw error: three independent terms.
/// - What recordings mean by a joint differs from the model's joint, and bodies differ from the model: a
///   constant for each joint.
/// - What the image leaves open: the covariance of the last fit (jointSpreads) times `residual` (m, root mean
///   square of the points); 3 times that, since errors of neighbouring points are not independent.
/// - The less of a segment is seen, the likelier it is fitted to something else: a share of `visible` (of
/// each
///   segment; for hands and feet the worse of itself and the segment that carries it).
/// The constants are set so that kSpreadQuantile times the result holds 99 in 100 raw errors of the simulated
/// captures (tests/tracking/tracker, docs/tracking.md). Does not allocate, does not throw.
std::array<double, humanmodel::kJointCount> trackedSpreads(const BodyRig& rig, const BodySolver& problem,
                                                           double residual,
                                                           const std::array<double, kRigSegments>& visible);

}  // namespace abstand::tracking
