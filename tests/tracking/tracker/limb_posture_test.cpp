// Raised legs and arms, and where they would be otherwise.
#include <gtest/gtest.h>

#include "tests/tracking/tracker/seated_pose.hpp"
#include "tests/tracking/tracker/upright_person.hpp"
#include "tracking/tracker/leg_posture.hpp"
#include "tracking/tracker/limb_search.hpp"
#include "tracking/tracker/raised_arms.hpp"

namespace abstand::tracking {
namespace limb_posture_test {

constexpr std::size_t kRightArm = 1, kLeftLeg = 2;  // of kLimbs
constexpr double kNearly = 0.03;                    // m, of knees, as reachFor() leaves limbs slightly bent

struct LimbPosture : ::testing::Test {
  BodyRig rig = makeRig(humanmodel::makeHuman({}));
  RigPlacement upright = uprightAt(rig, Vector3d::Zero());

  RigPlacement placed(const RigPose& pose) const {
    RigPlacement X_WS;
    place(rig, pose, X_WS);
    return X_WS;
  }
  /// Standing, the left ankle `ahead` and `up` (m) of its place.
  RigPose stepping(double ahead, double up) const {
    RigPose pose;
    pose.X_WP = upright[0];
    const Vector3d ankle = upright[index(RigSegment::kFootLeft)].translation();
    reachFor(rig, kLimbs[kLeftLeg], upright, ankle + Vector3d(ahead, 0.0, up), 0.0, pose);
    return pose;
  }
};

TEST_F(LimbPosture, KneelsWithAKneeOnTheFloor) {
  EXPECT_FALSE(kneels(upright));
  EXPECT_FALSE(kneels(seatedPlacement(rig)));
  RigPose pose;
  pose.X_WP.translation() = Vector3d(0.0, 0.0, 0.5);
  for (const RigSegment calf : {RigSegment::kCalfLeft, RigSegment::kCalfRight})
    pose.angle[index(calf)][0] = 0.5 * kPi;
  EXPECT_TRUE(kneels(placed(pose)));
}

TEST_F(LimbPosture, FloatsWithBothFeetInTheAir) {
  EXPECT_FALSE(floats(upright));
  EXPECT_FALSE(floats(seatedPlacement(rig)));
  EXPECT_FALSE(floats(placed(stepping(0.6, 0.6)))) << "on one leg";
  RigPose above;
  above.X_WP = upright[0];
  above.X_WP.translation().z() += 0.5;
  EXPECT_TRUE(floats(placed(above)));
  RigPose lies = above;
  lies.X_WP.linear() = Eigen::AngleAxisd(0.5 * kPi, Vector3d::UnitY()).toRotationMatrix();
  EXPECT_FALSE(floats(placed(lies))) << "on a table";
}

TEST_F(LimbPosture, HeadlongWithNoFootAtTheFloor) {
  EXPECT_FALSE(isHeadlong(upright));
  RigPose pose;
  pose.X_WP.translation().z() = 0.95;
  pose.X_WP.linear() = Eigen::AngleAxisd(2.0, Vector3d::UnitY()).toRotationMatrix();
  EXPECT_TRUE(isHeadlong(placed(pose))) << "the legs go on where the back points";
  EXPECT_FALSE(isHeadlong(placed(standingLegs(rig, pose, placed(pose))))) << "bent over";
}

// Legs that were raised to the height of the hips, of somebody who stands.
TEST_F(LimbPosture, StandingLegsAreBelowTheHips) {
  RigPose pose = stepping(0.6, 0.9);
  const RigPlacement stands = placed(standingLegs(rig, pose, placed(pose)));
  for (const RigSegment joint : {RigSegment::kCalfLeft, RigSegment::kFootLeft, RigSegment::kFootRight})
    EXPECT_LE((stands[index(joint)].translation() - upright[index(joint)].translation()).norm(), kNearly);
}

TEST_F(LimbPosture, RaisedLegIsFarAboveTheOtherOne) {
  EXPECT_FALSE(raisedLeg(upright));
  EXPECT_FALSE(raisedLeg(seatedPlacement(rig)));
  EXPECT_FALSE(raisedLeg(placed(stepping(0.4, 0.15)))) << "a step";
  EXPECT_EQ(raisedLeg(placed(stepping(0.6, 0.5))), kLeftLeg);
}

TEST_F(LimbPosture, LoweredLegIsBesideTheOtherOne) {
  const RigPose pose = stepping(0.6, 0.5);
  const RigPlacement lowered = placed(loweredLeg(rig, pose, placed(pose), kLeftLeg));
  for (const RigSegment joint : {RigSegment::kCalfLeft, RigSegment::kFootLeft})
    EXPECT_LE((lowered[index(joint)].translation() - upright[index(joint)].translation()).norm(), kNearly);
}

// Both feet of a squatting body, of which one was folded backwards.
TEST_F(LimbPosture, FoldedLegIsPlantedBelowTheHip) {
  constexpr double kSquat = 0.45, kAnkle = 0.15;  // m, from the floor to the hips, to the ankle at most
  EXPECT_FALSE(plantedLeg(rig, RigPose{}, upright, kLeftLeg)) << "straight";
  RigPose pose;
  pose.X_WP = upright[0];
  pose.X_WP.translation().z() = kSquat;
  const RigPlacement low = placed(pose);
  const Vector3d hip = low[index(kLimbs[kLeftLeg].upper)].translation();
  reachFor(rig, kLimbs[kLeftLeg], low, hip - Vector3d(0.35, 0.0, 0.1), 0.0, pose);
  const std::optional<RigPose> planted = plantedLeg(rig, pose, placed(pose), kLeftLeg);
  ASSERT_TRUE(planted);
  const RigPlacement X_WS = placed(*planted);
  const Vector3d ankle = X_WS[index(kLimbs[kLeftLeg].end)].translation();
  EXPECT_LE((ankle - hip).head<2>().norm(), kNearly);
  EXPECT_LE(ankle.z(), kAnkle);
  EXPECT_FALSE(plantedLeg(rig, *planted, X_WS, kLeftLeg)) << "is there";
}

TEST_F(LimbPosture, RaisedArmIsHungBesideTheTrunk) {
  const Limb& arm = kLimbs[kRightArm];
  EXPECT_FALSE(isRaised(upright, arm));
  RigPose pose;
  pose.X_WP = upright[0];
  raiseArms(rig, 0.3, pose);
  const RigPlacement raised = placed(pose);
  ASSERT_TRUE(isRaised(raised, arm));
  const RigPlacement hanging = placed(hangingArm(rig, pose, raised, arm));
  EXPECT_FALSE(isRaised(hanging, arm));
  // The wrists of upright people hang straight below the shoulders; those of bent arms a little higher.
  constexpr double kBent = 0.10;  // m
  EXPECT_LE((hanging[index(arm.end)].translation() - upright[index(arm.end)].translation()).norm(), kBent);
  EXPECT_TRUE(isRaised(hanging, kLimbs[0])) << "the other arm stays";
}

}  // namespace limb_posture_test
}  // namespace abstand::tracking
