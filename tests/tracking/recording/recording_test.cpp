// What is guessed about a recording, what is derived, and how to override it; on a person made by hand.
#include "tracking/recording/recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/small_human.hpp"
#include "tracking/bvh/bvh_recording.hpp"
#include "tracking/recording/required_person.hpp"
#include "tracking/recording/up_axis.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace recording_test {

using testing::bvhOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kSmallHumanStature;
using ::testing::Not;
using testing::SmallHuman;

constexpr double kRounding = 1e-9;  // m; lengths of 1 m through degrees and text

Recording read(const SmallHuman& human, const RecordingOptions& options = {}) {
  return readBvhRecording(bvhOf(human), "t.bvh", options);
}

double heightOf(const Recording& r, humanmodel::Joint j) { return r.frames.front()[j].z(); }

TEST(Recording, GuessesUnitsWithReason) {
  struct Case {
    double units_per_metre;
    const char* name;
    double scale;
  };
  for (const Case& c : {Case{1.0, "m", 1.0},
                        {100.0, "cm", 0.01},
                        {1000.0, "mm", 0.001},
                        {1.0 / 0.0254, "inches", 0.0254},
                        {0.45 / 0.0254, "cmu", 0.0254 / 0.45}}) {
    const Recording r = read({.units_per_metre = c.units_per_metre});
    EXPECT_EQ(r.report.units.name, c.name);
    EXPECT_DOUBLE_EQ(r.report.scale, c.scale);
    EXPECT_NEAR(r.report.stature, kSmallHumanStature, kRounding) << c.name;
    EXPECT_THAT(r.report.units.reason, HasSubstr("an adult's stature"));
    EXPECT_NEAR(heightOf(r, humanmodel::Joint::kPelvis), 0.95, kRounding);
    EXPECT_THAT(r.report.warnings, IsEmpty()) << c.name;
  }
}

TEST(Recording, ScalesToStatureIfNoUnitFits) {
  const Recording r = read({.units_per_metre = 22.0});
  EXPECT_EQ(r.report.units.name, "free");
  EXPECT_NEAR(r.report.stature, 1.75, kRounding);
  EXPECT_THAT(r.report.warnings, Contains(HasSubstr("no common unit")));
}

TEST(Recording, AcceptsUnitsFromUser) {
  EXPECT_DOUBLE_EQ(read({}, {.units = "inches"}).report.scale, 0.0254);
  EXPECT_DOUBLE_EQ(read({}, {.units = "0.02"}).report.scale, 0.02);
  EXPECT_THAT(read({}, {.units = "m"}).report.warnings, Contains(HasSubstr("172.737 m tall")));
  for (const char* bad : {"furlongs", "-1", "0", "nan", ""})
    EXPECT_THROW(read({}, {.units = bad}), UsageError) << bad;
}

TEST(Recording, FindsUpAlongEveryAxis) {
  for (const char* axis : {"x", "y", "z", "-x", "-y", "-z"}) {
    const Matrix3d R_WF = rotationToZUp(axis);
    EXPECT_EQ(R_WF.determinant(), 1.0);
    const Recording r = read({.R_FW = R_WF.transpose()});
    EXPECT_EQ(r.report.up.axis, axis);
    EXPECT_THAT(r.report.up.reason, HasSubstr("from feet to head"));
    EXPECT_NEAR(heightOf(r, humanmodel::Joint::kPelvis), 0.95, kRounding) << axis;
    EXPECT_NEAR(heightOf(r, humanmodel::Joint::kHeadTop), 0.95 + 0.8, kRounding) << axis;
    EXPECT_GT(r.frames[0][humanmodel::Joint::kShoulderLeft].y(),
              r.frames[0][humanmodel::Joint::kShoulderRight].y())
        << axis;
    EXPECT_THAT(r.report.warnings, IsEmpty()) << axis;
  }
  EXPECT_EQ(rotationToZUp("y") * Vector3d(1, 2, 3), Vector3d(1, -3, 2));
}

