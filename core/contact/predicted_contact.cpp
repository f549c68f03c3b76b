#include "core/contact/predicted_contact.hpp"

#include <cmath>

#include "core/math/transform.hpp"

namespace abstand::contact {
namespace {

double reducedMass(double body, const ContactMotion& motion) {
  const bool known = motion.robot.kg > 0.0;
  const double robot = known ? motion.robot.kg : kInfinity;
  if (motion.kind == ContactKind::kQuasiStatic) return robot;
  return 1.0 / (1.0 / body + 1.0 / robot);
}

bool isWorse(const PredictedContact& a, const PredictedContact& b) {
  return a.share > b.share || (a.share == b.share && a.allowed_speed < b.allowed_speed);
}

}  // namespace

std::string_view kindText(ContactKind kind) {
  return kind == ContactKind::kTransient ? "transient" : "quasi-static";
}

std::string_view sourceText(RobotMassSource source) {
  return source == RobotMassSource::kPosture ? "effective mass of the posture"
                                             : "m_R = M/2 + m_L (ISO/TS 15066:2016)";
}

RobotMass estimatedRobotMass(double moving_mass, double load) {
  return {0.5 * moving_mass + load, RobotMassSource::kHalfMovingMass};
}

PredictedContact predictContact(const RegionLimits& region, const ContactMotion& motion) {
  const double k = region.spring.value;
  PredictedContact c;
  c.excluded = region.excluded();
  c.reduced_mass = reducedMass(region.body_mass.value, motion);
  const double speed = std::isnan(motion.speed) ? kInfinity : motion.speed;
  if (speed > 0.0) {
    c.energy = 0.5 * c.reduced_mass * speed * speed;
    c.force = speed * std::sqrt(c.reduced_mass * k);
    c.indentation = c.force / k;
  }
  if (!c.excluded) {
    const double factor = motion.kind == ContactKind::kTransient ? region.transient.value : 1.0;
    c.allowed_force = factor * region.force.value;
    c.allowed_energy = c.allowed_force * c.allowed_force / (2.0 * k);
    c.allowed_speed = c.allowed_force / std::sqrt(c.reduced_mass * k);
  }
  c.share = c.excluded ? kInfinity : c.force / c.allowed_force;
  return c;
}

RegionContact worstContact(const std::vector<const RegionLimits*>& regions, const ContactMotion& motion) {
  RegionContact worst;
  for (const RegionLimits* region : regions) {
    const PredictedContact contact = predictContact(*region, motion);
    if (!worst.region || isWorse(contact, worst.contact)) worst = {region, contact};
  }
  return worst;
}

}  // namespace abstand::contact
