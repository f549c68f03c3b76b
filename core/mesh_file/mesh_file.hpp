// Mesh files: STL, OBJ, PLY, OFF and COLLADA in, STL and OBJ out.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/mesh_file/mesh_report.hpp"

namespace abstand::mesh_file {

/// Largest coordinate of a vertex, m. Beyond it, squares and volumes lose the digits that distances need.
inline constexpr double kFarthestVertex = 1e6;

struct LoadedMesh {
  geometry::TriangleMesh mesh;  ///< metres, welded, no degenerate triangle
  MeshReport report;
};

/// Reads STL (ascii, binary), OBJ, PLY, OFF and DAE, told apart by the extension in any case; of a file
/// with several bodies or nodes, all of them, in their places.
///
/// Coordinates times `scale` are metres. A DAE file's own unit is applied as well, so that a DAE that
/// states its unit needs no scale. Its up axis is not: axes stay as the file has them, as URDF expects.
/// Polygons are cut into triangles, vertices welded (within 1e-6 of the mesh's diagonal), degenerate
/// triangles dropped and counted, and a closed mesh that is inside out is turned; report.remarks say so.
///
/// These five readers are our own and take memory in proportion to the file, whatever its header claims:
/// assimp 5.2 crashes or hangs on some hostile files of these formats and loses faces of honest ones
/// (docs/third-party.md). What other formats assimp knows (3ds, glTF, X, ...) it reads, in a process of its
/// own; such a file must stand alone, whatever it refers to.
///
/// Throws ParseError with the file's name for anything that gives no triangle, for coordinates that are not
/// finite or beyond kFarthestVertex, and for a file larger than 512 MiB; UsageError for a scale that is not
/// finite and positive.
LoadedMesh loadMesh(const std::filesystem::path& file, double scale = 1.0);

/// loadMesh for the content of a file: `format` is the extension without the point ("stl"), `name` goes
/// into errors.
LoadedMesh parseMesh(std::string_view content, std::string_view format, const std::string& name,
                     double scale = 1.0);

/// Binary STL or OBJ by the extension, metres, written whole or not at all. STL has single precision.
/// Throws UsageError.
void saveMesh(const geometry::TriangleMesh& mesh, const std::filesystem::path& file);

}  // namespace abstand::mesh_file