TEST(Recording, AcceptsUpFromUserAndReportsLyingPerson) {
  // Rest pose y up, but the body lies along z of the file (-y of z-up axes) in every frame.
  SmallHuman lying{.R_FW = rotationToZUp("y").transpose(), .pelvis_height = 0.1};
  lying.R_WB = Eigen::AngleAxisd(0.5 * kPi, Vector3d::UnitX()).toRotationMatrix();
  const Recording guessed = read(lying);
  EXPECT_EQ(guessed.report.up.axis, "z");
  EXPECT_THAT(guessed.report.warnings, Contains(HasSubstr("give the axis if the person is lying")));
  EXPECT_NEAR(guessed.report.stature, kSmallHumanStature, kRounding);
  const Recording said = read(lying, {.up = "y"});
  EXPECT_NEAR(heightOf(said, humanmodel::Joint::kHeadTop), 0.1, kRounding);
  EXPECT_THROW(read(lying, {.up = "w"}), UsageError);
}

/// Frames of the small human as JSON lines with Abstand's names, turned by `R`, 1 m ahead of the origin.
std::string jsonOf(const Matrix3d& R) {
  const Recording r = read({.frames = 30});
  std::string text;
  for (const auto& f : r.frames) {
    std::string joints;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      if (!f.has(static_cast<humanmodel::Joint>(j))) continue;
      const Vector3d p = R * (f.p[j] + Vector3d(1.0, 0.0, 0.0));
      joints += (joints.empty() ? "\"" : ", \"") +
                std::string(humanmodel::jointName(static_cast<humanmodel::Joint>(j))) + "\": [" +
                std::to_string(p.x()) + ", " + std::to_string(p.y()) + ", " + std::to_string(p.z()) + "]";
    }
    text += "{\"t\": " + std::to_string(f.t) + ", \"joints\": {" + joints + "}}\n";
  }
  return text;
}

/// Formats with an axis of their own are read with it, but a whole recording of somebody who would stand
/// along another one is doubtful.
TEST(Recording, DoubtsStatedUpAxis) {
  const testing::ScratchFolder folder;
  const auto warnings = [&](const Matrix3d& R, const RecordingOptions& options = {}) {
    return openRecording(folder.write("own.jsonl", jsonOf(R)), options).report.warnings;
  };
  EXPECT_THAT(warnings(Matrix3d::Identity()), IsEmpty());
  for (const char* axis : {"x", "y", "-x", "-y"}) {
    const Matrix3d R = rotationToZUp(axis).transpose();
    const std::string up = axis;
    EXPECT_THAT(warnings(R),
                Contains(HasSubstr("the person lies along " + up + " of the file in all frames")));
    EXPECT_THAT(warnings(R),
                Contains(HasSubstr("but z is its up axis: if " + up + " is up, give it (--up " + up)));
    EXPECT_THAT(warnings(R, {.up = axis}), Not(Contains(HasSubstr("lies along")))) << axis;
    EXPECT_THAT(warnings(R, {.up = "z"}), Not(Contains(HasSubstr("lies along")))) << "the user says so";
  }
  // Somebody who lies obliquely to the axes, or not with the feet at 0.
  const Matrix3d R_lying = Eigen::AngleAxisd(0.25 * kPi, Vector3d::UnitZ()) * rotationToZUp("y").transpose();
  EXPECT_THAT(warnings(R_lying), Not(Contains(HasSubstr("lies along"))));
}

TEST(Recording, RealUpAxesAreNotDoubted) {
  for (const char* name :
       {"kinect/irds_kinect_v2/215_18_0_1_1_stand.csv", "kinect/irds_kinect_v2/217_18_0_1_1_wheelchair.csv",
        "kinect/uiprmd_kinect_v2/m05_s01_e01_positions.txt", "depth/utd_mhad/a18_s1_t1/skeleton.csv",
        "mocap/c3d/PiG/PiG_Motion3_FF.c3d", "mocap/trc/motek/T.trc"}) {
    const auto file = testing::sharedData(name);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    EXPECT_THAT(openRecording(file).report.warnings, Not(Contains(HasSubstr("lies along")))) << name;
  }
}

