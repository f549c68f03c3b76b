// How well the pose of a camera is known, and what that means for the points that it sees.
#pragma once

#include "core/math/transform.hpp"

namespace abstand::tracking {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// X moved by the first three of `step` (m, world) and turned by the last three (rad, world) about p_W.
Transform movedAbout(const Vector3d& p_W, const Transform& X_WC, const Vector6d& step);

/// m, standard deviation of an axis of a point `reach` (m) away from p_W, averaged over all directions, where
/// `covariance` is of the steps of movedAbout(). A point at d moves by t + r x d; the mean of |r x d|^2 over
/// the directions of d is 2/3 |d|^2 |r|^2 and that of what couples t and r is 0, so
/// sqrt((tr C_t + 2/3 reach^2 tr C_r) / 3).
double spreadAt(const Matrix6d& covariance, double reach);

/// m, how far from what it was calibrated by a camera is used, for spreadAt(). Who stands within a robot's
/// reach is about so far from a board on its table, or from its links.
inline constexpr double kUsedWithin = 1.0;

}  // namespace abstand::tracking
