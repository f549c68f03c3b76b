// Volume, centre of mass and inertia of solid bodies of uniform density.
#pragma once

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::geometry {

/// Mass properties at density 1 kg/m^3, in the body's frame; scale by the density for mass and inertia.
struct MassProperties {
  double volume{0.0};                  ///< m^3
  Vector3d com{Vector3d::Zero()};      ///< m
  Matrix3d inertia{Matrix3d::Zero()};  ///< m^5, about the centre of mass
};

/// Exact for a closed mesh, by the divergence theorem (Eberly, Polyhedral Mass Properties). An open mesh is
/// closed by cones to the centre of its bounds. If the enclosed volume is not positive or the centre of mass
/// lies outside of the bounds, the mesh is not a solid: volume and inertia are 0, and com is the centroid of
/// the surface area (the centre of the bounds if there is no area).
MassProperties massProperties(const TriangleMesh& mesh);

/// Signed volume, m^3; positive for a closed mesh whose triangles face outwards. For an open mesh, the volume
/// of the cones from the centre of its bounds.
double signedVolume(const TriangleMesh& mesh);

}  // namespace abstand::geometry
