// The highest speed within the limits: closed forms, and the predicted contact at that speed.
#include "core/contact/allowed_speed.hpp"

#include <gtest/gtest.h>

#include "tests/core/contact/contact_table.hpp"

namespace abstand::contact {
namespace allowed_speed_test {

constexpr double kExact = 1e-12;  // relative: the same formula in another order
constexpr double kFast = 100.0;   // m/s, above every limit
// Relative: a speed that was searched for is below the true one by a part in 2^kPressureHalvings of where the
// search began.
constexpr double kBisected = 1.0 / 4096.0;

/// A flat face: every point as deep as the foremost one.
AreaAt flat(double area) {
  return [area](double x) {
    ContactArea a;
    a.area = area;
    a.volume = area * x;
    a.indentation = x;
    return a;
  };
}

/// A shallow cap of radius R: area 2 pi R x, volume pi R x^2.
AreaAt cap(double radius) {
  return [radius](double x) {
    ContactArea a;
    a.area = 2.0 * kPi * radius * x;
    a.volume = kPi * radius * x * x;
    a.indentation = x;
    return a;
  };
}

std::vector<const RegionLimits*> limitedRegions() {
  std::vector<const RegionLimits*> all;
  for (const RegionLimits& r : shippedLimits().regions)
    if (!r.excluded()) all.push_back(&r);
  return all;
}

TEST(AllowedSpeed, ForceAndEnergyMatchClosedForm) {
  for (const RegionLimits* region : limitedRegions())
    for (const double kg : {2.0, 15.0, kInfinity}) {
      const AllowedSpeed v = allowedSpeed({region}, {{kg}}, kFast, flat(1.0));
      EXPECT_EQ(v.kind, LimitKind::kForce) << region->name;
      const double mu = 1.0 / (1.0 / region->body_mass.value + 1.0 / kg), k = region->spring.value;
      const double most = region->transient.value * region->force.value;
      EXPECT_NEAR(v.speed, most / std::sqrt(mu * k), kExact * v.speed) << region->name;
      // Linear in force, quadratic in energy: both are at their limit there.
      const PredictedContact at = predictContact(*region, {v.speed, {kg}});
      EXPECT_NEAR(at.force, at.allowed_force, kExact * at.force);
      EXPECT_NEAR(at.energy, at.allowed_energy, 2.0 * kExact * at.energy);
      EXPECT_NEAR(predictContact(*region, {0.5 * v.speed, {kg}}).energy, 0.25 * at.allowed_energy,
                  2.0 * kExact * at.energy);
    }
}

TEST(AllowedSpeed, ClampedPartMatchesClosedForm) {
  for (const RegionLimits* region : limitedRegions())
    for (const double kg : {2.0, 15.0, kInfinity}) {
      const ContactPartner clamped{{kg}, ContactKind::kQuasiStatic};
      const AllowedSpeed v = allowedSpeed({region}, clamped, kFast, flat(1.0));
      const double k = region->spring.value, by_force = region->force.value / std::sqrt(kg * k);
      EXPECT_EQ(v.kind, LimitKind::kForce) << region->name;
      EXPECT_NEAR(v.speed, by_force, kExact * by_force) << region->name << ": a wall allows no speed";
      EXPECT_LT(v.speed, allowedSpeed({region}, {{kg}}, kFast, flat(1.0)).speed) << region->name;
      // The area that just carries the quasi-static force at the quasi-static pressure, and half of it.
      if (std::isinf(kg)) continue;
      const double full = region->force.value / region->pressure();
      EXPECT_EQ(allowedSpeed({region}, clamped, kFast, flat(1.01 * full)).kind, LimitKind::kForce);
      const AllowedSpeed half = allowedSpeed({region}, clamped, kFast, flat(0.5 * full));
      EXPECT_EQ(half.kind, LimitKind::kPressure) << region->name;
      EXPECT_NEAR(half.speed, 0.5 * by_force, kBisected * by_force) << region->name;
    }
}

TEST(AllowedSpeed, FlatFacePressureIsLinearInSpeed) {
  // Pressure is F / A: half the area that carries the largest force allows half of its speed.
  for (const RegionLimits* region : limitedRegions()) {
    const double by_force = predictContact(*region, {0.0, {15.0}}).allowed_speed;
    const double full = region->force.value / region->pressure();
    for (const double part : {0.1, 0.5, 0.9}) {
      const AllowedSpeed v = allowedSpeed({region}, {{15.0}}, kFast, flat(part * full));
      EXPECT_EQ(v.kind, LimitKind::kPressure) << region->name;
      EXPECT_LE(v.speed, part * by_force * (1.0 + kExact)) << region->name;
      EXPECT_GE(v.speed, (part - kBisected) * by_force * (1.0 - kExact)) << region->name;
    }
    EXPECT_EQ(allowedSpeed({region}, {{15.0}}, kFast, flat(1.01 * full)).kind, LimitKind::kForce);
  }
}

TEST(AllowedSpeed, CapPressureIsIndependentOfSpeed) {
  // Pressure is k / (pi R), whatever the speed.
  for (const RegionLimits* region : limitedRegions()) {
    const double most = region->transient.value * region->pressure();
    const double radius = region->spring.value / (kPi * most);
    const AllowedSpeed blunt = allowedSpeed({region}, {{15.0}}, kFast, cap(1.01 * radius));
    EXPECT_EQ(blunt.kind, LimitKind::kForce) << region->name;
    const AllowedSpeed pointed = allowedSpeed({region}, {{15.0}}, kFast, cap(0.99 * radius));
    EXPECT_EQ(pointed.kind, LimitKind::kPressure) << region->name;
    EXPECT_EQ(pointed.speed, 0.0) << region->name;
  }
}

TEST(AllowedSpeed, PressureNeedsFewEvaluations) {
  const RegionLimits* region = limitedRegions().front();
  const double by_force = predictContact(*region, {0.0, {15.0}}).allowed_speed;
  const double full = region->force.value / region->pressure();
  // Area grows with a power of the indentation: pressure rises with speed as its 1 - power.
  const auto evaluations = [&](double power, double share) {
    const double deepest = predictContact(*region, {by_force, {15.0}}).indentation;
    int count = 0;
    const AllowedSpeed v = allowedSpeed({region}, {{15.0}}, kFast, [&](double x) {
      ++count;
      return flat(std::max(share, 1e-9) * full * std::pow(x / deepest, power))(x);
    });
    const double expected = std::pow(share, 1.0 / (1.0 - power)) * by_force;
    EXPECT_LE(v.speed, expected * (1.0 + kExact)) << power << " " << share;
    EXPECT_GE(v.speed, expected - kBisected * by_force) << power << " " << share;
    return count;
  };
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9})
    for (const double power : {-4.0, -2.0, -0.5, 0.0, 0.5, 0.9})
      EXPECT_LE(evaluations(power, share), 4) << power << " " << share;
}

