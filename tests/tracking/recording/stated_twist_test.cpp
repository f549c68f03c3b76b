// Twist from the orientations of files: of people made by hand, and of a real Kinect.
#include "tracking/recording/stated_twist.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "humanmodel/human_model.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/small_human.hpp"
#include "tracking/bvh/bvh_recording.hpp"
#include "tracking/recording/up_axis.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace stated_twist_test {

using humanmodel::BodyPart;
using humanmodel::Joint;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::SmallHuman;

constexpr double kRounding = 1e-6;  // directions are floats
const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

Matrix3d about(const Vector3d& axis, double degrees) {
  return Eigen::AngleAxisd(unit::deg(degrees), axis).toRotationMatrix();
}
Vector3d lateral(const humanmodel::SkeletonFrame& frame, Joint joint) {
  return frame.lateral[static_cast<std::size_t>(joint)].cast<double>();
}
/// Columns: where forward, left and up of the person are in the file.
Matrix3d axes(const Vector3d& x, const Vector3d& y, const Vector3d& z) {
  Matrix3d R;
  R << x, y, z;
  return R;
}

// The person of the file stands with hanging arms and faces x, so that the y axis of every part is y.
TEST(StatedTwist, OrientationsOfABvhTurnParts) {
  const Matrix3d R_WB = about(kZ, 25.0);
  for (const Matrix3d& R_FW : {Matrix3d(Matrix3d::Identity()), axes(kZ, kX, kY), axes(kY, kZ, kX)}) {
    SmallHuman human;
    human.R_FW = R_FW;
    human.R_WB = R_WB;
    human.turned = {{"LeftElbow", about(kZ, 50.0)},
                    {"RightWrist", about(kZ, -70.0)},
                    {"Head", about(kZ, 40.0)},
                    {"LeftAnkle", about(kX, 20.0)}};
    const Recording r = readBvhRecording(testing::bvhOf(human), "t.bvh", {});
    // z is up; the person may face another way than x.
    const Matrix3d R = rotationToZUp(r.report.up.axis) * R_FW * R_WB;
    EXPECT_THAT(r.report.person.twisted,
                ElementsAre("biceps_left", "forearm_left", "hand_left", "foot_left", "biceps_right",
                            "forearm_right", "hand_right", "foot_right", "head"));
    for (const auto& f : r.frames) {
      EXPECT_LT((lateral(f, Joint::kElbowLeft) - R * kY).norm(), kRounding);
      EXPECT_LT((lateral(f, Joint::kWristLeft) - R * about(kZ, 50.0) * kY).norm(), kRounding);
      EXPECT_LT((lateral(f, Joint::kHandLeft) - R * about(kZ, 50.0) * kY).norm(), kRounding);
      EXPECT_LT((lateral(f, Joint::kWristRight) - R * kY).norm(), kRounding);
      EXPECT_LT((lateral(f, Joint::kHandRight) - R * about(kZ, -70.0) * kY).norm(), kRounding);
      EXPECT_LT((lateral(f, Joint::kHeadTop) - R * about(kZ, 40.0) * kY).norm(), kRounding);
      EXPECT_LT((lateral(f, Joint::kToeLeft) - R * about(kX, 20.0) * kY).norm(), kRounding);
      EXPECT_TRUE(lateral(f, Joint::kKneeLeft).isZero()) << "legs follow from knees";
    }
  }
}

TEST(StatedTwist, LeftHandedAxesAndExchangedSides) {
  SmallHuman human;
  human.turned = {{"LeftElbow", about(kZ, 50.0)}};
  human.R_FW = axes(kX, -kY, kZ);
  Recording r = readBvhRecording(testing::bvhOf(human), "t.bvh", {.up = "z", .mirror = "axes"});
  EXPECT_LT((lateral(r.frames[0], Joint::kWristLeft) - about(kZ, 50.0) * kY).norm(), kRounding);
  human.R_FW.setIdentity();
  human.rename = [](const std::string& name) {
    if (name.starts_with("Left")) return "Right" + name.substr(4);
    return name.starts_with("Right") ? "Left" + name.substr(5) : name;
  };
  r = readBvhRecording(testing::bvhOf(human), "t.bvh", {.mirror = "sides"});
  EXPECT_LT((lateral(r.frames[0], Joint::kWristLeft) - about(kZ, 50.0) * kY).norm(), kRounding);
  EXPECT_LT((lateral(r.frames[0], Joint::kWristRight) - kY).norm(), kRounding);
}

/// Frames of a person who bends the left elbow by `bend`, and what a file states of them: `turn` of the upper
/// arm.
struct BentArm {
  explicit BentArm(double bend, const Matrix3d& turn = Matrix3d::Identity()) {
    humanmodel::SkeletonFrame frame = humanmodel::makeHuman({}).rest;
    turns.rest = frame;
    turns.source.fill(0);
    for (const Joint j : {Joint::kWristLeft, Joint::kHandLeft})
      frame.set(j, frame[Joint::kElbowLeft] + about(-kY, bend) * (frame[j] - frame[Joint::kElbowLeft]));
    frames.assign(3, frame);
    PartTurns of_parts;
    of_parts.fill(Eigen::Quaternionf::Identity());
    of_parts[0] = Quaterniond(turn).cast<float>();
    turns.frames.assign(3, of_parts);
  }
  std::vector<humanmodel::SkeletonFrame> frames;
  StatedTurns turns;
};

