// Marks the voxels that triangles pass through.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/field/voxelmap_sides.hpp"

namespace abstand::field {
namespace {

// In voxels: largest gap at which triangle and cube still touch.
constexpr double kTouch = 1e-9;

// Separating axes of one projection along a coordinate axis: normals of the triangle's edges in the plane (u,
// v), against the unit square. Both ends are compared, so that rounding of an axis does not matter.
struct Projection {
  int u, v;
  std::array<double, 3> nu, nv, smallest, largest;

  Projection(const std::array<Vector3d, 3>& t, int axis) : u((axis + 1) % 3), v((axis + 2) % 3) {
    for (int i = 0; i < 3; ++i) {
      const Vector3d e = t[(i + 1) % 3] - t[i];
      nu[i] = -e[v];
      nv[i] = e[u];
      const auto at = [&](int k) { return nu[i] * t[k][u] + nv[i] * t[k][v]; };
      const auto [low, high] = std::minmax({at(0), at(1), at(2)});
      const double touch = kTouch * (std::abs(nu[i]) + std::abs(nv[i]));
      smallest[i] = low - std::max(0.0, nu[i]) - std::max(0.0, nv[i]) - touch;
      largest[i] = high - std::min(0.0, nu[i]) - std::min(0.0, nv[i]) + touch;
    }
  }
  bool overlaps(double pu, double pv) const {
    for (int i = 0; i < 3; ++i) {
      const double at = nu[i] * pu + nv[i] * pv;
      if (at < smallest[i] || at > largest[i]) return false;
    }
    return true;
  }
};

// Separating-axis test as in Schwarz and Seidel (Fast Parallel Surface and Solid Voxelization, 2010), column
// by column along the axis nearest to the triangle's normal: its plane leaves few voxels of a column. `t` in
// voxels: voxel (i, j, k) is the cube from (i, j, k) to (i + 1, j + 1, k + 1).
template <class Mark>
void forVoxels(const std::array<Vector3d, 3>& t, const Vector3i& size, Mark&& mark) {
  Vector3d n = (t[1] - t[0]).cross(t[2] - t[0]);
  int w = 0;
  n.cwiseAbs().maxCoeff(&w);
  n /= n[w];
  const int u = (w + 1) % 3, v = (w + 2) % 3;
  Vector3i low, high;
  for (int k = 0; k < 3; ++k) {
    const auto [smallest, largest] = std::minmax({t[0][k], t[1][k], t[2][k]});
    low[k] = static_cast<int>(std::clamp(std::ceil(smallest - kTouch) - 1.0, 0.0, size[k] - 1.0));
    high[k] = static_cast<int>(std::clamp(std::floor(largest + kTouch), 0.0, size[k] - 1.0));
  }
  const Projection along_w(t, w), along_u(t, u), along_v(t, v);
  // Along n, whose component w is 1, a voxel's centre is at most `reach` from the triangle's plane.
  const double reach = 0.5 * n.cwiseAbs().sum() + kTouch;
  const auto [smallest, largest] = std::minmax({n.dot(t[0]), n.dot(t[1]), n.dot(t[2])});
  Vector3i p;
  for (p[v] = low[v]; p[v] <= high[v]; ++p[v]) {
    for (p[u] = low[u]; p[u] <= high[u]; ++p[u]) {
      if (!along_w.overlaps(p[u], p[v])) continue;
      const double rest = n[u] * (p[u] + 0.5) + n[v] * (p[v] + 0.5) + 0.5;
      const int first =
          std::max(low[w], static_cast<int>(std::ceil(std::max(smallest - reach - rest, -1.0))));
      const int last =
          std::min(high[w], static_cast<int>(std::floor(std::min(largest + reach - rest, double(size[w])))));
      for (p[w] = first; p[w] <= last; ++p[w]) {
        if (along_u.overlaps(p[along_u.u], p[along_u.v]) && along_v.overlaps(p[along_v.u], p[along_v.v])) {
          mark(p);
        }
      }
    }
  }
}

}  // namespace

void markTriangle(const std::array<Vector3d, 3>& triangle, const VoxelGrid& grid,
                  std::vector<std::int8_t>& side) {
  const Vector3d corner = grid.first_centre.array() - 0.5 * grid.voxel_size;
  std::array<Vector3d, 3> t;
  for (std::size_t k = 0; k < 3; ++k) t[k] = (triangle[k] - corner) / grid.voxel_size;
  // Several threads may write the same value to the same voxel.
  forVoxels(t, grid.size, [&](const Vector3i& p) {
    std::atomic_ref(side[grid.index(p.x(), p.y(), p.z())]).store(kVoxelSurface, std::memory_order_relaxed);
  });
}

void markTriangles(const geometry::TriangleMesh& mesh, const VoxelGrid& grid, int threads,
                   std::vector<std::int8_t>& side) {
  constexpr std::size_t kBatch = 512;
  parallelFor(threads, (mesh.triangles.size() + kBatch - 1) / kBatch, [&](std::size_t batch) {
    const std::size_t end = std::min(mesh.triangles.size(), (batch + 1) * kBatch);
    for (std::size_t i = batch * kBatch; i < end; ++i)
      markTriangle({mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2)}, grid, side);
  });
}

}  // namespace abstand::field