TEST(Recording, DerivesMissingJoints) {
  const auto z = [](const Recording& r, humanmodel::Joint j) { return r.frames.front()[j].z(); };
  const auto state = [](const Recording& r, humanmodel::Joint j) {
    return r.frames.front().state[static_cast<std::size_t>(j)];
  };
  const Recording r = read({.rename = [](const std::string& n) { return n == "Chest" ? "Middle" : n; }});
  EXPECT_NEAR(z(r, humanmodel::Joint::kHead), 0.95 + 0.7, kRounding)
      << "between the base of the skull and the vertex";
  EXPECT_NEAR(z(r, humanmodel::Joint::kThorax), 0.95 + 0.45, kRounding) << "between the shoulders";
  EXPECT_NEAR(z(r, humanmodel::Joint::kSpine), 0.95 + 0.225, kRounding) << "between pelvis and thorax";
  EXPECT_EQ(state(r, humanmodel::Joint::kSpine), humanmodel::JointState::kInferred);
  EXPECT_EQ(state(r, humanmodel::Joint::kNeck), humanmodel::JointState::kTracked);

  // A map without end sites: head top, hands and toes are put where bodies have them, and the report says so.
  const testing::ScratchFolder folder;
  std::string map = "name: Bare\npelvis: Hips\nneck: Neck\nhead: Head\n";
  for (const auto& [side, big] : {std::pair{"left", "Left"}, {"right", "Right"}})
    for (const auto& [joint, name] : {std::pair{"shoulder", "Shoulder"},
                                      {"elbow", "Elbow"},
                                      {"wrist", "Wrist"},
                                      {"hip", "Hip"},
                                      {"knee", "Knee"},
                                      {"ankle", "Ankle"}})
      map += std::string(joint) + "_" + side + ": " + big + name + "\n";
  const Recording bare = read({}, {.joint_map = folder.write("bare.map", map)});
  EXPECT_NEAR(z(bare, humanmodel::Joint::kHeadTop), 0.95 + 0.5 + 0.25, kRounding)
      << "half a trunk above the neck";
  EXPECT_NEAR(z(bare, humanmodel::Joint::kHandLeft), 0.95 + 0.45 - 0.55 - 0.25 * 0.108 / 0.146, kRounding);
  EXPECT_NEAR(bare.frames.front()[humanmodel::Joint::kToeRight].x(), 0.45 * 0.44, kRounding) << "ahead";
  EXPECT_NEAR(z(bare, humanmodel::Joint::kToeRight), 0.95 - 0.86 - 0.44 * 0.039 / 0.246, kRounding)
      << "and below the ankle";
  EXPECT_EQ(bare.report.mapped.size(), 14u);
  EXPECT_EQ(state(bare, humanmodel::Joint::kToeRight), humanmodel::JointState::kInferred);
  EXPECT_THAT(
      bare.report.warnings,
      Contains(HasSubstr("derived from other joints: head_top, hand_left, hand_right, toe_left, toe_right")));
}

TEST(Recording, ReportsPartsItCannotMove) {
  // By a map that the user gives, as the joint would be guessed otherwise.
  const Recording r = read({.rename = [](const std::string& n) { return n == "LeftElbow" ? "Spare" : n; }},
                           {.joint_map = testing::projectFile("data/joint_maps/biovision.map")});
  EXPECT_THAT(r.report.missing_parts, ::testing::ElementsAre("biceps_left", "forearm_left"));
  EXPECT_THAT(r.report.warnings, Contains(HasSubstr("biceps_left (no elbow_left)")));
  EXPECT_THAT(r.report.not_mapped, Contains("Spare"));
  EXPECT_EQ(r.report.mapped.size(), 12u);
}

TEST(Recording, ReportsSwappedSides) {
  const auto swap = [](const std::string& n) {
    if (n.starts_with("Left")) return "Right" + n.substr(4);
    return n.starts_with("Right") ? "Left" + n.substr(5) : n;
  };
  EXPECT_THAT(read({.rename = swap}).report.warnings, Contains(HasSubstr("left and right seem swapped")));
}

TEST(Recording, OpensByContentNotByName) {
  const testing::ScratchFolder folder;
  const auto bvh = folder.write("walk.txt", bvhOf({}));
  const Recording r = openRecording(bvh);
  EXPECT_EQ(r.report.format, "bvh");
  EXPECT_DOUBLE_EQ(r.report.rate, 100.0);
  EXPECT_DOUBLE_EQ(r.report.duration, 0.02);
  EXPECT_EQ(r.at(0.0149).t, 0.01);
  EXPECT_EQ(r.at(-1.0).t, 0.0);
  EXPECT_THROW(openRecording(bvh, {.format = "mpeg"}), UsageError);
  EXPECT_THROW(openRecording(bvh, {.joint_map = folder.path() / "none.map"}), ParseError);
  const auto map = folder.write("own.map", "name: Own\npelvis: Hips\n");
  EXPECT_EQ(openRecording(bvh, {.joint_map = map}).report.joint_map, "Own");
}

