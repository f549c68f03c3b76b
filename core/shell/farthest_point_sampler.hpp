// How far the surface is from its shell points at most.
#pragma once

#include "core/shell/pointshell_tree.hpp"
#include "core/shell/sub_triangles.hpp"

namespace abstand::shell {

/// Certified upper bound (m) on the distance from any point of the mesh to the nearest of `points`, at most
/// kCoverSlack above the truth. `nearest[i]`: a point near the i-th piece of the pool (any point will do, a
/// near one makes it quick). For one point q and one triangle the largest distance is at a corner, so the
/// triangle is covered within max_corners |corner - q|; where that is not tight the triangle is halved
/// (branch and bound).
double coveringRadius(const SubTriangles& pool, const std::vector<Vector3f>& points,
                      const std::vector<std::uint32_t>& nearest);

/// Relative.
inline constexpr double kCoverSlack = 0.005;

}  // namespace abstand::shell
