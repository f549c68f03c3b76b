// Meshes of bodies used by checks.
#pragma once

#include <utility>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::verify {

geometry::TriangleMesh boxMesh(const Vector3d& size, const Vector3d& centre = Vector3d::Zero());
/// Prism over a simple polygon in x and y, counter-clockwise, from z = -height/2 to height/2. Caps are
/// triangulated by ear clipping.
geometry::TriangleMesh prismMesh(const std::vector<std::pair<double, double>>& polygon, double height);
/// Pyramid with a square base of edge `base` in z = 0 and its tip at z = height.
geometry::TriangleMesh spikeMesh(double base, double height);
/// An icosahedron with corners at distance `inner` and a tip at distance `outer` over each face.
geometry::TriangleMesh starMesh(double inner, double outer);
/// Torus about z: `around` times `across` quads.
geometry::TriangleMesh torusMesh(double ring, double tube, int around, int across);
/// Solid of revolution about z of a polygon in r and z, counter-clockwise.
geometry::TriangleMesh latheMesh(const std::vector<std::pair<double, double>>& profile, int around);
/// Four triangles, folded along y; open.
geometry::TriangleMesh foldedSheet(double size);

geometry::TriangleMesh inverted(geometry::TriangleMesh mesh);
geometry::TriangleMesh together(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b);

}  // namespace abstand::verify
