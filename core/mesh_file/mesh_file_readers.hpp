// One reader a mesh format; internal to mesh_file.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/error.hpp"
#include "core/geometry/triangle_mesh.hpp"

namespace abstand::mesh_file {

/// Triangles as the file has them: file units (DAE: metres), not welded, perhaps none. All coordinates
/// are finite and all indices valid. Throws ParseError; `name` is the file's.
geometry::TriangleMesh readStl(std::string_view content, const std::string& name);
geometry::TriangleMesh readObj(std::string_view content, const std::string& name);
geometry::TriangleMesh readPly(std::string_view content, const std::string& name);
geometry::TriangleMesh readOff(std::string_view content, const std::string& name);
geometry::TriangleMesh readDae(std::string_view content, const std::string& name);

/// Any other format that assimp knows, by its extension in lower case. assimp runs in a child process with
/// limits on time and memory: a file that makes it crash or hang is an error like any other. Never throws
/// anything else.
geometry::TriangleMesh readWithAssimp(std::string_view content, std::string_view format,
                                      const std::string& name);

/// Cuts polygons into triangles over the vertices of `mesh`, whose winding they keep; concave ones by
/// clipping ears. Fewer than three corners give nothing.
class PolygonCutter {
 public:
  explicit PolygonCutter(geometry::TriangleMesh& mesh) : mesh_(mesh) {}

  /// Adds the polygon's triangles. Throws ParseError when an index is not a vertex, or when concave
  /// polygons take more work than any honest file.
  void add(std::span<const std::uint32_t> corners, const SourcePos& pos);

 private:
  void clipEars(std::span<const std::uint32_t> corners, const Vector3d& normal, const SourcePos& pos);

  geometry::TriangleMesh& mesh_;
  std::uint64_t work_{0};
};

}  // namespace abstand::mesh_file
