// Corners of a convex hull.
#pragma once

#include <vector>

#include "core/math/transform.hpp"

namespace abstand {

/// Those of the points that span their convex hull: no point reaches beyond them in any direction by more
/// than 1e-12 of the largest coordinate. All points where these span no volume. Points must be finite.
std::vector<Vector3d> hullVertices(const std::vector<Vector3d>& points);

}  // namespace abstand
