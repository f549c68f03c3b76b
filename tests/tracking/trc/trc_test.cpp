// TRC: gaps and the forms of its head by hand, the real files as their list describes them.
#include "tracking/trc/trc_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "tests/support/paths.hpp"
#include "tracking/recording/recording.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace trc_test {

using ::testing::Contains;
using ::testing::HasSubstr;

std::string trc(const std::string& rows, const std::string& names = "A\t\t\tB B\t\t",
                const std::string& markers = "2") {
  return "PathFileType\t4\t(X/Y/Z)\tt.trc\nDataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\n50\t50\t  "
         "2\t" +
         markers + "\tmm\nFrame#\tTime\t" + names + "\n\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n\n" + rows;
}

const std::string kRows = "1\t0.5\t1\t2\t3\t\t\t\n2\t0.52\tNaN\tNAN\tnan\t4\t5\t6\t\r\n";

TEST(Trc, ReadsMarkersAndGaps) {
  ASSERT_TRUE(looksLikeTrc(trc(kRows)));
  for (const char* names : {"A\t\t\tB B\t\t", "\tA\t\tB B", "A\tB B"}) {
    const std::string text = trc(kRows, names);
    TrcReader reader(text, "t.trc");
    EXPECT_THAT(reader.names(), ::testing::ElementsAre("A", "B B"));
    EXPECT_EQ(reader.facts().rate, 50.0);
    EXPECT_EQ(reader.facts().unit->scale, 0.001);
    PointFrame f;
    ASSERT_TRUE(reader.next(f));
    EXPECT_EQ(f.p[0], Vector3d(1, 2, 3));
    EXPECT_EQ(f.state[1], humanmodel::JointState::kMissing);
    ASSERT_TRUE(reader.next(f));
    EXPECT_EQ(f.t, 0.52);
    EXPECT_EQ(f.state[0], humanmodel::JointState::kMissing);
    EXPECT_EQ(f.p[1], Vector3d(4, 5, 6));
    EXPECT_FALSE(reader.next(f));
    EXPECT_TRUE(reader.warnings().empty());
  }
}

TEST(Trc, ReportsDifferencesFromHeader) {
  const std::string text = trc("1\t0\t1\t2\t3\t4\n", "A\t\t\tB", "3");
  TrcReader reader(text, "t.trc");
  PointFrame f;
  ASSERT_TRUE(reader.next(f));
  EXPECT_EQ(f.state[1], humanmodel::JointState::kMissing);
  EXPECT_FALSE(reader.next(f));
  ASSERT_EQ(reader.warnings().size(), 3u);
  EXPECT_THAT(reader.warnings()[0].text, HasSubstr("claims 3 markers, found 2"));
  EXPECT_THAT(reader.warnings()[1].text, HasSubstr("claims 2 frames, found 1"));
  EXPECT_THAT(reader.warnings()[2].text, HasSubstr("rows end early"));
}

TEST(Trc, WarnsOfMissingValueAndExtraMarker) {
  // Of the second row a value is missing, nobody knows which; the third has three values behind the named
  // markers.
  const std::string text =
      trc("1\t0\t1\t2\t3\t4\t5\t6\n2\t1\t1\t2\t3\t4\t5\n3\t2\t1\t2\t3\t4\t5\t6\t7\t8\t9\n");
  TrcReader reader(text, "t.trc");
  PointFrame f;
  ASSERT_TRUE(reader.next(f));
  ASSERT_TRUE(reader.next(f));
  EXPECT_EQ(f.state[0], humanmodel::JointState::kMissing);
  EXPECT_EQ(f.state[1], humanmodel::JointState::kMissing);
  ASSERT_TRUE(reader.next(f));
  EXPECT_EQ(f.p[0], Vector3d(1, 2, 3));
  EXPECT_EQ(f.p[1], Vector3d(4, 5, 6));
  EXPECT_FALSE(reader.next(f));
  ASSERT_EQ(reader.warnings().size(), 3u);  // with the claim of two frames
  EXPECT_EQ(reader.warnings()[1].line, 8);
  EXPECT_THAT(reader.warnings()[1].text, HasSubstr("within a marker"));
  EXPECT_EQ(reader.warnings()[2].line, 9);
  EXPECT_THAT(reader.warnings()[2].text, HasSubstr("more markers"));
}

