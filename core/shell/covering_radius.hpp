// Covering radius of a pointshell.
#pragma once

#include "core/shell/pointshell_tree.hpp"
#include "core/shell/sub_triangles.hpp"

namespace abstand::shell {

/// Certified upper bound (m) on the distance from any point of the mesh to the nearest of `points`, too large
/// by at most the share kCoverSlack. Branch and bound: for one shell point q the largest distance from a
/// triangle is at a corner, so max_corners |corner - q| is an upper bound for the triangle; where it is not
/// tight the triangle is halved. `nearest[i]`: index of a shell point near sub-triangle i (any point is
/// valid, a near one is fast).
double coveringRadius(const SubTriangles& pool, const std::vector<Vector3f>& points,
                      const std::vector<std::uint32_t>& nearest);

/// Relative.
inline constexpr double kCoverSlack = 0.005;

}  // namespace abstand::shell
