// Peak force, energy and speeds of a contact: tables of speeds, numbers computed by hand, and what never
// counts as safe.
#include "core/contact/predicted_contact.hpp"

#include <gtest/gtest.h>

#include "core/math/transform.hpp"
#include "tests/core/contact/contact_table.hpp"

namespace abstand::contact {
namespace predicted_contact_test {

constexpr double kExact = 1e-12;   // relative: a few products and a root
constexpr double kColumn = 0.005;  // m/s: the columns of speeds have two decimals

PredictedContact at(std::string_view region, double speed, double mass,
                    ContactKind kind = ContactKind::kTransient) {
  return predictContact(shipped(region), {speed, {mass, RobotMassSource::kPosture}, kind});
}

TEST(PredictedContact, AllowedSpeedsMatchTable) {
  struct Row {
    const char* region;
    double speed[4];  // m/s, of robots with 5, 10, 20 and 40 kg
  };
  // v_max = F_max / sqrt(mu k) from A.2 and A.3 of ISO/TS 15066:2016, computed apart from this code.
  const Row rows[] = {
      {"neck", {1.36, 1.30, 1.26, 1.24}},          {"back_shoulders", {1.06, 0.79, 0.61, 0.50}},
      {"chest", {0.84, 0.63, 0.48, 0.40}},         {"abdomen", {1.04, 0.78, 0.60, 0.49}},
      {"pelvis", {1.08, 0.80, 0.62, 0.51}},        {"upper_arm_elbow", {1.26, 1.14, 1.07, 1.04}},
      {"forearm_wrist", {1.34, 1.24, 1.19, 1.16}}, {"hand_fingers", {1.40, 1.36, 1.34, 1.33}},
      {"thigh_knee", {0.91, 0.66, 0.50, 0.39}},    {"lower_leg", {0.49, 0.36, 0.27, 0.21}}};
  const double masses[] = {5, 10, 20, 40};
  for (const Row& row : rows)
    for (int i = 0; i < 4; ++i) {
      const PredictedContact c = at(row.region, row.speed[i], masses[i]);
      EXPECT_NEAR(c.allowed_speed, row.speed[i], kColumn + 1e-9) << row.region << " " << masses[i];
      // At that speed the contact is at its limit.
      EXPECT_NEAR(at(row.region, c.allowed_speed, masses[i]).share, 1.0, kExact) << row.region;
    }
}

TEST(PredictedContact, HandMatchesManualCalculation) {
  // m_H 0.6 kg, m_R 5.4 kg: mu = 0.54 kg. v = 1 m/s, K = 75 N/mm: E = 0.27 J, F = sqrt(40500) N, x = F / K.
  const PredictedContact c = at("hand_fingers", 1.0, 5.4);
  EXPECT_NEAR(c.reduced_mass, 0.54, kExact);
  EXPECT_NEAR(c.energy, 0.27, kExact);
  EXPECT_NEAR(c.force, 201.24611797498108, 1e-9);
  EXPECT_NEAR(c.indentation, 201.24611797498108 / 75e3, kExact);
  // 2 x 140 N; 280^2 / 150000 J.
  EXPECT_NEAR(c.allowed_force, 280.0, kExact);
  EXPECT_NEAR(c.allowed_energy, 0.5226666666666667, kExact);
  EXPECT_NEAR(c.share, 201.24611797498108 / 280.0, kExact);
}

TEST(PredictedContact, ChestMatchesManualCalculation) {
  // Two equal masses of 40 kg: mu = 20 kg. v = 0.5 m/s, K = 25 N/mm: E = 2.5 J of 1.568, F = 0.5 sqrt(500000)
  // N.
  const PredictedContact c = at("chest", 0.5, 40.0);
  EXPECT_NEAR(c.energy, 2.5, kExact);
  EXPECT_NEAR(c.force, 353.5533905932738, 1e-9);
  EXPECT_NEAR(c.allowed_energy, 1.568, kExact);
  EXPECT_NEAR(c.share, 353.5533905932738 / 280.0, kExact);
}

TEST(PredictedContact, SharesOfForceSpeedAndEnergyAgree) {
  for (const RegionLimits& r : shippedLimits().regions) {
    if (r.excluded()) continue;
    const PredictedContact c = predictContact(r, {0.7, {12.0}});
    EXPECT_NEAR(c.share, 0.7 / c.allowed_speed, kExact * c.share) << r.name;
    EXPECT_NEAR(c.share, std::sqrt(c.energy / c.allowed_energy), kExact * c.share) << r.name;
    EXPECT_NEAR(c.energy, 0.5 * c.force * c.indentation, kExact * c.energy) << r.name;
  }
}

TEST(PredictedContact, ClampedPartHasRobotMassAndHalfLimit) {
  const PredictedContact clamped = at("chest", 0.2, 10.0, ContactKind::kQuasiStatic);
  EXPECT_NEAR(clamped.reduced_mass, 10.0, kExact);
  EXPECT_NEAR(clamped.allowed_force, 140.0, kExact);
  EXPECT_NEAR(clamped.force, 0.2 * std::sqrt(10.0 * 25e3), 1e-9);
  EXPECT_GT(clamped.share, 2.0 * at("chest", 0.2, 10.0).share);
}

TEST(PredictedContact, ExcludesHeadAtAnySpeed) {
  for (const double speed : {0.0, 1e-9, 0.1, -1.0, kNaN}) {
    const PredictedContact c = at("face", speed, 5.0);
    EXPECT_TRUE(c.excluded);
    EXPECT_EQ(c.share, kInfinity) << speed;
    EXPECT_EQ(c.allowed_speed, 0.0);
    EXPECT_EQ(c.allowed_force, 0.0);
  }
}

TEST(PredictedContact, UnknownValuesAreNeverSafe) {
  EXPECT_EQ(at("chest", kNaN, 10.0).share, kInfinity);
  // A robot of unknown mass is a wall: mu = m_H.
  const PredictedContact wall = at("chest", 0.3, kInfinity);
  EXPECT_NEAR(wall.reduced_mass, 40.0, kExact);
  for (const double mass : {kNaN, 0.0, -3.0}) EXPECT_EQ(at("chest", 0.3, mass).share, wall.share) << mass;
  EXPECT_EQ(at("chest", 0.3, kInfinity, ContactKind::kQuasiStatic).share, kInfinity);
  EXPECT_EQ(at("chest", 0.3, kInfinity, ContactKind::kQuasiStatic).allowed_speed, 0.0);
  // What stands or goes away makes no impact, even of a wall.
  EXPECT_EQ(at("chest", 0.0, kInfinity, ContactKind::kQuasiStatic).share, 0.0);
  EXPECT_EQ(at("chest", -1.0, 10.0).force, 0.0);
}

TEST(PredictedContact, EstimatesRobotMass) {
  const RobotMass m = estimatedRobotMass(16.0, 2.0);
  EXPECT_EQ(m.kg, 10.0);
  EXPECT_EQ(sourceText(m.source), "m_R = M/2 + m_L (ISO/TS 15066:2016)");
  EXPECT_EQ(sourceText(RobotMassSource::kPosture), "effective mass of the posture");
}

TEST(PredictedContact, PartUsesWorstRegion) {
  // Of the torso, the chest allows the least force for its spring: v_max 0.63 m/s at 10 kg.
  const RegionContact torso = worstContact(shippedLimits().regionsOf("torso"), {0.5, {10.0}});
  ASSERT_TRUE(torso.region);
  EXPECT_EQ(torso.region->name, "chest");
  for (const RegionLimits* r : shippedLimits().regionsOf("torso"))
    EXPECT_LE(predictContact(*r, {0.5, {10.0}}).share, torso.contact.share) << r->name;
  EXPECT_TRUE(worstContact(shippedLimits().regionsOf("head"), {0.5, {10.0}}).contact.excluded);
  EXPECT_EQ(worstContact(shippedLimits().regionsOf("foot_left"), {0.5, {10.0}}).region->name, "lower_leg");
  EXPECT_EQ(worstContact({}, {0.5, {10.0}}).region, nullptr);
}

}  // namespace predicted_contact_test
}  // namespace abstand::contact