TEST(StatedTwist, BentElbowsShowTheTwistAtRest) {
  // The rest pose of the file has the palms ahead: the elbow bends about another axis of the arm.
  BentArm down(80.0, about(kZ, 40.0)), ahead(80.0, about(kZ, 80.0)), straight(10.0, about(kZ, 80.0));
  StatedTwist twist = stateTwist(down.turns, Matrix3d::Identity(), down.frames);
  EXPECT_EQ(twist.parts.size(), kTurnedParts.size());
  EXPECT_THAT(twist.notes, IsEmpty());
  EXPECT_LT((lateral(down.frames[0], Joint::kElbowLeft) - about(kZ, 40.0) * kY).norm(), kRounding);
  twist = stateTwist(ahead.turns, Matrix3d::Identity(), ahead.frames);
  EXPECT_EQ(twist.parts.size(), kTurnedParts.size());
  EXPECT_LT((lateral(ahead.frames[0], Joint::kElbowLeft) - kY).norm(), kRounding);
  EXPECT_LT((lateral(ahead.frames[0], Joint::kWristLeft) - about(kZ, -80.0) * kY).norm(), kRounding)
      << "the forearm turns with the arm at rest";
  EXPECT_LT((lateral(ahead.frames[0], Joint::kWristRight) - kY).norm(), kRounding);
  twist = stateTwist(straight.turns, Matrix3d::Identity(), straight.frames);
  EXPECT_LT((lateral(straight.frames[0], Joint::kElbowLeft) - about(kZ, 80.0) * kY).norm(), kRounding)
      << "a straight arm shows nothing";
}

TEST(StatedTwist, OrientationsThatContradictTheElbowAreNotUsed) {
  BentArm erratic(80.0);
  for (std::size_t i = 0; i < 3; ++i)
    erratic.turns.frames[i][0] = Quaterniond(about(kZ, 120.0 * static_cast<double>(i))).cast<float>();
  const StatedTwist twist = stateTwist(erratic.turns, Matrix3d::Identity(), erratic.frames);
  EXPECT_THAT(twist.parts,
              ElementsAre("foot_left", "biceps_right", "forearm_right", "hand_right", "foot_right", "head"));
  EXPECT_THAT(twist.notes, ElementsAre(HasSubstr("biceps_left")));
  EXPECT_TRUE(lateral(erratic.frames[0], Joint::kHandLeft).isZero()) << "the hand turns on the arm";
}

TEST(StatedTwist, RestPoseMustShowTheTwist) {
  BentArm bent(0.0);
  humanmodel::SkeletonFrame& rest = bent.turns.rest;
  const Vector3d elbow = rest[Joint::kElbowRight];
  for (const Joint j : {Joint::kWristRight, Joint::kHandRight})
    rest.set(j, elbow + about(-kY, 90.0) * (rest[j] - elbow));
  rest.set(Joint::kToeLeft, rest[Joint::kAnkleLeft] - 0.2 * kX);
  StatedTwist twist = stateTwist(bent.turns, Matrix3d::Identity(), bent.frames);
  EXPECT_THAT(twist.parts, ElementsAre("biceps_left", "forearm_left", "hand_left", "foot_right", "head"));
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) rest.p[j] = about(kY, 90.0) * rest.p[j];
  twist = stateTwist(bent.turns, Matrix3d::Identity(), bent.frames);
  EXPECT_THAT(twist.parts, IsEmpty()) << "lies";
}

TEST(StatedTwist, WithoutOrientationsNothingIsStated) {
  BentArm bent(80.0);
  bent.turns.frames.clear();
  EXPECT_THAT(stateTwist(bent.turns, Matrix3d::Identity(), bent.frames).parts, IsEmpty());
  EXPECT_FALSE(bent.frames[0].lateral.isStated());
}

// The orientations of a Kinect and of an optical capture do not contradict the positions of the joints.
TEST(StatedTwist, RealRecordingsAgreeWithTheirPositions) {
  for (const char* file : {"kinect/uiprmd_kinect_v2/m05_s01_e01_positions.txt", "mocap/asfamc/11_01.amc"}) {
    const auto path = testing::sharedData(file);
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path;
    const Recording r = openRecording(path);
    for (const char* part : {"forearm_left", "forearm_right", "hand_left", "hand_right", "foot_left", "head"})
      EXPECT_THAT(r.report.person.twisted, Contains(part)) << file;
    EXPECT_THAT(r.report.notes, Not(Contains(HasSubstr("contradict")))) << file;
  }
}

}  // namespace stated_twist_test
}  // namespace abstand::tracking
