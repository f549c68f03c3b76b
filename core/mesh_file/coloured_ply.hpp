// Meshes with colours and values at their vertices, out to PLY.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::mesh_file {

using Rgb = std::array<std::uint8_t, 3>;

struct ColouredMesh {
  geometry::TriangleMesh mesh;
  std::vector<Rgb> colours;           ///< one a vertex
  std::vector<std::string> names;     ///< of the values of a vertex: letters, digits and underscores
  std::vector<double> values;         ///< of each vertex as many as there are names
  std::vector<std::string> comments;  ///< a line each

  /// A flat quadrangle of one colour, its corners counter-clockwise seen from outside, with vertices of its
  /// own. `of_vertex`: as many as there are names.
  void addQuad(const std::array<Vector3d, 4>& corners, const Rgb& colour,
               const std::vector<double>& of_vertex);
};

/// Binary little-endian PLY, written whole or not at all: vertices x, y, z in metres, red, green, blue, and
/// the values, in single precision; triangles. Throws UsageError and WriteError.
void savePly(const ColouredMesh& mesh, const std::filesystem::path& file);

}  // namespace abstand::mesh_file
