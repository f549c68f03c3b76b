// From the bytes of a mesh file to raw triangles; internal to mesh_file.cpp.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.hpp"
#include "core/geometry/triangle_mesh.hpp"

namespace abstand::mesh_file {

/// Throws ParseError when a header claims more elements than the file has bytes for, before a library
/// allocates by the claim. `format`: "stl", "ply", "off"; others make no claims.
void refuseFalseClaims(std::string_view content, std::string_view format, const std::string& name);

/// Triangles as assimp gives them, node transforms applied: file units (DAE: metres, axes as written, as
/// URDF expects), not welded, perhaps none. Polygons are triangulated; points and lines left out. All
/// coordinates are finite. Throws ParseError; `name` is the file's.
TriangleMesh readWithAssimp(std::string_view content, std::string_view format, const std::string& name);

}  // namespace abstand::mesh_file
