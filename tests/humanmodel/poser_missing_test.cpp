// Joints that are missing, guessed or broken.
#include <gtest/gtest.h>

#include "tests/humanmodel/skeletons.hpp"

namespace abstand::humanmodel {
namespace poser_missing_test {

using enum Joint;
using testing::drop;
using testing::person;
using testing::walking;

constexpr double kRounding = 1e-12;

PartState stateOf(const HumanPose& pose, BodyPart part) { return pose.state[index(part)]; }
const Transform& poseOf(const HumanPose& pose, BodyPart part) { return pose.X_WP[index(part)]; }

TEST(PoserMissing, NoPartsBeforeFirstFrame) {
  const HumanModel m = person();
  Poser poser(m);
  HumanPose pose;
  poser.pose(SkeletonFrame{}, pose);
  for (std::size_t i = 0; i < kBodyPartCount; ++i) {
    EXPECT_EQ(pose.state[i], PartState::kNone);
    EXPECT_EQ(pose.age[i], kInfinity);
    EXPECT_TRUE(isPose(pose.X_WP[i]));
  }
}

TEST(PoserMissing, HandContinuesForearm) {
  const HumanModel m = person();
  Poser poser(m);
  HumanPose pose;
  SkeletonFrame frame = walking(0.7);
  drop(frame, kHandLeft);
  poser.pose(frame, pose);
  EXPECT_EQ(stateOf(pose, BodyPart::kHandLeft), PartState::kInferred);
  EXPECT_EQ(stateOf(pose, BodyPart::kHandRight), PartState::kTracked);
  EXPECT_LT(
      (poseOf(pose, BodyPart::kHandLeft).linear() - poseOf(pose, BodyPart::kForearmLeft).linear()).norm(),
      kRounding);
}

TEST(PoserMissing, FootPointsForward) {
  const HumanModel m = person();
  Poser poser(m);
  HumanPose pose;
  SkeletonFrame frame = m.rest;
  const Matrix3d R = Eigen::AngleAxisd(1.1, Vector3d::UnitZ()).toRotationMatrix();
  for (Vector3d& p : frame.p) p = R * p;
  drop(frame, kToeLeft);
  poser.pose(frame, pose);
  EXPECT_EQ(stateOf(pose, BodyPart::kFootLeft), PartState::kInferred);
  EXPECT_LT((poseOf(pose, BodyPart::kFootLeft).linear() - R).norm(), kRounding);
  EXPECT_LT((poseOf(pose, BodyPart::kFootLeft).linear() - poseOf(pose, BodyPart::kFootRight).linear()).norm(),
            kRounding);
}

TEST(PoserMissing, HeadContinuesTorsoWithoutSpine) {
  const HumanModel m = person();
  Poser poser(m);
  HumanPose pose;
  SkeletonFrame frame = walking(0.7);
  drop(frame, kSpine);
  poser.pose(frame, pose);
  EXPECT_EQ(stateOf(pose, BodyPart::kTorso), PartState::kTracked);
  drop(frame, kHeadTop);
  poser.pose(frame, pose);
  EXPECT_EQ(stateOf(pose, BodyPart::kHead), PartState::kTracked) << "the head's middle is enough";
  drop(frame, kHead);
  poser.pose(frame, pose);
  EXPECT_EQ(stateOf(pose, BodyPart::kHead), PartState::kInferred);
  EXPECT_LT((poseOf(pose, BodyPart::kHead).linear() - poseOf(pose, BodyPart::kTorso).linear()).norm(),
            kRounding);
}

TEST(PoserMissing, TrunkIsFoundFromRemainingJoints) {
  const HumanModel m = person();
  HumanPose whole, pose;
  Poser(m).pose(m.rest, whole);
  for (const std::initializer_list<Joint> gone : {std::initializer_list<Joint>{kNeck},
                                                  {kNeck, kThorax},
                                                  {kPelvis},
                                                  {kHipLeft},
                                                  {kHipLeft, kHipRight},
                                                  {kShoulderLeft},
                                                  {kPelvis, kHipLeft},
                                                  {kPelvis, kHipLeft, kHipRight, kSpine},
                                                  {kNeck, kThorax, kShoulderLeft, kShoulderRight}}) {
    SkeletonFrame frame = m.rest;
    for (const Joint j : gone) drop(frame, j);
    Poser(m).pose(frame, pose);
    EXPECT_GE(stateOf(pose, BodyPart::kTorso), PartState::kInferred);
    EXPECT_LT((poseOf(pose, BodyPart::kTorso).matrix() - poseOf(whole, BodyPart::kTorso).matrix()).norm(),
              kRounding);
  }
}

TEST(PoserMissing, HeldPartFollowsItsParent) {
  const HumanModel m = person();
  Poser poser(m);
  HumanPose before, after;
  SkeletonFrame frame = walking(0.0);
  poser.pose(frame, before);

  // The person moves and turns while the left elbow is hidden: upper arm and forearm cannot be placed.
  Transform X = Transform::Identity();
  X.linear() = Eigen::AngleAxisd(0.8, Vector3d::UnitZ()).toRotationMatrix();
  X.translation() = Vector3d(1.0, 2.0, 0.0);
  for (Vector3d& p : frame.p) p = X * p;
  drop(frame, kElbowLeft);
  drop(frame, kHandLeft);
  frame.t = 0.25;
  poser.pose(frame, after);
  for (const BodyPart part : {BodyPart::kBicepsLeft, BodyPart::kForearmLeft, BodyPart::kHandLeft}) {
    EXPECT_EQ(stateOf(after, part), PartState::kHeld) << partName(part);
    EXPECT_LT((poseOf(after, part).matrix() - (X * poseOf(before, part)).matrix()).norm(), kRounding)
        << partName(part);
    EXPECT_DOUBLE_EQ(after.age[index(part)], 0.25);
  }
  EXPECT_EQ(stateOf(after, BodyPart::kBicepsRight), PartState::kTracked);
  frame.t = 0.75;
  poser.pose(frame, after);
  EXPECT_DOUBLE_EQ(after.age[index(BodyPart::kForearmLeft)], 0.75);
  // Back again: seen, and young.
  poser.pose(walking(1.0), after);
  EXPECT_EQ(stateOf(after, BodyPart::kForearmLeft), PartState::kTracked);
  EXPECT_EQ(after.age[index(BodyPart::kForearmLeft)], 0.0);
}

TEST(PoserMissing, TrackedForearmKeepsElbowWithStaleUpperArm) {
  const HumanModel m = person(1.62);
  Poser poser(m);
  HumanPose pose;
  poser.pose(walking(0.0), pose);
  SkeletonFrame frame = walking(0.3);
  drop(frame, kShoulderLeft);
  poser.pose(frame, pose);
  EXPECT_EQ(stateOf(pose, BodyPart::kBicepsLeft), PartState::kHeld);
  EXPECT_EQ(stateOf(pose, BodyPart::kForearmLeft), PartState::kTracked);
  const Vector3d elbow = poseOf(pose, BodyPart::kForearmLeft) * m.part(BodyPart::kForearmLeft).p_proximal;
  EXPECT_LT((elbow - frame[kElbowLeft]).norm(), kRounding);
}

TEST(PoserMissing, BrokenFramesChangeOnlyStateAndAge) {
  const HumanModel m = person();
  std::vector<SkeletonFrame> broken(4, walking(0.2));
  broken[0].set(kWristLeft, {kNaN, 0.0, 0.0});
  broken[1].set(kToeRight, {0.0, kInfinity, 0.0}, JointState::kInferred);
  broken[2].t = kNaN;
  broken[3].set(kPelvis, {1e300, 0.0, 0.0});
  for (const SkeletonFrame& bad : broken) {
    Poser poser(m);
    HumanPose before, after;
    poser.pose(walking(0.1), before);
    poser.pose(bad, after);
    for (std::size_t i = 0; i < kBodyPartCount; ++i) {
      EXPECT_EQ(after.X_WP[i].matrix(), before.X_WP[i].matrix());
      EXPECT_EQ(after.state[i], PartState::kHeld);
      EXPECT_NEAR(after.age[i], std::isfinite(bad.t) ? 0.1 : 0.0, kRounding);
    }
    poser.pose(walking(0.3), after);
    EXPECT_EQ(stateOf(after, BodyPart::kHandLeft), PartState::kTracked);
  }
  // The same as the very first frame: nobody.
  Poser poser(m);
  HumanPose pose;
  poser.pose(broken[0], pose);
  EXPECT_EQ(stateOf(pose, BodyPart::kTorso), PartState::kNone);
}

TEST(PoserMissing, GuessedJointsAreInferred) {
  const HumanModel m = person();
  Poser poser(m);
  HumanPose pose;
  SkeletonFrame frame = walking(0.2);
  frame.set(kElbowRight, frame[kElbowRight], JointState::kInferred);
  poser.pose(frame, pose);
  EXPECT_EQ(stateOf(pose, BodyPart::kBicepsRight), PartState::kInferred);
  EXPECT_EQ(stateOf(pose, BodyPart::kForearmRight), PartState::kInferred);
  EXPECT_EQ(stateOf(pose, BodyPart::kHandRight), PartState::kTracked);
}

TEST(PoserMissing, BackwardTimeStepAddsNoAge) {
  const HumanModel m = person();
  Poser poser(m);
  HumanPose pose;
  poser.pose(walking(5.0), pose);
  SkeletonFrame nothing;
  nothing.t = 6.0;
  poser.pose(nothing, pose);
  EXPECT_DOUBLE_EQ(pose.age[0], 1.0);
  nothing.t = 0.0;
  poser.pose(nothing, pose);
  EXPECT_DOUBLE_EQ(pose.age[0], 1.0);
  nothing.t = 0.5;
  poser.pose(nothing, pose);
  EXPECT_DOUBLE_EQ(pose.age[0], 1.5);
  poser.reset();
  poser.pose(nothing, pose);
  EXPECT_EQ(pose.state[0], PartState::kNone);
}

TEST(PoserMissing, AnyJointsMayBeMissingAtAnyTime) {
  const HumanModel m = person();
  for (const bool follow : {false, true}) {
    Poser poser(m, follow);
    HumanPose pose;
    for (std::uint64_t k = 0; k < 5000; ++k) {
      SkeletonFrame frame = walking(0.02 * static_cast<double>(k));
      const double rate = testing::randomUnit(k, 99);
      for (std::size_t j = 0; j < kJointCount; ++j) {
        if (testing::randomUnit(k, j) < rate) drop(frame, static_cast<Joint>(j));
        // Joints that coincide have no direction.
        if (testing::randomUnit(k, 100 + j) < 0.05 && frame.has(kPelvis) && frame.has(static_cast<Joint>(j)))
          frame.p[j] = frame[kPelvis];
      }
      poser.pose(frame, pose);
      for (std::size_t i = 0; i < kBodyPartCount; ++i) {
        ASSERT_TRUE(isPose(pose.X_WP[i], 1e-9)) << k << " " << partName(static_cast<BodyPart>(i));
        ASSERT_EQ(pose.state[i] >= PartState::kInferred, pose.age[i] == 0.0);
      }
    }
  }
}

}  // namespace poser_missing_test
}  // namespace abstand::humanmodel
