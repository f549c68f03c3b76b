// Accuracy of a camera pose, and of the points that the camera sees.
#pragma once

#include "core/math/transform.hpp"

namespace abstand::tracking {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// X translated by the first three of `step` (m, world) and rotated by the last three (rad, world) about p_W.
Transform movedAbout(const Vector3d& p_W, const Transform& X_WC, const Vector6d& step);

/// m, standard deviation of an axis of a point at the distance `reach` (m) from p_W, averaged over all
/// directions, for the `covariance` of the steps of movedAbout(). A point at d moves by t + r x d; averaged
/// over the directions of d, |r x d|^2 is 2/3 |d|^2 |r|^2 and the coupling of t and r is 0, so
/// sqrt((tr C_t + 2/3 reach^2 tr C_r) / 3).
double spreadAt(const Matrix6d& covariance, double reach);

/// Smallest constraint of any degree of freedom for the normal matrix of the steps of movedAbout(), of rows
/// with unit normals and the mean over the rows: the smallest eigenvalue, with rotations scaled so that they
/// count by the displacement of a point at a typical distance. 0: one is not determined.
double weakestConstraint(const Matrix6d& mean_JTJ);

/// m, typical distance of people from the calibration target, for spreadAt(): someone within a robot's reach
/// is about this far from a board on its table, or from its links.
inline constexpr double kUsedWithin = 1.0;

}  // namespace abstand::tracking
