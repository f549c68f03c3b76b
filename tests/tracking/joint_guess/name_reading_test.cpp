// Sides and segments are read from the names of many conventions.
#include "tracking/joint_guess/name_reading.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tracking/joint_guess/name_guess.hpp"

namespace abstand::tracking {
namespace name_reading_test {

using enum NameWord;

TEST(NameReading, ReadsSidesAndSegments) {
  struct Case {
    const char* name;
    NameWord word;
    NameSide side;
    int number;
  };
  for (const Case& c : {Case{"mixamorig:LeftUpLeg", kThigh, NameSide::kLeft, 0},
                        {"Bip01_R_Thigh", kThigh, NameSide::kRight, 1},
                        {"lShldr", kShoulder, NameSide::kLeft, 0},
                        {"upper_arm.L.001", kUpperArm, NameSide::kLeft, 1},
                        {"scene|rig|hand_r#2", kHand, NameSide::kRight, 2},
                        {"larm", kArm, NameSide::kLeft, 0},
                        {"leg", kLeg, NameSide::kNone, 0},
                        {"RLOWERLEG", kShin, NameSide::kRight, 0},
                        {"CC_Base_L_Upperarm", kUpperArm, NameSide::kLeft, 0},
                        {"J_Bip_R_LowerArm", kForearm, NameSide::kRight, 0},
                        {"Skeleton_LeftFoot", kFoot, NameSide::kLeft, 0},
                        {"Spine_02", kSpine, NameSide::kNone, 2},
                        {"l_collar-bone", kCollar, NameSide::kLeft, 0},
                        {"LeftHandIndex1", kUnknown, NameSide::kLeft, 1},
                        {"upperarm_twist_01_l", kUnknown, NameSide::kLeft, 1},
                        {"LeftRightHand", kUnknown, NameSide::kLeft, 0},
                        {"\xe5\xb7\xa6\xe8\x85\x95", kUnknown, NameSide::kNone, 0},
                        {"", kUnknown, NameSide::kNone, 0},
                        {"::||", kUnknown, NameSide::kNone, 0}}) {
    const NameReading r = readJointName(c.name);
    EXPECT_EQ(r.word, c.word) << c.name;
    if (c.word == kUnknown) continue;
    EXPECT_EQ(r.side, c.side) << c.name;
    EXPECT_EQ(r.number, c.number) << c.name;
  }
  EXPECT_TRUE(readJointName("Head/end").is_end);
  EXPECT_EQ(readJointName("arm" + std::string(50, '9')).number, 100000);
  EXPECT_EQ(readJointName(std::string(100000, 'L')).word, kUnknown);
}

/// The name that a guess gives a joint.
std::string guessed(const std::vector<std::string>& names, humanmodel::Joint j) {
  const JointMatch m = guessByNames(names, true);
  const int i = m.joint[static_cast<std::size_t>(j)];
  return i < 0 ? "" : names[static_cast<std::size_t>(i)];
}

TEST(NameGuess, ContextDecidesAmbiguousWords) {
  using humanmodel::Joint;
  const std::vector<std::string> max{"L Clavicle", "L UpperArm", "L Forearm", "L Hand", "L Thigh", "L Calf"},
      biovision{"LeftCollar", "LeftShoulder", "LeftElbow", "LeftWrist", "LeftHip", "LeftKnee", "LeftAnkle"},
      human_ik{"LeftShoulder", "LeftArm", "LeftForeArm", "LeftHand",
               "LeftUpLeg",    "LeftLeg", "LeftFoot",    "LeftToeBase"},
      bones{"hip_l", "leg_l", "lower_leg_l", "foot_l", "foot_l/end", "hand_l", "hand_l/end"};
  EXPECT_EQ(guessed(max, Joint::kShoulderLeft), "L UpperArm");
  EXPECT_EQ(guessed(max, Joint::kWristLeft), "L Hand");
  EXPECT_EQ(guessed(biovision, Joint::kShoulderLeft), "LeftShoulder");
  EXPECT_EQ(guessed(biovision, Joint::kHipLeft), "LeftHip");
  EXPECT_EQ(guessed(biovision, Joint::kKneeLeft), "LeftKnee");
  EXPECT_EQ(guessed(human_ik, Joint::kShoulderLeft), "LeftArm");
  EXPECT_EQ(guessed(human_ik, Joint::kHipLeft), "LeftUpLeg");
  EXPECT_EQ(guessed(human_ik, Joint::kKneeLeft), "LeftLeg");
  EXPECT_EQ(guessed(human_ik, Joint::kToeLeft), "LeftToeBase");
  EXPECT_EQ(guessed(bones, Joint::kHipLeft), "hip_l");
  EXPECT_EQ(guessed(bones, Joint::kKneeLeft), "lower_leg_l");
  EXPECT_EQ(guessed(bones, Joint::kToeLeft), "foot_l/end");
  EXPECT_EQ(guessed(bones, Joint::kHandLeft), "hand_l/end");
}

}  // namespace name_reading_test
}  // namespace abstand::tracking
