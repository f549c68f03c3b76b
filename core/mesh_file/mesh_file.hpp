// Reads STL, OBJ, PLY, OFF and COLLADA files; writes STL and OBJ.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/mesh_file/mesh_report.hpp"

namespace abstand::mesh_file {

/// Largest absolute coordinate of a vertex, m. Beyond it, squares and volumes lose precision that distances
/// need.
inline constexpr double kFarthestVertex = 1e6;

struct LoadedMesh {
  geometry::TriangleMesh mesh;  ///< metres, welded, no degenerate triangle
  MeshReport report;
};

/// Reads STL (ASCII, binary), OBJ, PLY, OFF and DAE, selected by the extension in any case. If a file has
/// several bodies or nodes, all of them are read with their transforms.
///
/// Coordinates times `scale` are metres. The unit stated in a DAE file is applied as well; its up axis is
/// not: axes stay as in the file, as URDF expects. Polygons are triangulated, vertices welded (within 1e-6 of
/// the mesh's diagonal), degenerate triangles dropped and counted, and an inverted closed mesh is reversed;
/// report.remarks lists these changes.
///
/// Memory of these five readers is proportional to the file size, whatever its header claims: assimp 5.2
/// crashes or hangs on some malicious files of these formats and loses faces of valid ones
/// (docs/third-party.md). Other formats (3ds, glTF, X, ...) are read by assimp in a child process; such a
/// file must not refer to other files.
///
/// Throws ParseError with the file's name if there is no triangle, for coordinates that are not finite or
/// exceed kFarthestVertex, and for a file larger than 512 MiB; UsageError if `scale` is not finite and
/// positive.
LoadedMesh loadMesh(const std::filesystem::path& file, double scale = 1.0);

/// loadMesh() of a file's content: `format` is the extension without the point ("stl"), `name` is used in
/// errors.
LoadedMesh parseMesh(std::string_view content, std::string_view format, const std::string& name,
                     double scale = 1.0);

/// Writes binary STL (single precision) or OBJ, selected by the extension, in metres, completely or not at
/// all. Throws UsageError.
void saveMesh(const geometry::TriangleMesh& mesh, const std::filesystem::path& file);

}  // namespace abstand::mesh_file
