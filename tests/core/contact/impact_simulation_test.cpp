// Predicted peak force and energy against two masses on sliders with a spring between them, moved by ODE.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include "core/contact/predicted_contact.hpp"
#include "tests/core/contact/contact_table.hpp"

namespace abstand::contact {
namespace impact_simulation_test {

// The agreement that is asked for. With 1000 steps a period the integration is wrong by far less.
constexpr double kAgreement = 0.02;
constexpr double kStepsPerPeriod = 1000.0;

struct SimulatedPeak {
  double force{0.0}, energy{0.0};  ///< N, and J in the spring
  double momentum{0.0};            ///< kg m/s, at the end
};

/// A body on a slider along x.
dBodyID slidingBody(dWorldID world, double mass, double x, double speed) {
  const dBodyID body = dBodyCreate(world);
  dMass m;
  dMassSetBoxTotal(&m, mass, 0.1, 0.1, 0.1);
  dBodySetMass(body, &m);
  dBodySetPosition(body, x, 0, 0);
  dBodySetLinearVel(body, speed, 0, 0);
  const dJointID slider = dJointCreateSlider(world, nullptr);
  dJointAttach(slider, body, nullptr);
  dJointSetSliderAxis(slider, 1, 0, 0);
  return body;
}

/// The robot comes at `speed`; the body part stands, is free to go, and pushes back with `spring` while they
/// overlap. Until they part.
SimulatedPeak simulate(double robot, double part, double spring, double speed) {
  dInitODE2(0);
  const dWorldID world = dWorldCreate();
  const dBodyID r = slidingBody(world, robot, 0.0, speed), h = slidingBody(world, part, 1.0, 0.0);
  const double period = 2.0 * M_PI * std::sqrt(robot * part / (robot + part) / spring);
  SimulatedPeak peak;
  for (int i = 0; i < static_cast<int>(kStepsPerPeriod); ++i) {
    const double overlap = dBodyGetPosition(r)[0] + 1.0 - dBodyGetPosition(h)[0];
    const double force = std::max(0.0, spring * overlap);
    dBodyAddForce(r, -force, 0, 0);
    dBodyAddForce(h, force, 0, 0);
    peak.force = std::max(peak.force, force);
    peak.energy = std::max(peak.energy, 0.5 * force * force / spring);
    dWorldStep(world, period / kStepsPerPeriod);
  }
  peak.momentum = robot * dBodyGetLinearVel(r)[0] + part * dBodyGetLinearVel(h)[0];
  dWorldDestroy(world);
  dCloseODE();
  return peak;
}

TEST(ImpactSimulation, PeakForceAndEnergyMatchPrediction) {
  for (const RegionLimits& region : shippedLimits().regions)
    for (const double mass : {2.0, 10.0, 60.0})
      for (const double speed : {0.1, 1.0}) {
        SCOPED_TRACE(region.name + ", " + std::to_string(mass) + " kg, " + std::to_string(speed) + " m/s");
        const SimulatedPeak peak = simulate(mass, region.body_mass.value, region.spring.value, speed);
        const PredictedContact c = predictContact(region, {speed, {mass}});
        EXPECT_NEAR(peak.momentum, mass * speed, 1e-9 * mass * speed);
        EXPECT_NEAR(c.force, peak.force, kAgreement * peak.force);
        EXPECT_NEAR(c.energy, peak.energy, kAgreement * peak.energy);
        EXPECT_NEAR(c.indentation, peak.force / region.spring.value, kAgreement * c.indentation);
      }
}

TEST(ImpactSimulation, ClampedPartHasRobotMassAlone) {
  // A body part that cannot go away: nearly all of the mass stands behind it.
  const RegionLimits& chest = shipped("chest");
  const SimulatedPeak peak = simulate(10.0, 1e6, chest.spring.value, 0.3);
  const PredictedContact c = predictContact(chest, {0.3, {10.0}, ContactKind::kQuasiStatic});
  EXPECT_NEAR(c.force, peak.force, kAgreement * peak.force);
  EXPECT_NEAR(c.energy, peak.energy, kAgreement * peak.energy);
}

}  // namespace impact_simulation_test
}  // namespace abstand::contact
