// Captures of the CMU data base lost bones when they became BVH: they are put in, and only there.
#include "tracking/bvh/lost_bones.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/small_human.hpp"
#include "tracking/bvh/bvh_recording.hpp"

namespace abstand::tracking {
namespace lost_bones_test {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kExact = 1e-9;  // m

struct Capture {
  const char* file;
  double before, after;  ///< m, stature
  const char* chest;
  double thorax;  ///< m
};

/// Statures are those of the files' bones; that of the person of 01_01 is not published.
const Capture kCaptures[] = {{"cmu_12_01_walk_motionbuilder.bvh", 1.45, 1.56, "Spine1", 0.105},
                             {"cmu_jumping_jacks_3dsmax_names.bvh", 1.53, 1.65, "Chest2", 0.117},
                             {"01_01.bvh", 1.52, 1.63, "Spine1", 0.115}};

std::filesystem::path pathOf(const std::string& name) {
  return name.starts_with("01_") ? testing::debianBvh(name) : testing::sharedData("mocap/bvh/" + name);
}

TEST(LostBones, CmuCapturesRegainThoraxAndWrists) {
  constexpr double kStature = 0.01, kBone = 0.003;  // m
  for (const Capture& c : kCaptures) {
    const auto file = pathOf(c.file);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    const std::string text = readFile(file);
    const Recording before = readBvhRecording(text, c.file, {.repair = false});
    const Recording after = readBvhRecording(text, c.file, {});
    EXPECT_THAT(before.report.repairs, IsEmpty());
    EXPECT_THAT(before.report.warnings,
                Contains(::testing::MatchesRegex("not repaired: the file lacks a bone after '" +
                                                 std::string(c.chest) +
                                                 "': neck, head and arms are some 1[0-9]+ mm too low")));
    EXPECT_THAT(before.report.warnings, Contains(HasSubstr("mm too near to the elbow"))) << c.file;
    EXPECT_THAT(after.report.warnings, ::testing::Not(Contains(HasSubstr("not repaired"))));
    EXPECT_NEAR(before.report.stature, c.before, kStature) << c.file;
    EXPECT_NEAR(after.report.stature, c.after, kStature) << c.file;
    ASSERT_EQ(after.report.repairs.size(), 3u) << c.file;
    EXPECT_THAT(after.report.repairs[0], HasSubstr("the file lacks a bone after '" + std::string(c.chest)));
    EXPECT_THAT(after.report.repairs[1], HasSubstr("the wrist"));
    EXPECT_THAT(after.report.notes, Contains(HasSubstr("--no-repair")));
    BvhPoints points(text, c.file, true);
    ASSERT_EQ(points.lost().size(), 3u);
    EXPECT_NEAR(points.lost()[0].length * after.report.scale, c.thorax, kBone) << c.file;
    // Legs stay; shoulders and neck rise by the bone.
    for (const auto j : {humanmodel::Joint::kHipLeft, humanmodel::Joint::kAnkleRight})
      EXPECT_EQ((after.frames[0][j] - before.frames[0][j]).norm(), 0.0);
    for (const auto j : {humanmodel::Joint::kShoulderLeft, humanmodel::Joint::kNeck})
      EXPECT_NEAR((after.frames[0][j] - before.frames[0][j]).norm(), c.thorax, kBone) << c.file;
  }
}

/// The capture with `offset` at the necks and collars that begin where the chest does, in units of the file.
std::string withOffsets(std::string bvh, const std::string& offset) {
  for (const char* name : {"JOINT Neck\n", "JOINT lowerneck\n", "JOINT LeftShoulder\n",
                           "JOINT RightShoulder\n", "JOINT LeftCollar\n", "JOINT RightCollar\n"}) {
    const auto joint = bvh.find(name);
    if (joint == std::string::npos) continue;
    const auto from = bvh.find("OFFSET", joint), to = bvh.find('\n', from);
    double x = 1.0, y = 1.0, z = 1.0;
    std::istringstream(bvh.substr(from + 6, to - from)) >> x >> y >> z;
    if (Vector3d(x, y, z).norm() == 0.0) bvh.replace(from, to - from, "OFFSET " + offset);
  }
  return bvh;
}

TEST(LostBones, SmallOffsetsDoNotHideLostBones) {
  constexpr double kStature = 0.025;  // m: the result of Captures, and the OFFSET itself
  for (const Capture& c : kCaptures) {
    const auto file = pathOf(c.file);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    std::string text = readFile(file);
    std::erase(text, '\r');
    // Units of 5.6 cm.
    for (const char* offset : {"0 0.000001 0", "0 0.0001 0", "0.003 -0.002 0.004", "0 0.01 0", "0 0.05 0",
                               "0 -0.05 0", "0.02 0.2 0.02"}) {
      const Recording r = readBvhRecording(withOffsets(text, offset), c.file, {});
      EXPECT_THAT(r.report.repairs, ::testing::SizeIs(3)) << c.file << " " << offset;
      EXPECT_NEAR(r.report.stature, c.after, kStature) << c.file << " " << offset;
    }
    // 34 mm, which somebody has measured.
    EXPECT_THAT(readBvhRecording(withOffsets(text, "0 0.6 0"), c.file, {}).report.repairs, IsEmpty())
        << c.file;
  }
}

TEST(LostBones, OtherFilesStayUnchanged) {
  for (const char* name : {"blender_reactidle_003_genuine.bvh", "bvhio_example.bvh", "bvhtoolbox_walk01.bvh",
                           "fair1_wave_hello.bvh", "mocapbank_test.bvh", "rokoko_jesse_dance.bvh",
                           "xsens_names_pybvh_test2.bvh", "xzy_spine3_pybvh_test1.bvh"}) {
    const auto file = pathOf(name);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    EXPECT_THAT(readBvhRecording(readFile(file), name, {}).report.repairs, IsEmpty()) << name;
  }
}

/// A person whose chest is `chest` m above the lower spine, with neck and collars there.
std::string shortened(double chest) {
  std::string bvh = testing::bvhOf({});
  const auto replace = [&](const std::string& joint, const std::string& offset) {
    for (auto at = bvh.find(joint); at != std::string::npos; at = bvh.find(joint, at + 1)) {
      const auto from = bvh.find("OFFSET", at);
      bvh.replace(from, bvh.find('\n', from) - from, "OFFSET " + offset);
    }
  };
  replace("JOINT Chest", "0 0 " + std::to_string(100.0 * chest));
  for (const char* joint : {"JOINT Neck", "JOINT LeftCollar", "JOINT RightCollar"}) replace(joint, "0 0 0");
  return bvh;
}

TEST(LostBones, OnlyShortSpineIsRepaired) {
  const Recording repaired = readBvhRecording(shortened(0.25), "t.bvh", {});
  ASSERT_THAT(repaired.report.repairs, ::testing::SizeIs(1));
  const Recording plain = readBvhRecording(shortened(0.25), "t.bvh", {.repair = false});
  EXPECT_THAT(plain.report.repairs, IsEmpty());
  EXPECT_THAT(plain.report.warnings, Contains(HasSubstr("neck, head and arms are some 250 mm too low")));
  EXPECT_NEAR(
      (repaired.frames[0][humanmodel::Joint::kNeck] - plain.frames[0][humanmodel::Joint::kNeck]).norm(), 0.25,
      kExact)
      << "as long as the other bone of the spine";
  EXPECT_THAT(readBvhRecording(shortened(0.50), "t.bvh", {}).report.repairs, IsEmpty());
  EXPECT_THAT(readBvhRecording(shortened(0.50), "t.bvh", {.repair = false}).report.warnings,
              ::testing::Not(Contains(HasSubstr("repaired"))));
  EXPECT_THAT(readBvhRecording(testing::bvhOf({}), "t.bvh", {}).report.repairs, IsEmpty());
}

TEST(LostBones, JointsWithPositionChannelsStayUnchanged) {
  BvhHierarchy h;
  const auto add = [&](int parent, const Vector3d& offset) {
    BvhJoint joint;
    joint.parent = parent;
    joint.offset = offset;
    h.joints.push_back(joint);
    return static_cast<int>(h.joints.size()) - 1;
  };
  const int hips = add(-1, Vector3d::Zero());
  const int chest = add(hips, {0, 0, 0.25});
  add(add(chest, Vector3d::Zero()), {0, 0, 0.2});
  for (const double side : {1.0, -1.0}) {
    int i = add(chest, Vector3d::Zero());
    for (const Vector3d& o :
         {Vector3d(0, side * 0.2, 0), Vector3d(0, 0, -0.3), Vector3d(0, 0, -0.25), Vector3d(0, 0, -0.18)})
      i = add(i, o);
    i = add(hips, {0, side * 0.1, 0});
    for (const Vector3d& o : {Vector3d(0, 0, -0.42), Vector3d(0, 0, -0.44), Vector3d(0.2, 0, 0)})
      i = add(i, o);
  }
  BvhHierarchy moved = h;
  EXPECT_EQ(repairLostBones(h).size(), 1u);
  for (BvhJoint& joint : moved.joints) joint.channels = {BvhChannel::kXPosition};
  EXPECT_THAT(repairLostBones(moved), IsEmpty());
}

TEST(LostBones, EmptyAndFlatTreesStayUnchanged) {
  BvhHierarchy none;
  EXPECT_THAT(repairLostBones(none), IsEmpty());
  none.joints.resize(50);
  for (std::size_t i = 1; i < none.joints.size(); ++i) none.joints[i].parent = static_cast<int>(i / 3);
  EXPECT_THAT(repairLostBones(none), IsEmpty());
}

}  // namespace lost_bones_test
}  // namespace abstand::tracking
