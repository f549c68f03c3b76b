// The surface of a body part in cells that are the same for people of every size.
#pragma once

#include <array>
#include <string>

#include "core/geometry/shape.hpp"

namespace abstand::humanmodel {

/// Cells along the edge of each of a part's six sides.
inline constexpr std::size_t kCellRows = 8;
inline constexpr std::size_t kCellCount = 6 * kCellRows * kCellRows;

/// The cell in which a point of a part's surface lies. `u` is the point in the part's frame P, divided by the
/// half extents of the part, axis by axis; finite, of any length but 0. Sides are those of a cube about the
/// part, in the order +x (front), -x (back), +y (left), -y (right), +z (upper end), -z (lower end); cells
/// divide their angles evenly (equiangular cubed sphere).
std::size_t cellOf(const Vector3d& u);

/// Unit vectors `u` to the corners of a cell, counter-clockwise seen from outside.
std::array<Vector3d, 4> cellCorners(std::size_t cell);
/// Unit vector `u` to its middle.
Vector3d cellMiddle(std::size_t cell);

/// The point in P of an ellipsoid's or a cuboid's surface that lies towards `u`, as cellOf() has it.
Vector3d surfacePoint(const geometry::Shape& shape, const Vector3d& u);

/// "front", "back, left": the side, and where a neighbour is not far the neighbour.
std::string cellPlace(std::size_t cell);

}  // namespace abstand::humanmodel
