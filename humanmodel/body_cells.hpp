// Grid of surface cells on a body part, comparable between people of any size.
#pragma once

#include <array>
#include <string>

#include "core/geometry/shape.hpp"

namespace abstand::humanmodel {

/// Cells along the edge of each of a part's six sides.
inline constexpr std::size_t kCellRows = 8;
inline constexpr std::size_t kCellCount = 6 * kCellRows * kCellRows;

/// The cell that contains a surface point of a part. `u`: the point in the part's frame P, divided by the
/// half extents of the part for each axis; finite, not zero. Equiangular cubed sphere: six sides in the order
/// +x (front), -x (back), +y (left), -y (right), +z (upper end), -z (lower end), whose angles are divided
/// evenly.
std::size_t cellOf(const Vector3d& u);

/// Unit vectors `u` of the corners of a cell, counter-clockwise seen from outside.
std::array<Vector3d, 4> cellCorners(std::size_t cell);
/// Unit vector `u` of the cell's centre.
Vector3d cellMiddle(std::size_t cell);

/// The surface point (in P) of an ellipsoid or a cuboid in the direction `u`, inverse of cellOf().
Vector3d surfacePoint(const geometry::Shape& shape, const Vector3d& u);

/// "front", "back, left": the side, and a second side if the cell is near it.
std::string cellPlace(std::size_t cell);

}  // namespace abstand::humanmodel
