// Kinect skeletons: the small forms by hand, and the real sets as their lists describe them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tracking/kinect/irds.hpp"
#include "tracking/kinect/kinect_joints.hpp"
#include "tracking/kinect/ui_prmd.hpp"
#include "tracking/kinect/utd_mhad.hpp"
#include "tracking/recording/recording.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace kinect_test {

using ::testing::HasSubstr;

const std::string kHead =
    "SubjectID,Timestamp1,Timestamp2,Timestamp3,JointName,TrackingStatus,X,Y,Z,X_proj,Y_proj\n";

PointFrame frameOf(PointReader& reader) {
  PointFrame frame;
  EXPECT_TRUE(reader.next(frame));
  return frame;
}

TEST(Irds, BothFormsGiveSameFrames) {
  const std::string table = kHead +
                            "1,7,5,100,SpineBase,Tracked,0.5,-1,2,0,0\n1,7,5,100,Head,Inferred,1,2,3,0,0\r\n"
                            "1,8,5,133,SpineBase,NotTracked,9,9,9,0,0\n";
  const std::string text =
      "Version0.1\n7,5,100,(SpineBase,Tracked,0.5,-1,2,0,0),(Head,Inferred,1,2,3,0,0)\n"
      "8,5,133,(SpineBase,NotTracked,9,9,9,0,0)\n";
  ASSERT_TRUE(looksLikeIrdsCsv(table));
  ASSERT_TRUE(looksLikeIrdsText(text));
  for (const std::string& form : {table, text}) {
    IrdsReader reader(form, "k");
    PointFrame frame = frameOf(reader);
    EXPECT_DOUBLE_EQ(frame.t, 0.1);
    EXPECT_EQ(frame.p[0], Vector3d(0.5, -1, 2));
    EXPECT_EQ(frame.p[3], Vector3d(1, 2, 3));
    EXPECT_EQ(frame.state[3], humanmodel::JointState::kInferred);
    EXPECT_EQ(frame.state[1], humanmodel::JointState::kMissing);
    frame = frameOf(reader);
    EXPECT_DOUBLE_EQ(frame.t, 0.133);
    EXPECT_EQ(frame.state[0], humanmodel::JointState::kMissing) << "a place that was not tracked is none";
    EXPECT_FALSE(reader.next(frame));
  }
}

TEST(Irds, RejectsBadFilesWithLine) {
  struct Case {
    std::string text;
    int line;
    const char* message;
  };
  const std::string good = "1,7,5,100,Head,Tracked,1,2,3,0,0\n";
  for (const Case& c :
       {Case{"JointName,TrackingStatus,X\n", 1, "no column Timestamp1"}, Case{kHead, 2, "found no frame"},
        Case{kHead + "1,7,5\n", 2, "found 3 cells, expected 11"},
        Case{kHead + "1,7,5,1.5,Head,Tracked,1,2,3,0,0\n", 2, "expected an integer"},
        Case{kHead + "1,7,5,100,Tail,Tracked,1,2,3,0,0\n", 2, "found the joint 'Tail'"},
        Case{kHead + "1,7,5,100,Head,Seen,1,2,3,0,0\n", 2, "found 'Seen'"},
        Case{kHead + "1,7,5,100,Head,Tracked,1,nan,3,0,0\n", 2, "found 'nan' for Head"},
        Case{kHead + good + good, 3, "found Head a second time"},
        Case{kHead + good + "1,8,5,99,Head,Tracked,1,2,3,0,0\n", 3, "expected it to rise"},
        Case{"Version0.1\n7,5,100\n", 2, "found 3 cells"},
        Case{"Version0.1\n7,5,1,Head,Tracked,1,2,3,0,0\n", 2, "found 'Head'"},
        Case{"Version0.1\n", 2, "found no frame"}}) {
    try {
      IrdsReader reader(c.text, "k");
      for (PointFrame frame; reader.next(frame);) {
      }
      FAIL() << c.message;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), HasSubstr(c.message));
      EXPECT_EQ(e.pos().line, c.line) << e.what();
    }
  }
}

/// 66 numbers: every joint one unit above its parent, all angles zero but that of `turned` about `axis`.
std::string row(int turned, int axis, bool places) {
  std::string s;
  for (int i = 0; i < 66; ++i) {
    const bool one = places ? i % 3 == 1 && i > 0 : i == 3 * turned + axis;
    s += (i > 0 ? "," : "") + std::string(one ? (places ? "1" : "90") : "0");
  }
  return s + "\n";
}

