// Triangles with shared vertices.
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

/// Multiplies the coordinates by `scale`, one factor an axis, none 0. Where that mirrors the mesh, its
/// triangles are turned, so that outside stays outside.
void stretch(TriangleMesh& mesh, const Vector3d& scale);

/// m^2.
double surfaceArea(const TriangleMesh& mesh);

/// Merges vertices within `tolerance` (m; 0 merges equal ones) and drops triangles that collapse by it
/// and vertices that no triangle uses. The first vertex of a cluster stands for the others, so none
/// moves by more than the tolerance. Vertices are numbered in the order in which triangles use them.
TriangleMesh weld(const TriangleMesh& mesh, double tolerance);

}  // namespace abstand::geometry
