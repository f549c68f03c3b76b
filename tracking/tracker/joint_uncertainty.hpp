// Uncertainty of joints of visible segments.
#pragma once

#include "tracking/body/joint_spread.hpp"
#include "tracking/tracker/depth_fit.hpp"

namespace abstand::tracking {

/// 0 to 1: share of the points that the body leaves unexplained, from few to many. Where many are, the fit
/// may be of another posture, and says nothing about the direction of its errors.
double doubtOfExplained(double explained);
/// 0 to 1, the larger of this and of `misfit.residual`: people in thick clothes, in motion or of other
/// proportions have larger residuals, and larger errors.
double doubtOf(const DepthMisfit& misfit);
/// (1 - doubt) `covariance` + `doubt` times the ball of its largest axis.
Matrix3d rounded(const Matrix3d& covariance, double doubt);

/// What is known of a fit, see trackedCovariances().
struct FitState {
  double residual, doubt;
  const std::array<double, kRigSegments>&visible, &gap, &support;
};

/// Covariance (m^2, world) of each joint's raw error; five independent terms:
/// - Model difference: recordings define joints differently, and bodies differ from the model: constants for
///   each joint, along the axes of its segment, times a share between that of a good fit and 1 at a `doubt`
///   of 1. Errors along a limb or the trunk are up to twice those across.
/// - Fit: covariance of the last fit (jointCovariances) times the square of 3 `residual` (m, RMS of the
///   points), as errors of neighbouring points are correlated.
/// - Occlusion: the less of a segment is visible, the likelier it is fitted to something else: a constant for
///   each joint times (1 - `visible`)^1.5 of its segment, 0.7 of it if the segment alone explains 4 points
///   or more (`support`, DepthFit::support()).
/// - Touch: a hand on the trunk or on a thigh and a foot at the other leg are hardly told from these: a
///   constant for each joint, from a `gap` (m, DepthFit::gaps()) of 0.04 m on; 0.3 of it with such support.
/// - Fold: the hips, and the knee of a thigh, are up to 0.2 m off where the thigh lies on the trunk: a term
///   that begins at an angle of 60 degrees between both and is whole at 20.
/// The constants were chosen on the simulated captures and postures of tests/tracking/tracker; those of a
/// good fit on a part of them and judged on the others (docs/tracking-uncertainty.md). Does not allocate or
/// throw.
JointCovariances trackedCovariances(const BodyRig& rig, const BodySolver& problem, const FitState& state);

}  // namespace abstand::tracking
