// Legs at each other's place.
#include "tracking/tracker/crossed_legs.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/tracker/seated_pose.hpp"
#include "tests/tracking/tracker/upright_person.hpp"

namespace abstand::tracking {
namespace crossed_legs_test {

constexpr double kCrossing = 0.4;    // rad: each knee is 0.1 m beyond the other one
constexpr double kSamePlace = 0.01;  // m

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
  const auto ankle = [](const RigPlacement& X_WS, RigSegment foot) {
    return Vector3d(X_WS[index(foot)].translation());
  };
  EXPECT_LE((ankle(uncrossed, RigSegment::kFootLeft) - ankle(crossed, RigSegment::kFootRight)).norm(),
            kSamePlace);
  EXPECT_LE((ankle(uncrossed, RigSegment::kFootRight) - ankle(crossed, RigSegment::kFootLeft)).norm(),
            kSamePlace);
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

}  // namespace crossed_legs_test
}  // namespace abstand::tracking