TEST(UiPrmd, PositionsFollowParentAngles) {
  ASSERT_TRUE(looksLikeUiPrmd(row(0, 0, true)));
  EXPECT_FALSE(looksLikeUiPrmd("1,2,3\n"));
  // A quarter turn of the waist about z takes what stands above it to -x; about x to +z.
  const std::string places = row(0, 0, true) + row(0, 0, true), angles = row(0, 2, false) + row(0, 0, false);
  UiPrmdReader reader(places, "p", angles, "a");
  PointFrame frame = frameOf(reader);
  EXPECT_LT((frame.p[1] - Vector3d(-1, 1, 0)).norm(), 1e-12) << "the waist itself lies at (0, 1, 0)";
  EXPECT_LT((frame.p[2] - Vector3d(-2, 1, 0)).norm(), 1e-12);
  frame = frameOf(reader);
  EXPECT_LT((frame.p[1] - Vector3d(0, 1, 1)).norm(), 1e-12);
  EXPECT_DOUBLE_EQ(frame.t, 1.0 / 30.0);
  EXPECT_FALSE(reader.next(frame));

  const std::string shorter = row(0, 2, false);
  UiPrmdReader unequal(places, "p", shorter, "a");
  frameOf(unequal);
  EXPECT_THROW(unequal.next(frame), ParseError);
}

TEST(UiPrmd, FindsPartnerFile) {
  const testing::ScratchFolder folder;
  const auto places = folder.write("m01_positions.txt", row(0, 0, true));
  EXPECT_THROW(uiPrmdPartner(places), ParseError);
  const auto angles = folder.write("m01_angles.txt", row(0, 0, false));
  EXPECT_EQ(uiPrmdPartner(places), angles);
  EXPECT_EQ(uiPrmdPartner(angles), places);
  EXPECT_THROW(uiPrmdPartner(folder.write("m01.txt", row(0, 0, true))), ParseError);
}

TEST(Kinect, ParentsComeFirst) {
  const auto parents = uiPrmdParents();
  for (std::size_t i = 0; i < parents.size(); ++i) EXPECT_LT(parents[i], static_cast<int>(i));
  EXPECT_EQ(parents.size(), uiPrmdJoints().size());
}

TEST(UtdMhad, RejectsOtherFiles) {
  EXPECT_THROW(UtdMhadReader("MATLAB 5.0 MAT-file, cut", "a.mat"), ParseError);
  EXPECT_THROW(UtdMhadReader("MATLAB 7.3 MAT-file", "b.mat"), ParseError);
  struct Case {
    const char* file;
    const char* message;
  };
  for (const Case& c : {Case{"plain", ""}, Case{"packed", ""}, Case{"single", ""}, Case{"one", ""},
                        Case{"depth", "found 'd_depth' (2 x 3 x 2), expected d_skel"},
                        Case{"claims", "found 120 numbers, expected 20 x 3 x 2000000000"}}) {
    const std::string bytes = readFile(testing::projectFile(std::string("tests/fuzz/corpus/mat/") + c.file));
    try {
      UtdMhadReader reader(bytes, c.file);
      EXPECT_STREQ(c.message, "") << c.file;
      PointFrame frame = frameOf(reader);  // value i of the file is 0.01 i, column by column
      EXPECT_LT((frame.p[3] - Vector3d(0.03, 0.23, 0.43)).norm(), 1e-6) << c.file;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), HasSubstr(c.message)) << c.file;
      EXPECT_STRNE(c.message, "") << e.what();
    }
  }
}

struct Capture {
  const char* file;
  const char* format;
  std::size_t frames;
  const char* units;
};
void PrintTo(const Capture& c, std::ostream* out) { *out << c.file; }

const Capture kCaptures[] = {{"kinect/irds_kinect_v2/215_18_0_1_1_stand.csv", "kinect-v2-csv", 31, "m"},
                             {"kinect/irds_kinect_v2/215_18_0_1_1_stand.txt", "kinect-v2-txt", 31, "m"},
                             {"kinect/irds_kinect_v2/217_18_0_1_1_wheelchair.csv", "kinect-v2-csv", 60, "m"},
                             {"kinect/irds_kinect_v2/217_18_2_3_1_wheelchair.csv", "kinect-v2-csv", 83, "m"},
                             {"kinect/uiprmd_kinect_v2/m05_s01_e01_positions.txt", "ui-prmd", 80, "cm"},
                             {"kinect/uiprmd_kinect_v2/m07_s01_e01_angles.txt", "ui-prmd", 63, "cm"},
                             {"depth/utd_mhad/a18_s1_t1_skeleton.mat", "utd-mhad", 65, "m"},
                             {"depth/utd_mhad/a25_s3_t1_skeleton.mat", "utd-mhad", 60, "m"},
                             {"depth/utd_mhad/a18_s1_t1/skeleton.csv", "csv", 65, "m"}};

