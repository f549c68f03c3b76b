// Voxels that the surface of a shape passes through.
#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/field/voxelmap_sides.hpp"

namespace abstand::field {
namespace {

// Share of a voxel below which cube and shape touch.
constexpr double kShapeTouch = 1e-9;

// True if the surface of a convex solid meets the cube about c; `half`: half edge of the cube, d: signed
// distance at c. The signed distance of a convex solid is convex, so over the cube it is largest at a corner.
// Whether it falls to 0 is decided by alternating projections between cube and solid, which converge to their
// shortest distance (Cheney, Goldstein 1959).
bool surfaceMeets(const geometry::Shape& shape, const Vector3d& c, double half, double d) {
  const double touch = kShapeTouch * half;
  if (std::abs(d) <= half) return true;
  bool any_inside = d <= touch, any_outside = d >= -touch;
  for (int i = 0; i < 8; ++i) {
    const Vector3d corner = c + half * Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    const double at_corner = geometry::distanceTo(shape, corner).distance;
    any_inside = any_inside || at_corner <= touch;
    any_outside = any_outside || at_corner >= -touch;
  }
  if (!any_outside || any_inside) return any_outside;
  // All corners and the centre are outside; the solid may still pass through a face or an edge.
  constexpr int kMaxSteps = 64;
  Vector3d p = c;
  for (int step = 0; step < kMaxSteps; ++step) {
    const geometry::ShapeDistance at = geometry::distanceTo(shape, p);
    if (at.distance <= touch) return true;
    // The solid lies behind the plane through `nearest` with normal n. If all of the cube lies in front of
    // it, the two are apart.
    const Vector3d n = (p - at.nearest) / at.distance;
    if (n.dot(c - at.nearest) - half * n.cwiseAbs().sum() > touch) return false;
    p = at.nearest.cwiseMax((c.array() - half).matrix()).cwiseMin((c.array() + half).matrix());
  }
  // Neither proven: counts as touching.
  return true;
}

}  // namespace

void markShape(const geometry::Shape& shape, const VoxelGrid& grid, int threads,
               std::vector<std::int8_t>& side) {
  const double s = grid.voxel_size;
  const double half_diagonal = 0.5 * std::sqrt(3.0) * s * (1.0 + kShapeTouch);
  parallelFor(threads, grid.size.z(), [&](std::size_t slice) {
    const int k = static_cast<int>(slice);
    for (int j = 0; j < grid.size.y(); ++j) {
      for (int i = 0; i < grid.size.x();) {
        const Vector3d c = grid.centre(i, j, k);
        const double d = geometry::distanceTo(shape, c).distance;
        std::int8_t value = kVoxelSurface;
        int run = 1;
        if (std::abs(d) > half_diagonal) {
          // Up to here along the row the surface is farther than half a diagonal, on the same side.
          value = d < 0.0 ? kVoxelInside : kVoxelOutside;
          run += static_cast<int>(std::min((std::abs(d) - half_diagonal) / s, double(grid.size.x())));
        } else if (!surfaceMeets(shape, c, 0.5 * s, d)) {
          value = d < 0.0 ? kVoxelInside : kVoxelOutside;
        }
        for (const int end = std::min(grid.size.x(), i + run); i < end; ++i)
          side[grid.index(i, j, k)] = value;
      }
    }
  });
}

}  // namespace abstand::field
