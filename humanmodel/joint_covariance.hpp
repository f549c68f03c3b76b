// Position error of a joint as an ellipsoid.
#pragma once

#include "humanmodel/joints.hpp"

namespace abstand::humanmodel {

/// Covariance (m^2, world axes) of the error of a joint: SkeletonFrame::covariance if it is symmetric and
/// positive semidefinite and its largest eigenvalue is the square of the spread, otherwise that of an
/// isotropic error: if only the spread was stated or changed, it holds in all directions. Infinite on the
/// diagonal for an infinite spread. No allocation, no throw.
Matrix3d covarianceOf(const SkeletonFrame& frame, Joint joint);

/// States a covariance and the spread that belongs to it. A matrix that is not finite: infinite.
void setCovariance(SkeletonFrame& frame, Joint joint, const Matrix3d& covariance);
/// Adds an independent, isotropic error of the standard deviation `sigma` (m).
void addSpread(SkeletonFrame& frame, Joint joint, double sigma);

/// Covariance whose ellipsoid contains every sum of a point of that of `a` and a point of that of `b`, for
/// errors that are not known to be independent: (1 + 1/k) a + (1 + k) b is an upper bound of the Minkowski
/// sum for every k > 0; k is the one with the smallest trace. Of isotropic errors, the spreads add.
Matrix3d sumEnclosing(const Matrix3d& a, const Matrix3d& b);
/// Likewise of the points up to `offset` (m) from the centre in its direction: the joint may be there
/// instead.
Matrix3d sumWithOffset(const Matrix3d& a, const Vector3d& offset);
/// Adds to the reach of a joint `radius` (m) in all directions.
void addRadius(SkeletonFrame& frame, Joint joint, double radius);

/// An upper bound C of both: C - a and C - b are positive semidefinite, so that its ellipsoid contains
/// theirs. Infinite if one of them is.
Matrix3d enclosingCovariance(const Matrix3d& a, const Matrix3d& b);

/// m: standard deviation along the worst axis.
double worstDeviation(const Matrix3d& covariance);

/// m: largest displacement along `d` (unit vector) of the points of the ellipsoid that holds 99 % of the
/// errors: kSpreadQuantile times sqrt(d . C d).
double reachAlong(const Matrix3d& covariance, const Vector3d& d);
/// m: distance from the centre to the surface of that ellipsoid in the direction of `d`: an error e is inside
/// if |e| <= radiusToward(C, e / |e|). 0 if the ellipsoid has no extent there.
double radiusToward(const Matrix3d& covariance, const Vector3d& d);

}  // namespace abstand::humanmodel
