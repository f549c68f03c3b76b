// Damping and friction of contacts: a pure penalty force is elastic.
#pragma once

#include "core/math/transform.hpp"

namespace abstand::physics {

struct ContactOptions {
  /// s/m: the penalty force is multiplied by (1 - dissipation x separation speed), never below 0 [Hunt,
  /// Crossley 1975, Coefficient of restitution interpreted as damping in vibroimpact]. 0: elastic.
  double dissipation{5.0};
  /// Coulomb coefficient. Below the speed `creep` friction is proportional to speed: bodies on slopes creep.
  double friction{0.3};
  double creep{0.002};  ///< m/s
  /// m: distance of the contact points from their centre; rotation is damped as the motion of points at this
  /// distance.
  double patch{0.03};
};

/// Contact of bodies A and B in one step. World frame. Force and torque on A as in PairResult.
struct Contact {
  Vector3d force_a{Vector3d::Zero()};   ///< N
  Vector3d torque_a{Vector3d::Zero()};  ///< N m, about p_a
  Vector3d p_a{Vector3d::Zero()};       ///< m, A's centre of mass
  Vector3d near{Vector3d::Zero()};      ///< m, contact location: midpoint of the witness points
  /// Velocity of A relative to B at `near` that the physics does not know: a person following a recording,
  /// with the sign of the moving body.
  Twist carried{};
};

/// The point nearest to `contact.near` on the line of action of the contact force, which is not 0.
Vector3d contactPoint(const Contact& contact);

/// Relative motion of A and B at the contact point, and the mobilities of both (1/kg, and 1/(kg m^2)): along
/// the normal, along the slip, about the axis of rotation. Mobilities limit the damping: a step removes at
/// most half of the velocity, so stiff contacts stay stable.
struct ContactMotion {
  Twist relative;
  double normal_mobility{0.0}, slip_mobility{0.0}, turn_mobility{0.0};
};

/// Wrench to add to the penalty wrench: on A, torque about the contact point; on B the opposite. Passive: its
/// power with `relative` is <= 0. `h`: time step, s. No allocation, no throw.
Wrench contactDamping(const Contact& contact, const ContactMotion& motion, const ContactOptions& options,
                      double h);

}  // namespace abstand::physics
