// Legs and arms at each other's place.
#include "tracking/tracker/crossed_limbs.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/tracker/seated_pose.hpp"
#include "tests/tracking/tracker/upright_person.hpp"
#include "tracking/tracker/raised_arms.hpp"

namespace abstand::tracking {
namespace crossed_limbs_test {

constexpr double kCrossing = 0.4;    // rad: each knee is 0.1 m beyond the other one
constexpr double kSamePlace = 0.01;  // m
constexpr double kRaised = 0.3;      // m, wrists above the shoulders

/// Whether the origins of two segments have exchanged their places.
void expectExchanged(const RigPlacement& before, const RigPlacement& after, RigSegment a, RigSegment b) {
  EXPECT_LE((after[index(a)].translation() - before[index(b)].translation()).norm(), kSamePlace);
  EXPECT_LE((after[index(b)].translation() - before[index(a)].translation()).norm(), kSamePlace);
}

TEST(CrossedLegs, AreNeitherThoseOfASeatedNorOfAStandingPerson) {
  const BodyRig rig = makeRig(humanmodel::makeHuman({}));
  EXPECT_FALSE(crossesLegs(seatedPlacement(rig)));
  EXPECT_FALSE(crossesLegs(uprightAt(rig, Vector3d::Zero())));
}

TEST(CrossedLegs, AreUncrossedWithTheAnklesInTheSamePlaces) {
  const BodyRig rig = makeRig(humanmodel::makeHuman({}));
  const RigPose pose = seatedPose(rig, kCrossing);
  RigPlacement crossed, uncrossed;
  place(rig, pose, crossed);
  ASSERT_TRUE(crossesLegs(crossed));
  place(rig, uncrossedLegs(rig, pose, crossed), uncrossed);
  EXPECT_FALSE(crossesLegs(uncrossed));
  expectExchanged(crossed, uncrossed, RigSegment::kFootLeft, RigSegment::kFootRight);
}

TEST(CrossedLegs, OnlyOneLegOverTheOtherIsLeft) {
  const BodyRig rig = makeRig(humanmodel::makeHuman({}));
  RigPose pose = seatedPose(rig);
  // The left thigh over the right one, the left ankle outside of the right knee: the right leg is straight
  // below.
  pose.R_PS[index(RigSegment::kThighLeft)] = seatedPose(rig, kCrossing).R_PS[index(RigSegment::kThighLeft)];
  RigPlacement X_WS;
  place(rig, pose, X_WS);
  EXPECT_FALSE(crossesLegs(X_WS));
}

TEST(CrossedArms, AreUncrossedWithTheWristsInTheSamePlaces) {
  const BodyRig rig = makeRig(humanmodel::makeHuman({}));
  EXPECT_FALSE(crossesArms(uprightAt(rig, Vector3d::Zero())));
  RigPose raised, crossing;
  RigPlacement X_WS, crossed, uncrossed;
  raiseArms(rig, kRaised, raised, 0.1);
  place(rig, raised, X_WS);
  EXPECT_FALSE(crossesArms(X_WS));
  raiseArms(rig, kRaised, crossing, -0.45);
  place(rig, crossing, crossed);
  ASSERT_TRUE(crossesArms(crossed));
  place(rig, uncrossedArms(rig, crossing, crossed), uncrossed);
  EXPECT_FALSE(crossesArms(uncrossed));
  expectExchanged(crossed, uncrossed, RigSegment::kHandLeft, RigSegment::kHandRight);
}

}  // namespace crossed_limbs_test
}  // namespace abstand::tracking
