// The repulsive potential: closed forms, and energy that never grows.
#include "core/control/repulsion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "core/math/random.hpp"

namespace abstand::control {
namespace repulsion_test {

constexpr double kExact = 1e-12;
// Central differences over 1e-6 m of a cubic.
constexpr double kStep = 1e-6, kSlope = 1e-4;

const RepulsionOptions kOptions{.range = 0.1, .force = 60.0, .damping = 0.7};

TEST(Repulsion, MatchesCubicPotential) {
  const Repulsion law(kOptions);
  EXPECT_NEAR(law.potential(0.0), 60.0 * 0.1 / 3.0, kExact);
  EXPECT_NEAR(law.force(0.0), 60.0, kExact);
  EXPECT_NEAR(law.force(0.05), 15.0, kExact);
  EXPECT_NEAR(law.stiffness(0.05), 600.0, 1e-9);
  EXPECT_EQ(law.force(0.1), 0.0);
  EXPECT_EQ(law.force(5.0), 0.0);
  EXPECT_NEAR(law.force(-0.2), 60.0, kExact) << "inside, it pushes no harder";
  for (double d = -0.05; d < 0.12; d += 0.0037) {
    EXPECT_NEAR(-(law.potential(d + kStep) - law.potential(d - kStep)) / (2 * kStep), law.force(d), kSlope);
    if (d > 0.0) {
      EXPECT_NEAR(-(law.force(d + kStep) - law.force(d - kStep)) / (2 * kStep), law.stiffness(d), 1e-2);
    }
  }
}

TEST(Repulsion, DampsByEffectiveMass) {
  const Repulsion law(kOptions);
  // D = 2 * 0.7 * sqrt(600 * m).
  EXPECT_NEAR(law.update(0.05, -0.1, -0.1, 6.0).force, 15.0 + 0.1 * 1.4 * 60.0, 1e-9);
  EXPECT_NEAR(law.update(0.05, -0.1, -0.1, 1.5).force, 15.0 + 0.1 * 1.4 * 30.0, 1e-9);
  EXPECT_EQ(law.update(0.05, 5.0, 5.0, 6.0).force, 0.0) << "it never pulls back";
  EXPECT_EQ(law.update(0.2, -5.0, -5.0, 6.0).force, 0.0);
  EXPECT_NEAR(law.update(kNaN, 0.0, 0.0, 6.0).force, 60.0, kExact) << "an unknown distance is none";
}

TEST(Repulsion, RequestsStopOnExcessEnergy) {
  RepulsionOptions o = kOptions;
  o.stop_distance = 0.02;
  o.stop_share = 0.5;
  const Repulsion law(o);
  // Between 0.08 and 0.02 m: 60 / 0.03 (0.08^3 - 0.02^3) = 1.008 J, of which half counts.
  const double speed = std::sqrt(2.0 * 0.504 / 5.0);
  const RepulsionResult below = law.update(0.08, -0.999 * speed, -0.999 * speed, 5.0);
  EXPECT_NEAR(below.available, 1.008, 1e-9);
  EXPECT_FALSE(below.stop);
  EXPECT_TRUE(law.update(0.08, -1.001 * speed, -1.001 * speed, 5.0).stop);
  EXPECT_FALSE(law.update(0.08, 9.0, 9.0, 5.0).stop) << "it goes away";
  EXPECT_FALSE(law.update(0.101, -9.0, -9.0, 5.0).stop) << "out of range";
  EXPECT_TRUE(law.update(0.01, -0.01, -0.01, 5.0).stop) << "nothing is left";
  EXPECT_FALSE(law.update(0.08, -9.0, 0.0, 5.0).stop) << "a fist comes; brakes would not help";
}

/// A point mass against a wall at 0, one joint; the wall may move. Semi-implicit Euler at 1 kHz.
struct PointMass {
  double mass, x, v;
  double energy(const Repulsion& law) const { return 0.5 * mass * v * v + law.potential(x); }
  RepulsionResult step(const Repulsion& law, double dt) {
    const RepulsionResult r = law.update(x, v, v, mass);
    v += dt * r.force / mass;
    x += dt * v;
    return r;
  }
};

TEST(Repulsion, EnergyNeverGrows) {
  int bounced = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(2, seed);
    const Repulsion law({.range = random.between(0.02, 0.3),
                         .force = random.between(5.0, 200.0),
                         .damping = random.between(0.2, 1.5)});
    const double mass = random.between(0.5, 20.0);
    // As fast as the potential can stop.
    PointMass p{mass, law.options().range + 0.001, 0.0};
    p.v = -random.between(0.1, 0.99) * std::sqrt(2.0 * law.potential(0.0) / mass);
    double energy = p.energy(law);
    const double first = energy;
    // sqrt(K / m) dt stays below 4 zeta, for which each step of the scheme loses energy.
    ASSERT_LT(std::sqrt(law.stiffness(0.0) / mass) * 1e-3, 4.0 * law.options().damping);
    for (int i = 0; i < 5000; ++i) {
      // The step that enters the range is made without a force: it gains what lies within it.
      const bool outside = p.x >= law.options().range;
      p.step(law, 1e-3);
      const double now = p.energy(law);
      const double entry = outside && p.x < law.options().range ? law.potential(p.x) : 0.0;
      ASSERT_LE(now, energy + entry + kExact * first) << i;
      ASSERT_GT(p.x, 0.0);
      energy = now;
    }
    EXPECT_LT(energy, 0.98 * first);
    bounced += p.v > 0.0;
  }
  EXPECT_GT(bounced, 100);
}

TEST(Repulsion, ConservesEnergyWithoutDamping) {
  const Repulsion law({.range = 0.1, .force = 60.0, .damping = 0.0});
  PointMass p{5.0, 0.1001, -0.5};
  const double first = p.energy(law);
  double nearest = 1.0;
  for (int i = 0; i < 100000 && (p.v <= 0.0 || p.x < 0.1); ++i) {
    p.step(law, 1e-5);
    nearest = std::min(nearest, p.x);
  }
  // Of a symplectic scheme with steps of 10 us.
  EXPECT_NEAR(p.energy(law), first, 1e-4 * first);
  // It turned where the potential was all: F e^3 / (3 d0^2) = m v^2 / 2.
  EXPECT_NEAR(nearest, 0.1 - std::cbrt(0.5 * 5.0 * 0.25 * 3.0 * 0.01 / 60.0), 1e-4);
}

TEST(Repulsion, StopComesInTimeForBrakes) {
  // Too fast for the potential; from the moment of the stop on, brakes that can take 100 N.
  const Repulsion law({.range = 0.2, .force = 60.0, .damping = 0.7, .stop_share = 0.5});
  PointMass p{5.0, 0.3, -1.3};
  bool stopped = false;
  for (int i = 0; i < 2000; ++i) {
    if (stopped) {
      p.v = std::min(0.0, p.v + 1e-3 * 100.0 / p.mass);
      p.x += 1e-3 * p.v;
    } else {
      stopped = p.step(law, 1e-3).stop;
    }
  }
  EXPECT_TRUE(stopped);
  EXPECT_EQ(p.v, 0.0);
  // 5 kg at 1.3 m/s need 42 mm at 100 N.
  EXPECT_GT(p.x, 0.2 - 0.05);
}

TEST(Repulsion, RejectsBadOptions) {
  EXPECT_THROW(Repulsion({.range = 0.0}), UsageError);
  EXPECT_THROW(Repulsion({.damping = kNaN}), UsageError);
  EXPECT_THROW(Repulsion({.range = 0.1, .stop_distance = 0.1}), UsageError);
}

TEST(Repulsion, StandingRobotRequestsNoStop) {
  // Inside, the potential has nothing left to take; roundings of a rate are no approach.
  const Repulsion r(RepulsionOptions{.range = 0.1, .force = 50.0});
  EXPECT_FALSE(r.update(-0.01, -1e-5, -1e-5, 2.0).stop);
  EXPECT_TRUE(r.update(-0.01, -0.01, -0.01, 2.0).stop);
}

}  // namespace repulsion_test
}  // namespace abstand::control