TEST(Trc, RejectsBadFilesWithLine) {
  struct Case {
    std::string text;
    int line;
    const char* message;
  };
  for (const Case& c :
       {Case{"PathFileType\t4\n", 2, "expected DataRate"}, Case{trc("", "\t\t"), 4, "found no marker"},
        Case{trc(""), 7, "found no frame"}, Case{trc("1\t0\tx\t2\t3\n"), 7, "found 'x'"},
        Case{trc("1\t0\t1\t2\t3\t4\t5\t6\t7\n"), 7, "found '7'"},
        Case{trc("1\t0\t1\t2\t3\n2\t0\t1\t2\t3\n"), 8, "expected it to rise"},
        Case{trc(kRows, "A", "many"), 3, "found 'many' for NumMarkers"}}) {
    try {
      TrcReader reader(c.text, "t.trc");
      for (PointFrame f; reader.next(f);) {
      }
      FAIL() << c.message;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), HasSubstr(c.message));
      EXPECT_EQ(e.pos().line, c.line) << e.what();
    }
  }
}

struct Capture {
  const char* file;
  std::size_t markers, frames;
  double rate;
  const char* units;
  std::size_t parts;  ///< that the shipped marker map can move
};

TEST(Trc, ReadsRealFiles) {
  for (const Capture& c : {Capture{"opensim_dataWithBlanksForMissingMarkers.trc", 40, 464, 250, "mm", 0},
                           Capture{"opensim_dataWithNaNsOfDifferentCases.trc", 14, 5, 250, "mm", 0},
                           Capture{"opensim_exampleFormat.trc", 3, 5, 100, "m", 0},
                           Capture{"opensim_gait10_walk.trc", 41, 10, 60, "mm", 0},
                           Capture{"opensim_std_walking2_markers.trc", 44, 126, 250, "mm", 0},
                           Capture{"motek/T.trc", 41, 89, 30, "mm", 14},
                           Capture{"motek/ballet_reduced.trc", 41, 100, 30, "mm", 14}}) {
    const auto file = testing::sharedData(std::string("mocap/trc/") + c.file);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    const Recording r = openRecording(file);
    EXPECT_EQ(r.report.format, "trc") << c.file;
    EXPECT_EQ(r.report.joints.size(), c.markers) << c.file;
    EXPECT_EQ(r.frames.size(), c.frames) << c.file;
    EXPECT_EQ(r.report.rate, c.rate) << c.file;
    EXPECT_EQ(r.report.units.name, c.units) << c.file;
    EXPECT_GE(r.report.mapped.size(), c.parts) << c.file;
    if (!r.report.markers.set.empty()) continue;  // solved: its joints are centres
    EXPECT_THAT(r.report.warnings, Contains(::testing::AnyOf(HasSubstr("midpoints of skin markers"),
                                                             HasSubstr("no joint map yields a body part"))))
        << c.file;
  }
}

// Motek's dancer in a T-pose: the marker map makes a standing body of plausible measures.
TEST(Trc, MarkersGivePlausibleBody) {
  const auto file = testing::sharedData("mocap/trc/motek/T.trc");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  const Recording r = openRecording(file);
  EXPECT_EQ(r.report.up.axis, "y");
  EXPECT_EQ(r.report.sides.found, "agree");
  EXPECT_GT(r.report.stature, 1.4);
  EXPECT_LT(r.report.stature, 2.1);
  const humanmodel::SkeletonFrame& f = r.frames[40];
  EXPECT_NEAR(f[humanmodel::Joint::kWristLeft].z(), f[humanmodel::Joint::kShoulderLeft].z(), 0.25)
      << "arms out";
  EXPECT_GT((f[humanmodel::Joint::kWristLeft] - f[humanmodel::Joint::kWristRight]).norm(), 1.0);
}

}  // namespace trc_test
}  // namespace abstand::tracking
