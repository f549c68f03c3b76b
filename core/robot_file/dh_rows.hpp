// Denavit-Hartenberg rows between two frames.
#pragma once

#include <vector>

#include "core/math/transform.hpp"

namespace abstand::robot_file {

/// One row by the modified convention [Craig, Introduction to Robotics, eq. 3.6]:
/// T = RotX(alpha) TransX(a) RotZ(theta) TransZ(d). m, rad.
struct DhRow {
  double a{0.0}, alpha{0.0}, d{0.0}, theta{0.0};
};
Transform transformOf(const DhRow& row);

/// Tolerance of equality: a row has four numbers, a pose six.
struct DhTolerance {
  double length{1e-10};  ///< m
  double angle{1e-11};   ///< rad; includes pi/2 with twelve digits
};

/// True if the line through `point` along the unit vector `direction` is the z axis of a frame one row away,
/// that is if it intersects the x axis at a right angle.
bool isOneRowAway(const Vector3d& point, const Vector3d& direction, const DhTolerance& tolerance);

/// The row with a = alpha = 0 that rotates about z and moves along z so that the x axis becomes the common
/// normal with the line, which is then one row away. The zero row if it is already, or if the line is so
/// nearly parallel to z (but not parallel) that the normal is far away.
DhRow rowToNormal(const Vector3d& point, const Vector3d& direction, const DhTolerance& tolerance);

/// One to three rows whose product is X within the tolerance: one if X has the form of a row, otherwise first
/// the row to the common normal of the two z axes; nearly parallel axes need one more, which makes them
/// parallel.
std::vector<DhRow> dhRows(const Transform& X, const DhTolerance& tolerance);

}  // namespace abstand::robot_file