class RealKinect : public ::testing::TestWithParam<Capture> {};

TEST_P(RealKinect, IsReadAsPerson) {
  const auto file = testing::sharedData(GetParam().file);
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  const Recording r = openRecording(file);
  EXPECT_EQ(r.report.format, GetParam().format);
  EXPECT_EQ(r.frames.size(), GetParam().frames);
  EXPECT_NEAR(r.report.rate, 30.0, 1.0) << "from whole milliseconds";
  EXPECT_EQ(r.report.units.name, GetParam().units);
  EXPECT_EQ(r.report.up.axis, "y");
  EXPECT_EQ(r.report.mapped.size(), 14u);
  EXPECT_EQ(r.report.sides.found, "agree");
  EXPECT_GE(r.report.stature, 1.4);
  EXPECT_LE(r.report.stature, 2.1);
  EXPECT_EQ(r.frames.front().t, 0.0);
  for (const auto& f : r.frames)
    EXPECT_GT(f[humanmodel::Joint::kHeadTop].z(), f[humanmodel::Joint::kPelvis].z() + 0.3);
}

INSTANTIATE_TEST_SUITE_P(Files, RealKinect, ::testing::ValuesIn(kCaptures), [](const auto& i) {
  std::string name = i.param.file;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

// 99 % of an isotropic error whose mean length is that published for the sensor.
TEST(RealKinect, JointsHaveThePublishedErrorOfTheSensor) {
  for (const char* file :
       {"kinect/irds_kinect_v2/217_18_2_3_1_wheelchair.csv", "depth/utd_mhad/a18_s1_t1_skeleton.mat",
        "kinect/uiprmd_kinect_v2/m05_s01_e01_positions.txt"}) {
    const auto path = testing::sharedData(file);
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path;
    std::size_t tracked = 0, inferred = 0;
    for (const humanmodel::SkeletonFrame& frame : openRecording(path).frames)
      for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
        if (frame.state[j] == humanmodel::JointState::kTracked) {
          ++tracked;
          EXPECT_NEAR(frame.spread[j], 0.10 / std::sqrt(8.0 / kPi), 1e-9);
        } else if (frame.state[j] == humanmodel::JointState::kInferred) {
          ++inferred;
          EXPECT_NEAR(frame.spread[j], std::hypot(0.10, 0.10) / std::sqrt(8.0 / kPi), 1e-9);
        }
      }
    EXPECT_GT(tracked, 0u) << file;
    EXPECT_GT(inferred, 0u) << file << ": at least the vertex is derived";
  }
}

// Two files of the same take, written by different hands.
TEST(RealKinect, TakesAgree) {
  const auto csv = testing::sharedData("kinect/irds_kinect_v2/215_18_0_1_1_stand.csv"),
             mat = testing::sharedData("depth/utd_mhad/a18_s1_t1_skeleton.mat");
  if (!std::filesystem::exists(csv)) GTEST_SKIP() << csv;
  const auto largest = [](const Recording& a, const Recording& b) {
    double d = 0.0;
    for (std::size_t i = 0; i < a.frames.size(); ++i)
      for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
        if (a.frames[i].has(static_cast<humanmodel::Joint>(j)))
          d = std::max(d, (a.frames[i].p[j] - b.frames[i].p[j]).norm());
    return d;
  };
  const Recording a = openRecording(csv),
                  b = openRecording(testing::sharedData("kinect/irds_kinect_v2/215_18_0_1_1_stand.txt"));
  EXPECT_EQ(largest(a, b), 0.0);
  const Recording c = openRecording(mat),
                  d = openRecording(testing::sharedData("depth/utd_mhad/a18_s1_t1/skeleton.csv"));
  EXPECT_LT(largest(c, d), 2e-6) << "the CSV has six digits";
  EXPECT_THROW(openRecording(testing::sharedData("depth/utd_mhad/a18_s1_t1_depth.mat")), ParseError);
}

}  // namespace kinect_test
}  // namespace abstand::tracking
