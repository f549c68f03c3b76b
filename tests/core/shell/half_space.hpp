// Exact overlaps of meshes and pointshells with a half-space.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "core/geometry/shape.hpp"
#include "core/geometry/surface.hpp"
#include "core/shell/pointshell.hpp"

namespace abstand::testing {

/// Volume of a closed mesh where direction . x < level: the pyramid sums of the clipped triangles, by the
/// divergence theorem with the vector field (level - direction . x) direction, which is zero on the cut.
inline double volumeBelow(const geometry::TriangleMesh& mesh, const Vector3d& direction, double level) {
  double volume = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::vector<std::pair<Vector3d, double>> clipped;
    for (int i = 0; i < 3; ++i) {
      const Vector3d &p = mesh.corner(t, i), &q = mesh.corner(t, (i + 1) % 3);
      const double dp = level - direction.dot(p), dq = level - direction.dot(q);
      if (dp > 0.0) clipped.emplace_back(p, dp);
      if ((dp > 0.0) != (dq > 0.0)) clipped.emplace_back(p + dp / (dp - dq) * (q - p), 0.0);
    }
    for (std::size_t k = 1; k + 1 < clipped.size(); ++k) {
      const auto& [a, da] = clipped[0];
      const auto& [b, db] = clipped[k];
      const auto& [c, dc] = clipped[k + 1];
      volume -= 0.5 * (b - a).cross(c - a).dot(direction) * (da + db + dc) / 3.0;
    }
  }
  return volume;
}

/// What the force law gives for stiffness 1 against the half-space direction . x < level: sum a_i depth_i
/// n_i.
inline Vector3d shellForce(const shell::Pointshell& shell, const Vector3d& direction, double level) {
  Vector3d force = Vector3d::Zero();
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const double depth = level - direction.dot(shell.point(i));
    if (depth > 0.0) force += depth * shell.area[i] * shell.normal(i);
  }
  return force;
}

/// Level at which a half-space reaches `depth` deep into the mesh.
inline double levelAt(const geometry::TriangleMesh& mesh, const Vector3d& direction, double depth) {
  double lowest = kInfinity;
  for (const Vector3d& v : mesh.vertices) lowest = std::min(lowest, direction.dot(v));
  return lowest + depth;
}

/// A plain OFF file of triangles, moved to its middle and scaled so that its longest side is `size` (m).
inline geometry::TriangleMesh readOff(const std::filesystem::path& file, double size) {
  std::ifstream in(file);
  std::string word;
  std::size_t vertices = 0, triangles = 0, edges = 0;
  in >> word >> vertices >> triangles >> edges;
  geometry::TriangleMesh mesh;
  mesh.vertices.resize(vertices);
  for (Vector3d& v : mesh.vertices) in >> v.x() >> v.y() >> v.z();
  mesh.triangles.resize(triangles);
  for (auto& t : mesh.triangles) in >> edges >> t[0] >> t[1] >> t[2];
  const geometry::Bounds box = geometry::bounds(mesh);
  for (Vector3d& v : mesh.vertices) v = (v - box.centre()) * (size / box.extent().maxCoeff());
  return mesh;
}

}  // namespace abstand::testing
