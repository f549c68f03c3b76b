// Admittance: steady states, limits, and stability for any step.
#include "core/control/admittance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "core/math/random.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::control {
namespace admittance_test {

constexpr double kDt = 1e-3;

void run(Admittance& a, const std::vector<double>& efforts, int steps, double dt = kDt) {
  for (int i = 0; i < steps; ++i) a.update(efforts, dt);
}

TEST(Admittance, ReachesSteadyState) {
  // 4 N m on 20 N m/rad: 0.2 rad.
  Admittance a({.inertia = {0.5}, .damping = {8.0}, .stiffness = {20.0}}, 1);
  run(a, {4.0}, 10000);
  EXPECT_NEAR(a.offset()[0], 0.2, 1e-6);
  EXPECT_NEAR(a.velocity()[0], 0.0, 1e-6);
  // And goes back when nobody pushes.
  run(a, {0.0}, 10000);
  EXPECT_NEAR(a.offset()[0], 0.0, 1e-6);
}

TEST(Admittance, DriftsWithoutSpring) {
  // 4 N m on 8 N m s/rad: 0.5 rad/s.
  Admittance a({.inertia = {0.5}, .damping = {8.0}, .stiffness = {0.0}, .offset = {100.0}}, 1);
  run(a, {4.0}, 2000);
  EXPECT_NEAR(a.velocity()[0], 0.5, 1e-6);
  const double x = a.offset()[0];
  run(a, {4.0}, 1000);
  EXPECT_NEAR(a.offset()[0] - x, 0.5, 1e-6);
}

TEST(Admittance, FollowsTheDifferentialEquation) {
  // Underdamped: x = tau/k (1 - e^(-s t) (cos w t + s/w sin w t)), s = b / 2m, w^2 = k/m - s^2.
  const double m = 1.0, b = 2.0, k = 50.0, tau = 5.0, s = b / (2 * m), w = std::sqrt(k / m - s * s);
  Admittance a({.inertia = {m}, .damping = {b}, .stiffness = {k}}, 1);
  for (int i = 1; i <= 20000; ++i) {
    a.update(std::vector{tau}, 1e-4);
    const double t = 1e-4 * i;
    const double x = tau / k * (1.0 - std::exp(-s * t) * (std::cos(w * t) + s / w * std::sin(w * t)));
    // First order: some dt * velocity * w.
    ASSERT_NEAR(a.offset()[0], x, 5e-4) << t;
  }
}

TEST(Admittance, KeepsLimits) {
  Admittance a({.inertia = {0.1, 0.1},
                .damping = {1.0},
                .stiffness = {5.0},
                .velocity = {0.3, 1.0},
                .offset = {0.5, 0.2}},
               2);
  double fastest[2] = {};
  for (int i = 0; i < 5000; ++i) {
    a.update(std::vector{100.0, -100.0}, kDt);
    for (int k = 0; k < 2; ++k) fastest[k] = std::max(fastest[k], std::abs(a.velocity()[k]));
  }
  EXPECT_EQ(fastest[0], 0.3);
  EXPECT_EQ(fastest[1], 1.0);
  EXPECT_EQ(a.offset()[0], 0.5);
  EXPECT_EQ(a.offset()[1], -0.2);
  EXPECT_EQ(a.velocity()[1], 0.0) << "at the limit it stands";
  a.hold();
  EXPECT_EQ(a.velocity()[0], 0.0);
  EXPECT_EQ(a.offset()[0], 0.5);
  a.reset();
  EXPECT_EQ(a.offset()[0], 0.0);
}

TEST(Admittance, IsStableForEveryStep) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(6, seed);
    const double inf = 1e3;
    const config::JointNumbers inertia{std::pow(10.0, random.between(-4, 2))},
        damping{random.chance(0.2) ? 0.0 : std::pow(10.0, random.between(-3, 3))},
        stiffness{std::pow(10.0, random.between(-2, 5))};
    Admittance a({inertia, damping, stiffness, {inf}, {inf}}, 1);
    const double dt = std::pow(10.0, random.between(-4, 1));
    a.update(std::vector{1.0}, dt);
    const auto energy = [&] {
      return 0.5 * inertia[0] * a.velocity()[0] * a.velocity()[0] +
             0.5 * stiffness[0] * a.offset()[0] * a.offset()[0];
    };
    double before = energy();
    for (int i = 0; i < 300; ++i) {
      a.update(std::vector{0.0}, dt);
      ASSERT_LE(energy(), before * (1.0 + 1e-9)) << seed << " " << i;
      before = energy();
    }
  }
}

TEST(Admittance, IgnoresNonFiniteEffortAndTime) {
  Admittance a({}, 1);
  a.update(std::vector{kNaN}, kDt);
  EXPECT_EQ(a.velocity()[0], 0.0);
  a.update(std::vector{5.0}, 0.0);
  a.update(std::vector{5.0}, kNaN);
  EXPECT_EQ(a.offset()[0], 0.0);
}

TEST(Admittance, AllocatesNothingAndRejectsBadOptions) {
  Admittance a({}, 7);
  const std::vector<double> efforts(7, 1.0);
  const testing::NoAlloc guard;
  for (int i = 0; i < 100; ++i) a.update(efforts, kDt);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_THROW(Admittance({.inertia = {0.0}}, 1), UsageError);
  EXPECT_THROW(Admittance({.damping = {1.0, 2.0}}, 3), UsageError);
}

}  // namespace admittance_test
}  // namespace abstand::control
