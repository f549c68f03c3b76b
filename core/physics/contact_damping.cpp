#include "core/physics/contact_damping.hpp"

#include <algorithm>

namespace abstand::physics {
namespace {

// Largest share of the velocity removed in one step.
constexpr double kMaxTaken = 0.5;

/// Damping coefficient (N s/m, N m s), limited for stability in a step of h.
double stable(double coefficient, double mobility, double h) {
  return mobility > 0.0 ? std::min(coefficient, kMaxTaken / (mobility * h)) : coefficient;
}

}  // namespace

Vector3d contactPoint(const Contact& contact) {
  const double square = contact.force_a.squaredNorm();
  const Vector3d on_line = contact.p_a + contact.force_a.cross(contact.torque_a) / square;
  return on_line + contact.force_a * (contact.force_a.dot(contact.near - on_line) / square);
}

Wrench contactDamping(const Contact& contact, const ContactMotion& motion, const ContactOptions& options,
                      double h) {
  const double size = contact.force_a.norm();
  const Vector3d normal = contact.force_a / size;
  const double leaving = normal.dot(motion.relative.linear);
  const Vector3d slip = motion.relative.linear - leaving * normal;

  const double along = stable(options.dissipation * size, motion.normal_mobility, h);
  const double change = std::max(-along * leaving, -size);
  const double pressed = size + change;
  Wrench damping{change * normal, Vector3d::Zero()};

  const double max_friction = options.friction * pressed;
  const double speed = slip.norm();
  if (speed > 0.0) {
    const double friction =
        std::min(max_friction, stable(max_friction / options.creep, motion.slip_mobility, h) * speed);
    damping.force -= friction / speed * slip;
  }

  const double spin = motion.relative.angular.norm();
  if (spin > 0.0) {
    const double coefficient = options.dissipation * pressed * options.patch * options.patch;
    const double couple =
        std::min(pressed * options.patch, stable(coefficient, motion.turn_mobility, h) * spin);
    damping.torque = -couple / spin * motion.relative.angular;
  }
  return damping;
}

}  // namespace abstand::physics
