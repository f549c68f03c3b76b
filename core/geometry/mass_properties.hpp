// Volume, centre of mass and inertia of solid bodies of uniform density.
#pragma once

#include "core/geometry/triangle_mesh.hpp"

namespace abstand {

/// Of a solid of density 1 kg/m^3, in the body's frame. Times a density: mass and inertia.
struct MassProperties {
  double volume{0.0};                    ///< m^3
  Vector3d com{Vector3d::Zero()};        ///< m
  Matrix3d inertia{Matrix3d::Zero()};    ///< m^5, about the centre of mass
};

/// Exact for a closed mesh by the divergence theorem (Eberly, Polyhedral Mass Properties).
/// For an open mesh whose signed volume is not positive, the centre of the surface area stands in.
MassProperties massProperties(const TriangleMesh& mesh);

}  // namespace abstand
