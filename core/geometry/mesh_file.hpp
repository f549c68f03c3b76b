// Mesh files; the only fence around assimp.
#pragma once

#include <filesystem>

#include "core/geometry/mesh_report.hpp"

namespace abstand {

struct LoadedMesh {
  TriangleMesh mesh;  ///< metres, welded, no degenerate triangle
  MeshReport report;
};

/// Reads STL (ascii, binary), OBJ, PLY, OFF, DAE and what else assimp knows; triangulates, applies node
/// transforms, multiplies by `scale` (metres per file unit), welds, turns an inside-out closed mesh.
/// Throws ParseError with the file's name for anything that gives no triangle.
LoadedMesh loadMesh(const std::filesystem::path& file, double scale = 1.0);

/// Binary STL or OBJ by the extension, written whole or not at all. Throws UsageError.
void saveMesh(const TriangleMesh& mesh, const std::filesystem::path& file);

}  // namespace abstand