TEST(Recording, RejectsBadFiles) {
  const testing::ScratchFolder folder;
  const std::string whole = bvhOf({});
  const auto motion = whole.find("MOTION");
  const std::filesystem::path files[] = {
      folder.path(),
      folder.path() / "none.bvh",
      folder.write("empty.bvh", ""),
      folder.write("cut.bvh", whole.substr(0, motion / 2)),
      folder.write("random.bvh", "\x8f\x02\x11\xfe\x00\x7f"),
      folder.write("huge.bvh",
                   whole.substr(0, motion) + "MOTION\nFrames: 4000000000\nFrame Time: 0.01\n1 2 3\n")};
  for (const auto& file : files) {
    try {
      openRecording(file);
      FAIL() << file;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), HasSubstr(file.filename().string()));
    }
  }
}

std::string withoutOffsets(std::string bvh) {
  for (auto at = bvh.find("OFFSET"); at != std::string::npos; at = bvh.find("OFFSET", at + 1))
    bvh.replace(at, bvh.find('\n', at) - at, "OFFSET 0 0 0");
  return bvh;
}

TEST(Recording, BonesWithoutLengthAreNoBody) {
  const Recording r = readBvhRecording(withoutOffsets(bvhOf({})), "t.bvh", {});
  EXPECT_TRUE(r.report.mapped.empty());
  EXPECT_EQ(r.report.missing_parts.size(), 14u);
  EXPECT_THAT(r.report.person.no_body,
              HasSubstr("the ends of all 8 bones of arms and legs coincide in every frame"));
  EXPECT_THAT(r.report.warnings, Contains(HasSubstr("torso (no length), head (no length)")));
  try {
    requirePerson(r.report, "t.bvh");
    FAIL();
  } catch (const ParseError& e) {
    EXPECT_THAT(e.what(),
                HasSubstr("t.bvh: error: found a skeleton without a body, expected bones with a length"));
    EXPECT_THAT(e.what(), HasSubstr("hint: the ends of all 8 bones"));
  }
  // One bone that is lost is one part that is not moved.
  const std::string whole = bvhOf({});
  std::string elbow = whole;
  const auto at = elbow.find("OFFSET", elbow.find("JOINT LeftElbow"));
  elbow.replace(at, elbow.find('\n', at) - at, "OFFSET 0 0 0");
  const Recording one = readBvhRecording(elbow, "t.bvh", {});
  EXPECT_THAT(one.report.missing_parts, ::testing::ElementsAre("biceps_left"));
  EXPECT_THAT(one.report.warnings, Contains(HasSubstr("biceps_left (no length)")));
  EXPECT_TRUE(one.report.person.no_body.empty());
  EXPECT_TRUE(readBvhRecording(whole, "t.bvh", {}).report.person.no_body.empty());
}

TEST(Recording, OptionsWithoutEffectAreReportedOrRefused) {
  const testing::ScratchFolder folder;
  const auto bvh = folder.write("a.bvh", bvhOf({}));
  const auto csv =
      folder.write("a.csv", "t,pelvis.x,pelvis.y,pelvis.z,neck.x,neck.y,neck.z\n0,0,0,1,0,0,1.5\n");
  const auto map = folder.write("own.map", "name: own\npelvis: Hips\n");
  try {
    openRecording(bvh, {.skeleton = folder.path() / "none.asf"});
    FAIL();
  } catch (const UsageError& e) {
    EXPECT_THAT(e.what(), HasSubstr("skeleton: found a recording of the format bvh, expected amc"));
  }
  const Recording r = openRecording(csv, {.joint_map = map, .repair = false});
  EXPECT_THAT(r.report.warnings, Contains(HasSubstr("the joint map has no effect: the file has")));
  EXPECT_THAT(r.report.notes, Contains(HasSubstr("--no-repair (repair: false) has no effect")));
  EXPECT_THAT(openRecording(bvh, {.repair = false}).report.notes, Not(Contains(HasSubstr("no effect"))));
}

}  // namespace recording_test
}  // namespace abstand::tracking
