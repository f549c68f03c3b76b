// Legs and arms at each other's place.
#include "tracking/tracker/crossed_limbs.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/tracker/seated_pose.hpp"
#include "tests/tracking/tracker/upright_person.hpp"
#include "tracking/tracker/limb_search.hpp"

namespace abstand::tracking {
namespace crossed_limbs_test {

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

/// Upright, each wrist `aside` (m) of its shoulder, outwards, and above it.
RigPlacement raisedAt(const BodyRig& rig, double aside, RigPose& pose) {
  RigPlacement X_WS = uprightAt(rig, Vector3d::Zero());
  for (std::size_t k = 0; k < 2; ++k) {
    const Limb& arm = kLimbs[k];
    const double side = k == 0 ? 1.0 : -1.0;
    const Vector3d shoulder = X_WS[index(rig[arm.upper].parent)] * rig[arm.upper].p_parent;
    reachFor(rig, arm, X_WS, shoulder + side * aside * Vector3d::UnitY() + 0.3 * Vector3d::UnitZ(), 0.0,
             pose);
  }
  place(rig, pose, X_WS);
  return X_WS;
}

TEST(CrossedArms, AreUncrossedWithTheWristsInTheSamePlaces) {
  const BodyRig rig = makeRig(humanmodel::makeHuman({}));
  EXPECT_FALSE(crossesArms(uprightAt(rig, Vector3d::Zero())));
  RigPose pose, crossing;
  EXPECT_FALSE(crossesArms(raisedAt(rig, 0.1, pose)));
  const RigPlacement crossed = raisedAt(rig, -0.45, crossing);
  ASSERT_TRUE(crossesArms(crossed));
  RigPlacement uncrossed;
  place(rig, uncrossedArms(rig, crossing, crossed), uncrossed);
  EXPECT_FALSE(crossesArms(uncrossed));
  const auto wrist = [](const RigPlacement& X_WS, RigSegment hand) {
    return Vector3d(X_WS[index(hand)].translation());
  };
  EXPECT_LE((wrist(uncrossed, RigSegment::kHandLeft) - wrist(crossed, RigSegment::kHandRight)).norm(),
            kSamePlace);
  EXPECT_LE((wrist(uncrossed, RigSegment::kHandRight) - wrist(crossed, RigSegment::kHandLeft)).norm(),
            kSamePlace);
}

}  // namespace crossed_limbs_test
}  // namespace abstand::tracking
