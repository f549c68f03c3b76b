// The meshes of a scene, ready to be drawn.
#pragma once

#include <memory>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::ui {

/// See mesh_data.hpp; constant, and drawn by one viewport.
struct PreparedMeshes;

/// Takes most of the time of showing a scene; any thread. One mesh for each object, body frame.
std::shared_ptr<const PreparedMeshes> prepareMeshes(const std::vector<geometry::TriangleMesh>& meshes);

}  // namespace abstand::ui
