// Writes meshes with vertex colours and vertex values as PLY.
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
  std::vector<Rgb> colours;           ///< one for each vertex
  std::vector<std::string> names;     ///< names of the vertex values: letters, digits and underscores
  std::vector<double> values;         ///< row-major: for each vertex one value for each name
  std::vector<std::string> comments;  ///< one line each

  /// Adds a flat quadrangle of one colour with four new vertices; corners counter-clockwise seen from
  /// outside. `of_vertex`: one value for each name.
  void addQuad(const std::array<Vector3d, 4>& corners, const Rgb& colour,
               const std::vector<double>& of_vertex);
};

/// Writes binary little-endian PLY, completely or not at all: vertices x, y, z in metres, red, green, blue,
/// and the values in single precision; triangles. Throws UsageError and WriteError.
void savePly(const ColouredMesh& mesh, const std::filesystem::path& file);

}  // namespace abstand::mesh_file
