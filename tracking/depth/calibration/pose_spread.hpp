// Accuracy of a camera pose, and of the points that the camera sees.
#pragma once

#include "core/math/transform.hpp"

namespace abstand::tracking {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// X translated by the first three of `step` (m, world) and rotated by the last three (rad, world) about p_W.
Transform movedAbout(const Vector3d& p_W, const Transform& X_WC, const Vector6d& step);

/// m^2, covariance of a point at `d` (m) from p_W for the `covariance` of the steps of movedAbout(): the
/// point moves by t + r x d.
Matrix3d covarianceAt(const Matrix6d& covariance, const Vector3d& d);

/// m, standard deviation along the worst axis of what is known by a pose with the `covariance` of the steps
/// of movedAbout(): the larger one of the camera, which is at `to_camera` (m) from p_W, and of the points as
/// far from p_W as the camera, kUsedWithin at least, with the mean covariance over all directions. At the
/// distance D the mean of [d]x C_r [d]x^T is D^2 / 3 (tr C_r I - C_r), and that of the coupling of t and r is
/// 0. People between the camera and p_W are within that distance, and those as far behind p_W.
double spreadWithin(const Matrix6d& covariance, const Vector3d& to_camera);

/// Smallest constraint of any degree of freedom for the normal matrix of the steps of movedAbout(), of rows
/// with unit normals and the mean over the rows: the smallest eigenvalue, with rotations scaled so that they
/// count by the displacement of a point at a typical distance. 0: one is not determined.
double weakestConstraint(const Matrix6d& mean_JTJ);

/// m, smallest distance for spreadWithin(): people within a robot's reach are about this far from a board on
/// its table, or from its links.
inline constexpr double kUsedWithin = 1.0;

}  // namespace abstand::tracking
