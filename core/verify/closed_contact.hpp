// Closed forms of contact forces under the volume law.
#pragma once

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::verify {

/// Force (N, for stiffness 1) between a ball of radius r and a ball of radius R with centres c apart, |R - r|
/// < c < R + r, where r's surface is pressed by its depth in R: integral over the cap, 2 pi r^2 int (R -
/// sqrt(c^2 + r^2 - 2 c r u)) u du.
double ballInBallForce(double r, double R, double c);

/// Volume of the part of a ball of radius r below a plane, at penetration `depth`.
double capVolume(double r, double depth);

/// Part of a closed mesh below z = 0: volume and centroid. As in buoyancy, a wall with the upper face z = 0
/// pushes with stiffness times volume, upwards, through the centroid.
struct Submerged {
  double volume{0.0};
  Vector3d centroid{Vector3d::Zero()};
};
Submerged submerged(const geometry::TriangleMesh& mesh, const Transform& X_WB);

/// Force (N, for stiffness 1) that centres a pin of radius r and length l in a long hole of radius R > r at
/// the eccentricity `offset`: l r int (rho - R) cos(phi) dphi where the pin's surface has rho > R from the
/// hole's axis.
double pinInHoleForce(double r, double R, double offset, double length);

}  // namespace abstand::verify
