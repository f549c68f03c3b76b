// Sharp edges of a mesh.
#include "core/shell/pointshell_sharp_edges.hpp"

#include <algorithm>
#include <tuple>

namespace abstand::shell {
namespace {

/// Faces that meet at a larger angle are sampled separately.
constexpr double kSharpAngle = unit::deg(35.0);

struct Edge {
  std::uint32_t low, high, triangle, side;
};

}  // namespace

std::vector<Vector3d> faceNormals(const geometry::TriangleMesh& mesh) {
  std::vector<Vector3d> normals;
  normals.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3d cross =
        (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0));
    const double length = cross.norm();
    normals.push_back(length > 0.0 ? Vector3d(cross / length) : Vector3d::Zero());
  }
  return normals;
}

SharpEdges findSharpEdges(const geometry::TriangleMesh& mesh, const std::vector<Vector3d>& normals) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t a = mesh.triangles[t][side], b = mesh.triangles[t][(side + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), t, side});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& l, const Edge& r) {
    return std::tie(l.low, l.high, l.triangle, l.side) < std::tie(r.low, r.high, r.triangle, r.side);
  });
  SharpEdges out;
  out.sharp.assign(mesh.triangles.size(), 0);
  const double smooth = std::cos(kSharpAngle);
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    if (end == i + 2 && normals[edges[i].triangle].dot(normals[edges[i + 1].triangle]) >= smooth) continue;
    if (end == i + 2) {
      const Edge &e = edges[i], &f = edges[i + 1];
      const Vector3d across = mesh.corner(f.triangle, (f.side + 2) % 3) - mesh.vertices[e.low];
      if (normals[e.triangle].dot(across) < 0.0) {
        out.sharp_edges.push_back(
            {{normals[e.triangle], normals[f.triangle]}, {mesh.vertices[e.low], mesh.vertices[e.high]}});
      }
    }
    for (std::size_t k = i; k < end; ++k) out.sharp[edges[k].triangle] |= std::uint8_t(1u << edges[k].side);
  }
  return out;
}

}  // namespace abstand::shell
