// Sharp edges of a mesh.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::shell {

/// A sharp convex edge of a mesh.
struct SharpEdge {
  Vector3d normal[2];  ///< outward unit normals of its two triangles
  Vector3d end[2];
  Vector3d along() const { return (end[1] - end[0]).normalized(); }
  /// Distance from p to the edge (m).
  double distance(const Vector3d& p) const {
    const Vector3d edge = end[1] - end[0], from = p - end[0];
    return (from - std::clamp(from.dot(edge) / edge.squaredNorm(), 0.0, 1.0) * edge).norm();
  }
};

struct SharpEdges {
  /// one entry for each triangle; bit i: its edge from corner i to corner i + 1 is sharp, open or shared by
  /// more than two triangles
  std::vector<std::uint8_t> sharp;
  std::vector<SharpEdge> sharp_edges;
};

/// Outward unit normals of the triangles; zero for degenerate ones.
std::vector<Vector3d> faceNormals(const geometry::TriangleMesh& mesh);

/// `normals`: those of the triangles. Sharp: the angle between the two normals exceeds 35 degrees.
SharpEdges findSharpEdges(const geometry::TriangleMesh& mesh, const std::vector<Vector3d>& normals);

}  // namespace abstand::shell
