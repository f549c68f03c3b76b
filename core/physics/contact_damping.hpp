// What makes bodies that touch come to rest: a penalty force alone gives back all that it took.
#pragma once

#include "core/math/transform.hpp"

namespace abstand::physics {

struct ContactOptions {
  /// s/m: the penalty force times (1 - dissipation x speed of separation), never below 0 [Hunt, Crossley
  /// 1975, Coefficient of restitution interpreted as damping in vibroimpact]. 0: elastic.
  double dissipation{5.0};
  /// Coulomb's coefficient. Slower than `creep` the friction falls with the speed: bodies on slopes creep.
  double friction{0.3};
  double creep{0.002};  ///< m/s
  /// m: how far the points that touch are from their middle. Turning dissipates as their motion would.
  double patch{0.03};
};

/// One pair of bodies A, B that touch, in one step. World frame. The force and torque on A as in PairResult.
struct Contact {
  Vector3d force_a{Vector3d::Zero()};   ///< N
  Vector3d torque_a{Vector3d::Zero()};  ///< N m, about p_a
  Vector3d p_a{Vector3d::Zero()};       ///< m, A's centre
  Vector3d near{Vector3d::Zero()};      ///< m, near where they touch: the middle between the witnesses
  /// Velocity of A against B at `near` as far as the physics does not know it: of a person who follows a
  /// recording, with the sign of who moves.
  Twist carried{};
};

/// The point of the line along which the contact force acts that is nearest to `contact.near`. The force is
/// not 0.
Vector3d contactPoint(const Contact& contact);

/// How fast A moves against B, seen at the contact point, and how easily both give way (1/kg, and 1/(kg
/// m^2)): along the normal, along the slip, about the axis of turning. Mobilities bound the damping: in one
/// step it takes at most half of the velocity, so stiff contacts stay stable.
struct ContactMotion {
  Twist relative;
  double normal_mobility{0.0}, slip_mobility{0.0}, turn_mobility{0.0};
};

/// What to add to the penalty wrench: on A, torque about the contact point; on B the opposite. It never feeds
/// energy: its power against `relative` is 0 or less. `h`: the step, s. No allocation, no throw.
Wrench contactDamping(const Contact& contact, const ContactMotion& motion, const ContactOptions& options,
                      double h);

}  // namespace abstand::physics