TEST(AllowedSpeed, NonPowerLawPressureNeedsFewExtraEvaluations) {
  const RegionLimits* region = limitedRegions().front();
  const double full = region->force.value / region->pressure();
  const double by_force = predictContact(*region, {0.0, {15.0}}).allowed_speed;
  const double deepest = predictContact(*region, {by_force, {15.0}}).indentation;
  for (const double edge : {0.01, 0.3, 0.77, 0.999}) {
    int count = 0;
    const AllowedSpeed v = allowedSpeed({region}, {{15.0}}, kFast, [&](double x) {
      ++count;
      return flat(full * (x < edge * deepest ? 10.0 : 0.01))(x);
    });
    EXPECT_LE(v.speed, edge * by_force * (1.0 + kExact)) << edge;
    EXPECT_GE(v.speed, (edge - kBisected) * by_force) << edge;
    EXPECT_LE(count, 1 + kPressureHalvings + kMoreThanHalvings) << edge;
  }
}

TEST(AllowedSpeed, IsCappedAtRequestedSpeedAndWorstRegion) {
  const auto all = limitedRegions();
  double least = kInfinity;
  for (const RegionLimits* region : all)
    least = std::min(least, predictContact(*region, {0.0, {15.0}}).allowed_speed);
  EXPECT_DOUBLE_EQ(allowedSpeed(all, {{15.0}}, kFast, flat(1.0)).speed, least);
  EXPECT_EQ(allowedSpeed(all, {{15.0}}, 0.5 * least, flat(1.0)).speed, 0.5 * least);
  EXPECT_EQ(allowedSpeed(all, {{15.0}}, 0.0, flat(1.0)).speed, 0.0);
}

TEST(AllowedSpeed, IsZeroForHeadAndUnknownArea) {
  std::vector<const RegionLimits*> mixed = limitedRegions();
  for (const RegionLimits& r : shippedLimits().regions)
    if (r.excluded()) mixed.push_back(&r);
  ASSERT_GT(mixed.size(), limitedRegions().size());
  for (const auto& v :
       {allowedSpeed(mixed, {{15.0}}, kFast, flat(1.0)), allowedSpeed({}, {}, kFast, flat(1.0)),
        allowedSpeed(limitedRegions(), {{15.0}}, kNaN, flat(1.0))}) {
    EXPECT_EQ(v.speed, 0.0);
    EXPECT_EQ(v.kind, LimitKind::kExcluded);
  }
  // Nothing is certain of the area: infinite pressure.
  EXPECT_EQ(allowedSpeed(limitedRegions(), {{15.0}}, kFast, [](double) { return ContactArea{}; }).speed, 0.0);
}

TEST(SpeedShare, IsRobotShareOfAllowedSpeed) {
  EXPECT_DOUBLE_EQ(speedShare(0.25, 0.5, 0.0), 0.5);
  EXPECT_DOUBLE_EQ(speedShare(0.25, 0.5, 0.1), 0.3);
  EXPECT_EQ(speedShare(0.25, 0.5, 0.25), 0.0);
  EXPECT_EQ(speedShare(0.25, 0.5, 0.9), 0.0) << "the person's speed alone is above";
  EXPECT_EQ(speedShare(0.25, 0.5, -0.3), 1.0) << "the person goes away";
  EXPECT_EQ(speedShare(0.0, 0.5, -0.1), 0.2);
  for (const double person : {0.1, 0.3, 0.7})
    for (const double robot : {0.1, 1.0 / 3.0, 0.9})
      EXPECT_EQ(speedShare(robot + person, robot, person), 1.0) << "exactly, however it is rounded";
  EXPECT_EQ(speedShare(0.25, 0.5, kNaN), 0.0);
  EXPECT_EQ(speedShare(kNaN, 0.5, 0.0), 0.0);
}

}  // namespace allowed_speed_test
}  // namespace abstand::contact
