// Joint maps: their format, the shipped ones, and the choice between them.
#include "tracking/recording/joint_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "core/base/data_folder.hpp"
#include "core/base/error.hpp"
#include "tests/support/paths.hpp"
#include "tracking/recording/map_misses.hpp"

namespace abstand::tracking {
namespace joint_map_test {

using ::testing::HasSubstr;

int indexOf(const JointMatch& match, humanmodel::Joint j) { return match.joint[static_cast<std::size_t>(j)]; }

TEST(JointMap, ReadsFormat) {
  const JointMap map = parseJointMap(
      "# comment\r\nname: Mine\norigin: here\nlicence: any\nprefix: my: | my_\nrequires: A\n\ntoe_left : L "
      "Toe|L Foot/end\n",
      "m.map");
  EXPECT_EQ(map.name, "Mine");
  EXPECT_EQ(map.prefixes, (std::vector<std::string>{"my:", "my_"}));
  EXPECT_EQ(map.names[static_cast<std::size_t>(humanmodel::Joint::kToeLeft)],
            (std::vector<std::string>{"L Toe", "L Foot/end"}));
}

TEST(JointMap, RejectsBadFilesWithLine) {
  struct Case {
    const char* text;
    int line;
    const char* message;
  };
  for (const Case& c :
       {Case{"name: a\nelbow_lft: b\n", 2, "did you mean 'elbow_left'?"},
        Case{"name: a\nwords\n", 2, "found 'words'"}, Case{"name: a\nneck: b\nneck: c\n", 3, "a second time"},
        Case{"name: a\nneck: b | | c\n", 2, "empty name"}, Case{"neck: b\n", 0, "found no 'name:'"}}) {
    try {
      parseJointMap(c.text, "m.map");
      FAIL() << c.text;
    } catch (const ParseError& e) {
      EXPECT_EQ(e.pos().line, c.line);
      EXPECT_THAT(e.what(), HasSubstr(c.message));
    }
  }
  const testing::ScratchFolder empty;
  EXPECT_THROW(loadJointMaps(empty.path()), ParseError);
}

TEST(JointMap, MatchesNamesVerbatim) {
  const JointMap map = parseJointMap(
      "name: a\nprefix: Bip01\npelvis: Pelvis\nshoulder_left: L UpperArm | L Arm\nneck: L Arm\n", "m");
  for (const char* name :
       {"Bip01 L UpperArm", "bip01_l_upperarm", "L.UpperArm", "actor1:Bip01 L UpperArm", "L Arm"}) {
    const std::vector<std::string> names{"x", name};
    EXPECT_EQ(indexOf(matchJoints(map, names), humanmodel::Joint::kShoulderLeft),
              name == std::string("L Arm") ? -1 : 1)
        << name;
  }
  // The neck is looked for first and takes the joint; no joint serves twice.
  const std::vector<std::string> one{"L Arm"};
  const JointMatch match = matchJoints(map, one);
  EXPECT_EQ(indexOf(match, humanmodel::Joint::kNeck), 0);
  EXPECT_EQ(match.mapped, 1);
}

TEST(JointMap, RequiredNamesRestrictMap) {
  const JointMap map = parseJointMap("name: a\nrequires: Mark\npelvis: Hips\n", "m");
  EXPECT_EQ(matchJoints(map, std::vector<std::string>{"Hips"}).mapped, 0);
  EXPECT_EQ(matchJoints(map, std::vector<std::string>{"Hips", "Mark"}).mapped, 1);
}

TEST(JointMap, ShippedMapsAreComplete) {
  const auto maps = loadJointMaps(testing::projectFile("data/joint_maps"));
  EXPECT_GE(maps.size(), 12u);
  for (const JointMap& map : maps) {
    EXPECT_FALSE(map.origin.empty()) << map.file;
    EXPECT_FALSE(map.licence.empty()) << map.file;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      const auto joint = static_cast<humanmodel::Joint>(j);
      const bool is_derived = joint == humanmodel::Joint::kSpine || joint == humanmodel::Joint::kThorax ||
                              joint == humanmodel::Joint::kHandLeft ||
                              joint == humanmodel::Joint::kHandRight ||
                              (joint == humanmodel::Joint::kHeadTop && map.head == HeadPoint::kMiddle);
      EXPECT_TRUE(is_derived || !map.names[j].empty()) << map.file << humanmodel::jointName(joint);
    }
    // What is left must not be right: each side's names differ by the side only.
    for (std::size_t j = 0; j + 4 < humanmodel::kJointCount; ++j) {
      const std::string name(humanmodel::jointName(static_cast<humanmodel::Joint>(j)));
      if (!name.ends_with("_left")) continue;
      const auto right = humanmodel::parseJoint(name.substr(0, name.size() - 4) + "right");
      ASSERT_TRUE(right);
      EXPECT_EQ(map.names[j].size(), map.names[static_cast<std::size_t>(*right)].size()) << map.file << name;
      if (map.names[j].empty()) continue;
      EXPECT_NE(map.names[j], map.names[static_cast<std::size_t>(*right)]) << map.file << name;
    }
  }
}

// The same name means different joints; the whole set of names decides.
TEST(JointMap, DistinguishesConventions) {
  const auto maps = loadJointMaps(testing::projectFile("data/joint_maps"));
  struct Case {
    const char* map;
    std::vector<std::string> names;
    const char* shoulder;
  };
  const Case cases[] = {
      {"MotionBuilder / HumanIK",
       {"Hips", "Spine", "LeftShoulder", "LeftArm", "LeftForeArm", "LeftHand", "LeftUpLeg", "LeftLeg"},
       "LeftArm"},
      {"Biovision",
       {"Hips", "Chest", "LeftCollar", "LeftShoulder", "LeftElbow", "LeftWrist", "LeftHip", "LeftKnee"},
       "LeftShoulder"},
      {"Mixamo",
       {"mixamorig:Hips", "mixamorig:LeftShoulder", "mixamorig:LeftArm", "mixamorig:LeftForeArm"},
       "mixamorig:LeftArm"},
      {"3ds Max Biped",
       {"Bip01", "Bip01 Pelvis", "Bip01 L Clavicle", "Bip01 L UpperArm", "Bip01 L Forearm"},
       "Bip01 L UpperArm"},
      {"DAZ / Poser", {"hip", "abdomen", "chest", "lCollar", "lShldr", "lForeArm", "lHand"}, "lShldr"},
      {"Blender / Rigify", {"spine", "shoulder.L", "upper_arm.L", "forearm.L", "hand.L"}, "upper_arm.L"},
      {"SMPL", {"Pelvis", "L_Hip", "L_Knee", "Torso", "L_Thorax", "L_Shoulder", "L_Elbow"}, "L_Shoulder"},
      {"Unreal mannequin",
       {"pelvis", "spine_01", "clavicle_l", "upperarm_l", "lowerarm_l", "hand_l"},
       "upperarm_l"},
      {"Side as suffix",
       {"Hips", "Spine", "Shoulder_L", "UpperArm_L", "Forearm_L", "Hand_L", "Thigh_L"},
       "UpperArm_L"}};
  for (const Case& c : cases) {
    const JointMatch match = chooseJointMap(maps, c.names);
    EXPECT_EQ(match.map, c.map);
    const int i = indexOf(match, humanmodel::Joint::kShoulderLeft);
    ASSERT_GE(i, 0) << c.map;
    EXPECT_EQ(c.names[static_cast<std::size_t>(i)], c.shoulder) << c.map;
  }
}

TEST(DataFolder, EnvironmentTakesPrecedence) {
  const char* before = std::getenv("ABSTAND_DATA");
  const std::string kept = before ? before : "";
  ::unsetenv("ABSTAND_DATA");
  EXPECT_TRUE(std::filesystem::equivalent(dataFolder(), testing::projectFile("data")));
  ::setenv("ABSTAND_DATA", "/elsewhere", 1);
  EXPECT_EQ(dataFolder(), "/elsewhere");
  before ? ::setenv("ABSTAND_DATA", kept.c_str(), 1) : ::unsetenv("ABSTAND_DATA");
}

TEST(JointMap, NamesEntriesThatAFileLacks) {
  const std::vector<std::string> names{"rig:LeftForeArm", "LWRA", "Hips"};
  const auto misses = [&](const std::string& lines) {
    const JointMap map = parseJointMap("name: a\n" + lines, "m.map");
    return missesOf(map, matchJoints(map, names), names);
  };
  EXPECT_EQ(misses("elbow_left: None | LeftForeArm\npelvis: Hips\n"), "") << "one of the alternatives";
  EXPECT_EQ(
      misses(
          "elbow_left: LeftForeArmX\nhead: Schaedel\nwrist_left: LWRA + LWRC\npelvis: Hips\nspine: Hips\n"),
      "the joint map names joints that the file does not have: spine 'Hips' (used for another joint), "
      "head 'Schaedel', elbow_left 'LeftForeArmX' (nearest: 'rig:LeftForeArm'), wrist_left 'LWRC' (nearest: "
      "'LWRA')");
  EXPECT_EQ(misses("requires: Hip\npelvis: Hips\n"),
            "the joint map requires 'Hip' (nearest: 'Hips'), which the file does not have: it maps nothing");
}

}  // namespace joint_map_test
}  // namespace abstand::tracking
