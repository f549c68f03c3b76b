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
  /// m, from p to the edge.
  double distance(const Vector3d& p) const {
    const Vector3d way = end[1] - end[0], from = p - end[0];
    return (from - std::clamp(from.dot(way) / way.squaredNorm(), 0.0, 1.0) * way).norm();
  }
};

struct SharpEdges {
  /// By triangle; bit i: its edge from corner i to corner i + 1 is sharp, open or shared by more than two.
  std::vector<std::uint8_t> sharp;
  std::vector<SharpEdge> sharp_edges;
};

/// Outward unit normals of the triangles; zero for one without area.
std::vector<Vector3d> faceNormals(const geometry::TriangleMesh& mesh);

/// `normals`: of the triangles. Sharp: the two turn by more than 35 degrees.
SharpEdges findSharpEdges(const geometry::TriangleMesh& mesh, const std::vector<Vector3d>& normals);

}  // namespace abstand::shell
