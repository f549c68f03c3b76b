// Bounding sphere and accumulated motion bound of a body.
#pragma once

#include "core/geometry/enclosing_sphere.hpp"

namespace abstand::scene {

/// A body's bounding sphere in the world, and an upper bound on the accumulated displacement of every point:
/// the certificate for skipping a query. It uses the poses that were set, so it holds for a body of any
/// speed.
///
/// From one pose to the next the point with offset u (|u| <= r) from the centre moves by dc + dR u, so by at
/// most |dc| + r ||dR||. The difference of two rotations by an angle theta has the singular values 2
/// sin(theta/2), twice, and 0, so ||dR|| = ||dR||_F / sqrt(2). A matrix that is not exactly a rotation
/// differs from the nearest one by at most e = ||R R^T - I||_F, so ||dR|| <= (||dR||_F + e0 + e1) / sqrt(2) +
/// e0 + e1. Sums are rounded up.
class MotionBound {
 public:
  /// At the identity.
  explicit MotionBound(const geometry::EnclosingSphere& sphere_B);

  /// Upper bound (m) on the displacement of every point of the body from the last pose to this one; adds it
  /// to travelled().
  double moveTo(const Transform& X_WB);

  const Vector3d& centre() const { return centre_; }  ///< world
  double radius() const { return radius_; }           ///< m
  /// Accumulated motion bound (m) since construction; only differences are meaningful. Never decreases.
  double travelled() const { return travelled_; }

 private:
  geometry::EnclosingSphere sphere_B_;
  Matrix3d R_WB_{Matrix3d::Identity()};
  Vector3d centre_;
  double radius_;
  double defect_{0.0};  ///< e of the current pose
  double travelled_{0.0};
};

/// Gap of the bounding spheres (m, signed): lower bound of the distance of the bodies.
double gapOf(const MotionBound& a, const MotionBound& b);

}  // namespace abstand::scene
