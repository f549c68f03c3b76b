// Bounding sphere and accumulated motion bound of a body.
#pragma once

#include "core/geometry/enclosing_sphere.hpp"

namespace abstand::scene {

/// A body's bounding sphere in the world, and the way that no point of the body can have exceeded: the
/// certificate by which a pair may rest. It counts what happened, so it cannot be broken by a body that is
/// faster than was thought.
///
/// From one pose to the next the point with offset u (|u| <= r) from the centre moves by dc + dR u, so by
/// |dc| + r ||dR|| at most. The difference of two rotations by an angle theta has the singular values
/// 2 sin(theta/2), twice, and 0, so ||dR|| = ||dR||_F / sqrt(2): the chord of the circle that a point of the
/// equator runs on. A matrix that is no exact rotation is off the nearest one by e = ||R R^T - I||_F at most,
/// so ||dR|| <= (||dR||_F + e0 + e1) / sqrt(2) + e0 + e1. Sums are rounded up.
class MotionBound {
 public:
  /// At the identity.
  explicit MotionBound(const geometry::EnclosingSphere& sphere_B);

  /// Bound (m) on the way of every point of the body from the last pose to this one; adds it to way().
  double moveTo(const Transform& X_WB);

  const Vector3d& centre() const { return centre_; }  ///< world
  double radius() const { return radius_; }           ///< m
  /// m, since the beginning; only differences mean something. Never falls.
  double way() const { return way_; }

 private:
  geometry::EnclosingSphere sphere_B_;
  Matrix3d R_WB_{Matrix3d::Identity()};
  Vector3d centre_;
  double radius_;
  double defect_{0.0};  ///< e of the present pose
  double way_{0.0};
};

/// m, signed; no two points of the bodies are nearer, whatever their shapes.
double gapOf(const MotionBound& a, const MotionBound& b);

}  // namespace abstand::scene
