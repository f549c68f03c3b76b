// Triangle mesh with shared vertices.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::geometry {

/// Triangles over shared vertices, metres, in the body's own frame; counter-clockwise seen from
/// outside, so that (v1 - v0) x (v2 - v0) points outwards.
struct TriangleMesh {
  std::vector<Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  const Vector3d& corner(std::size_t triangle, int i) const { return vertices[triangles[triangle][i]]; }
};

/// Axis-aligned box; empty until the first point.
struct Bounds {
  Vector3d lower{Vector3d::Constant(kInfinity)};
  Vector3d upper{Vector3d::Constant(-kInfinity)};
  void add(const Vector3d& p) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  Vector3d centre() const { return 0.5 * (lower + upper); }
  Vector3d extent() const { return upper - lower; }
};

Bounds bounds(const TriangleMesh& mesh);

/// Scales the coordinates by one non-zero factor for each axis. If that mirrors the mesh, the triangles are
/// reversed, so that they still face outwards.
void stretch(TriangleMesh& mesh, const Vector3d& scale);

/// Surface area, m^2.
double surfaceArea(const TriangleMesh& mesh);

/// Merges vertices within `tolerance` (m; 0 merges equal ones), then drops degenerate triangles and unused
/// vertices. A cluster is represented by its first vertex, so none moves by more than the tolerance. Vertices
/// are numbered in the order in which triangles use them.
TriangleMesh weld(const TriangleMesh& mesh, double tolerance);

}  // namespace abstand::geometry
