// Speed and separation, and predicted contact, against closed forms.
#include "ui/model/separation_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace abstand::ui {
namespace separation_rows_test {

constexpr double kExact = 1e-12;

/// A hand at the origin and a link at x = 1 m, both as points, each with a speed along x.
struct SeparationRowsTest : ::testing::Test {
  SeparationRowsTest() {
    outline.objects = {{"anna/hand_left", "anna", true, true}, {"arm/link1", "arm", false, true}};
    outline.pairs = {{0, 1}};
    outline.robots.push_back({"arm", "", "", Transform::Identity(), 0, 0});
    snapshot.objects.resize(2);
    snapshot.pairs.resize(1);
    snapshot.objects[1].p_WCom = Vector3d::UnitX();
    snapshot.pairs[0].result.distance = 1.0;
    snapshot.pairs[0].result.bound = 0.01;
    snapshot.pairs[0].result.witness_a = Vector3d::Zero();
    snapshot.pairs[0].result.witness_b = Vector3d::UnitX();
    contact::RegionLimits hand;
    hand.name = "hand";
    hand.parts = {"hand_left"};
    hand.force = {140.0, "table 2", "by hand"};
    hand.transient = {2.0, "table 2", ""};
    hand.spring = {75e3, "table 3", ""};
    hand.body_mass = {0.6, "table 3", ""};
    hand.pressures = {{"palm", {1.9e6, "table 2", ""}}};
    limits.regions = {hand};
  }
  SeparationRow row() const { return separationRows(outline, snapshot, settings, &limits).at(0); }

  view::SceneOutline outline;
  view::SceneSnapshot snapshot;
  SeparationSettings settings;
  contact::ContactLimits limits;
};

TEST_F(SeparationRowsTest, TheTermsAreThoseOfTheStandard) {
  snapshot.objects[1].velocity.linear = Vector3d(-0.5, 0.0, 0.0);
  settings.options.intrusion = 0.05;
  const SeparationRow now = row();
  EXPECT_EQ(now.part, 0);
  EXPECT_EQ(now.link, 1);
  EXPECT_NEAR(now.robot_speed, 0.5, kExact);
  EXPECT_NEAR(now.clearance, 0.99, kExact);
  EXPECT_NEAR(now.needed.person, 1.6 * 0.4, kExact);
  EXPECT_NEAR(now.needed.reaction, 0.5 * 0.1, kExact);
  EXPECT_NEAR(now.needed.stopping, 0.5 * 0.3 / 2.0, kExact);
  EXPECT_NEAR(now.needed.constant, 0.05, kExact);
  EXPECT_EQ(now.state, SeparationState::kKept) << "0.815 m of 0.99 m";
  snapshot.pairs[0].result.distance = 0.8;
  EXPECT_EQ(row().state, SeparationState::kNotKept) << "0.79 m is less";
  snapshot.objects[1].velocity.linear *= -1.0;
  snapshot.pairs[0].result.distance = 0.6;
  EXPECT_EQ(row().state, SeparationState::kNoApproach);
}

TEST_F(SeparationRowsTest, ATurningLinkCountsAtItsNearestPoint) {
  snapshot.objects[1].p_WCom = Vector3d(1.0, 2.0, 0.0);
  snapshot.objects[1].velocity.angular = Vector3d(0.0, 0.0, -0.25);
  // The nearest point is 2 m below the centre: w x r = (-0.25 z) x (-2 y) = -0.5 x.
  EXPECT_NEAR(row().robot_speed, 0.5, kExact);
}

TEST_F(SeparationRowsTest, WhatIsNotKnownIsNeverKept) {
  snapshot.objects[0].pose_uncertainty = kInfinity;
  EXPECT_EQ(row().state, SeparationState::kUnknown);
  snapshot.objects[0].pose_uncertainty = 0.0;
  EXPECT_EQ(row().state, SeparationState::kKept);
  for (const scene::PoseState lost : {scene::PoseState::kStale, scene::PoseState::kRejected}) {
    snapshot.objects[0].pose_state = lost;
    EXPECT_EQ(row().state, SeparationState::kUnknown);
    EXPECT_EQ(row().contact_state, ContactState::kUnknown);
  }
  snapshot.objects[0].pose_state = scene::PoseState::kFresh;
  snapshot.pairs[0].paused = true;
  EXPECT_EQ(row().state, SeparationState::kUnknown);
  outline.pairs.clear();
  EXPECT_EQ(row().pair, -1);
  EXPECT_EQ(row().state, SeparationState::kUnknown);
}

TEST_F(SeparationRowsTest, TheWorstLinkCounts) {
  outline.objects.push_back({"arm/link2", "arm", false, true});
  outline.pairs.emplace_back(0, 2);
  snapshot.objects.resize(3);
  snapshot.pairs.push_back(snapshot.pairs[0]);
  snapshot.pairs[1].result.distance = 0.4;
  EXPECT_EQ(row().link, 2);
  snapshot.pairs[0].paused = true;
  EXPECT_EQ(row().link, 1) << "what is not known is worse than anything that is";
}

TEST_F(SeparationRowsTest, ContactsAreJudgedByTheTable) {
  settings.robot_mass = 0.6;
  // v sqrt(mu k) with mu = 0.3 kg: 150 N at 1 m/s, of 280 N.
  const double force = std::sqrt(0.3 * 75e3);
  snapshot.objects[1].velocity.linear = Vector3d(-0.6, 0.0, 0.0);
  snapshot.objects[0].velocity.linear = Vector3d(0.4, 0.0, 0.0);
  EXPECT_NEAR(row().contact.contact.force, force, 1e-9 * force);
  EXPECT_NEAR(row().contact.contact.allowed_force, 280.0, 1e-9);
  EXPECT_EQ(row().contact_state, ContactState::kBelow);
  settings.clamped = true;
  EXPECT_NEAR(row().contact.contact.allowed_force, 140.0, 1e-9);
  EXPECT_EQ(row().contact_state, ContactState::kAbove);
  settings.clamped = false;
  settings.robot_mass = 0.0;
  EXPECT_NEAR(row().contact.contact.force, std::sqrt(0.6 * 75e3), 1e-6) << "immovable where it is not known";
  snapshot.objects[0].velocity.linear = Vector3d(-1.0, 0.0, 0.0);
  EXPECT_EQ(row().contact_state, ContactState::kNoImpact);
  EXPECT_EQ(separationRows(outline, snapshot, settings, nullptr).at(0).contact_state, ContactState::kUnknown);
}

TEST_F(SeparationRowsTest, TheTipNamesTheSourceOfEachNumber) {
  snapshot.objects[1].velocity.linear = Vector3d(-0.5, 0.0, 0.0);
  const QString tip = separationTip(outline, row(), settings);
  for (const char* part : {"anna/hand_left – arm/link1", "ISO 13855:2010", "ISO/TS 15066:2016, 5.5.4",
                           "limit of the force 140 N [table 2]", "to be checked: by hand",
                           "stiffness 75 N/mm [table 3]", "counts as immovable"})
    EXPECT_TRUE(tip.contains(QString::fromUtf8(part))) << part << " in " << tip.toStdString();
}

TEST_F(SeparationRowsTest, SettingsAreComparedNumberByNumber) {
  SeparationSettings other;
  EXPECT_EQ(settings, other);
  other.options.robot_error = 0.001;
  EXPECT_FALSE(settings == other);
}

}  // namespace separation_rows_test
}  // namespace abstand::ui
