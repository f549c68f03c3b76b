// Meshes of bodies for checks.
#pragma once

#include <utility>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::verify {

geometry::TriangleMesh boxMesh(const Vector3d& size, const Vector3d& centre = Vector3d::Zero());
/// A simple polygon in x and y, counter-clockwise, from z = -height/2 to height/2. Its caps are cut into
/// triangles by ears.
geometry::TriangleMesh prismMesh(const std::vector<std::pair<double, double>>& polygon, double height);
/// A square base of edge `base` in z = 0, its tip at z = height.
geometry::TriangleMesh spikeMesh(double base, double height);
/// An icosahedron with corners at `inner` whose faces are raised to tips at `outer` from the centre.
geometry::TriangleMesh starMesh(double inner, double outer);
/// A ring about z: `around` times `across` quads.
geometry::TriangleMesh torusMesh(double ring, double tube, int around, int across);
/// A polygon in r and z, counter-clockwise, turned about z.
geometry::TriangleMesh latheMesh(const std::vector<std::pair<double, double>>& profile, int around);
/// Four triangles, folded along y; open.
geometry::TriangleMesh foldedSheet(double size);

geometry::TriangleMesh inverted(geometry::TriangleMesh mesh);
geometry::TriangleMesh together(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b);

}  // namespace abstand::verify
