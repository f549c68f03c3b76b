// One reader for each mesh format; internal to mesh_file.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/error.hpp"
#include "core/geometry/triangle_mesh.hpp"

namespace abstand::mesh_file {

/// Triangles as stored in the file: file units (DAE: metres), not welded, possibly none. All coordinates are
/// finite and all indices valid. Throws ParseError; `name` is the name of the file.
geometry::TriangleMesh readStl(std::string_view content, const std::string& name);
geometry::TriangleMesh readObj(std::string_view content, const std::string& name);
geometry::TriangleMesh readPly(std::string_view content, const std::string& name);
geometry::TriangleMesh readOff(std::string_view content, const std::string& name);
geometry::TriangleMesh readDae(std::string_view content, const std::string& name);

/// Reads any other format that assimp supports, by its extension in lower case. assimp runs in a child
/// process with limits on time and memory: a file that makes it crash or hang gives a ParseError. Throws
/// nothing else.
geometry::TriangleMesh readWithAssimp(std::string_view content, std::string_view format,
                                      const std::string& name);

/// Triangulates polygons over the vertices of `mesh`, keeping their winding; concave ones by ear clipping.
/// Polygons of fewer than three corners are ignored.
class PolygonCutter {
 public:
  explicit PolygonCutter(geometry::TriangleMesh& mesh) : mesh_(mesh) {}

  /// Adds the polygon's triangles. Throws ParseError if an index is not a vertex, or if concave polygons
  /// exceed the work limit.
  void add(std::span<const std::uint32_t> corners, const SourcePos& pos);

 private:
  void clipEars(std::span<const std::uint32_t> corners, const Vector3d& normal, const SourcePos& pos);

  geometry::TriangleMesh& mesh_;
  std::uint64_t work_{0};
};

}  // namespace abstand::mesh_file
