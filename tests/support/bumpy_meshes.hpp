// Large meshes without a symmetry or a flat place, generated.
#pragma once

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::testing {

/// A ring about z whose tube swells and shrinks by an eighth: 2 `around` `across` triangles. Closed,
/// embedded, not convex. `ring` and `tube` are radii (m).
geometry::TriangleMesh bumpyTorus(double ring, double tube, int around, int across);

/// A ball with hills and dales of all sizes down to a tenth of its radius (m), some 15 % high in all: not
/// convex, closed, embedded. As many triangles as tessellate() makes of the ball within `sagitta` (m).
geometry::TriangleMesh bumpyBall(double radius, double sagitta);

}  // namespace abstand::testing
