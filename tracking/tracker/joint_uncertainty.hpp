// Uncertainty of joints of visible segments.
#pragma once

#include "tracking/body/joint_spread.hpp"

namespace abstand::tracking {

/// Covariance (m^2, world) of each joint's raw error; five independent terms:
/// - Model difference: recordings define joints differently, and bodies differ from the model: constants for
///   each joint, along the axes of its segment. Errors along a limb or the trunk are up to twice those
///   across.
/// - Fit: covariance of the last fit (jointCovariances) times the square of 3 `residual` (m, RMS of the
///   points), as errors of neighbouring points are correlated.
/// - Occlusion: the less of a segment is visible, the likelier it is fitted to something else: a constant for
///   each joint times (1 - `visible`)^1.5 of its segment.
/// - Touch: a hand on the trunk or on a thigh and a foot at the other leg are hardly told from these: a
///   constant for each joint, from a `gap` (m, DepthFit::gaps()) of 0.04 m on.
/// - Fold: the hips, and the knee of a thigh, are up to 0.2 m off where the thigh lies on the trunk: a term
/// that
///   begins at an angle of 60 degrees between both and is whole at 20.
/// The constants were chosen on the simulated captures and postures that also judge them
/// (tests/tracking/tracker); smaller first ones would do there, but hold less of recordings that were held
/// out (docs/tracking.md). Does not allocate or throw.
JointCovariances trackedCovariances(const BodyRig& rig, const BodySolver& problem, double residual,
                                    const std::array<double, kRigSegments>& visible,
                                    const std::array<double, kRigSegments>& gap);

}  // namespace abstand::tracking
