// A force that the user applies to a link with the pointer.
#pragma once

#include "core/base/id.hpp"
#include "core/math/transform.hpp"

namespace abstand::loop {

/// A spring without length from a point of a body to a point in the world. It acts on the reaction of the
/// robot as a contact force would, f = k (target - p) at p, and on nothing else.
struct Poke {
  static constexpr double kStiffness = 400.0;  ///< N/m: a hand's width gives 40 N
  static constexpr double kMaxForce = 150.0;   ///< N; the strongest push of one hand, about
  /// s of wall time: a poke that nobody has renewed for so long ends.
  static constexpr double kTimeout = 0.25;

  ObjectId object{0};
  Vector3d p_B{Vector3d::Zero()};       ///< m, frame of the body
  Vector3d target_W{Vector3d::Zero()};  ///< m, world

  /// N, world, with the point at `p_W`; at most kMaxForce.
  Vector3d force(const Vector3d& p_W) const {
    const Vector3d f = kStiffness * (target_W - p_W);
    const double size = f.norm();
    return size > kMaxForce ? Vector3d(f * (kMaxForce / size)) : f;
  }
};

}  // namespace abstand::loop
