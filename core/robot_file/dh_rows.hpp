// Rows of a Denavit-Hartenberg table that lead from one frame to another.
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

/// What counts as the same: a row has four numbers where a pose has six.
struct DhTolerance {
  double length{1e-10};  ///< m
  double angle{1e-11};   ///< rad; pi/2 with twelve digits is within it
};

/// The line through `point` along the unit vector `direction`, in a frame: is it the z axis of a frame one
/// row away? So it is when it meets the x axis at a right angle.
bool isOneRowAway(const Vector3d& point, const Vector3d& direction, const DhTolerance& tolerance);

/// The row a = alpha = 0 that turns a frame about its z axis and moves it along it so that its x axis is the
/// common normal to the line, which is then one row away. The zero row where it is already, and where the
/// line is so nearly parallel to z, but not parallel, that the normal is far away.
DhRow rowToNormal(const Vector3d& point, const Vector3d& direction, const DhTolerance& tolerance);

/// One to three rows whose product is X within the tolerance: one where X has the form of a row, else first
/// the row to the common normal of the two z axes; nearly parallel axes take one more, which makes them
/// parallel.
std::vector<DhRow> dhRows(const Transform& X, const DhTolerance& tolerance);

}  // namespace abstand::robot_file
