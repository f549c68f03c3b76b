// Acclaim files: kinematics against closed forms and against BVH of the same motion, and what is refused.
#include "tracking/acclaim/acclaim_recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "tests/support/paths.hpp"
#include "tracking/bvh/bvh_recording.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace acclaim_test {

using ::testing::Contains;
using ::testing::HasSubstr;

constexpr double kRounding = 1e-12;  // of lengths of some units through some turns

/// An arm of two bones along x; the second one's own axes are turned by 90 degrees about z.
const std::string kArm =
    ":version 1.10\n:name arm\n:units\n  mass 1.0\n  length 0.45\n  angle deg\n:documentation\n   begin of "
    "nothing\n"
    ":root\n  order TX TY TZ RX RY RZ\n  axis XYZ\n  position 0 0 0\n  orientation 0 0 0\n:bonedata\n"
    "  begin\n    id 1\n    name upper\n    direction 1 0 0\n    length 2\n    axis 0 0 0 XYZ\n    dof rx ry "
    "rz\n"
    "    limits (-1 1)\n           (-2 2)\n  end\n"
    "  begin\n    id 2\n    name fore # a remark\n    direction 1 0 0\n    length 1\n    axis 0 0 90 XYZ\n   "
    " dof rx\n  end\n"
    ":hierarchy\n  begin\n    root upper\n    upper fore\n  end\n";
const std::string kMotion =
    "#!OML:ASF F:\\somewhere\\arm.ASF\n:FULLY-SPECIFIED\n:DEGREES\n1\nroot 0 0 0 0 0 0\nupper 0 0 0\nfore 0\n"
    "2\nroot 1 2 3 0 0 90\nfore 90\nupper 0 0 0\n";

std::vector<PointFrame> framesOf(PointReader& reader) {
  std::vector<PointFrame> frames;
  for (PointFrame f; reader.next(f);) frames.push_back(f);
  return frames;
}

TEST(Acclaim, BonesRotateInTheirOwnAxes) {
  ASSERT_TRUE(looksLikeAsf(kArm));
  ASSERT_TRUE(looksLikeAmc(kMotion));
  EXPECT_FALSE(looksLikeAmc(kArm));
  AcclaimPoints reader(kArm, "a.asf", kMotion, "a.amc");
  EXPECT_THAT(reader.names(), ::testing::ElementsAre("root", "upper", "fore", "fore/end"));
  EXPECT_EQ(reader.facts().unit->name, "cmu");
  const auto frames = framesOf(reader);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_LT((frames[0].p[3] - Vector3d(3, 0, 0)).norm(), kRounding);
  // The root at (1, 2, 3) turned by 90 degrees about z: the elbow lies 2 along y. The fore bone's own x is y
  // of the rest pose: a turn of 90 degrees about it takes x to -z.
  EXPECT_LT((frames[1].p[2] - Vector3d(1, 4, 3)).norm(), kRounding);
  EXPECT_LT((frames[1].p[3] - Vector3d(1, 4, 2)).norm(), kRounding);
  EXPECT_DOUBLE_EQ(frames[1].t, 1.0 / 120.0);
}

TEST(Acclaim, RotationOrderUsesFixedAxes) {
  const Vector3d quarter(0.5 * kPi, 0.5 * kPi, 0.0);
  EXPECT_LT((fixedAxesRotation(quarter, "xyz") * Vector3d::UnitY() - Vector3d::UnitX()).norm(), kRounding)
      << "y to z by the first turn, z to x by the second";
  EXPECT_LT((fixedAxesRotation(quarter, "yxz") * Vector3d::UnitY() - Vector3d::UnitZ()).norm(), kRounding)
      << "y stays, then to z";
}

// The same tree and the same angles as BVH, whose order Zrotation Yrotation Xrotation is R = Rz Ry Rx.
TEST(Acclaim, MatchesBvhOfSameMotion) {
  std::string asf = kArm;
  asf.replace(asf.find("axis 0 0 90"), 11, "axis 0 0 0 ");
  asf.replace(asf.rfind("dof rx"), 6, "dof rx ry rz");
  std::string amc = ":FULLY-SPECIFIED\n:DEGREES\n",
              bvh =
                  "HIERARCHY\nROOT root\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation "
                  "Yrotation Xrotation\nJOINT upper\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Yrotation "
                  "Xrotation\nJOINT fore\n{\nOFFSET 2 0 0\nCHANNELS 3 Zrotation Yrotation Xrotation\nEnd "
                  "Site\n{\nOFFSET 1 0 0\n}\n}\n}\n}\nMOTION\nFrames: 20\nFrame Time: 0.0083333333\n";
  for (int i = 0; i < 20; ++i) {
    const auto n = [&](int k) { return formatDouble(std::sin(1.0 + 0.7 * i + 1.3 * k) * 170.0); };
    amc += std::to_string(i + 1) + "\nroot " + n(0) + " " + n(1) + " " + n(2) + " " + n(3) + " " + n(4) +
           " " + n(5) + "\nupper " + n(6) + " " + n(7) + " " + n(8) + "\nfore " + n(9) + " " + n(10) + " " +
           n(11) + "\n";
    bvh += n(0) + " " + n(1) + " " + n(2) + " " + n(5) + " " + n(4) + " " + n(3) + " " + n(8) + " " + n(7) +
           " " + n(6) + " " + n(11) + " " + n(10) + " " + n(9) + "\n";
  }
  AcclaimPoints a(asf, "a.asf", amc, "a.amc");
  BvhPoints b(bvh, "b.bvh");
  const auto of_a = framesOf(a), of_b = framesOf(b);
  ASSERT_EQ(of_a.size(), 20u);
  ASSERT_EQ(of_b.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_LT((of_a[i].p[k] - of_b[i].p[k]).norm(), 1e-10) << i << " " << k;
}

TEST(Acclaim, RejectsBadFilesWithLine) {
  struct Case {
    std::string asf, amc;
    const char* file;
    int line;
    const char* message;
  };
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  for (const Case& c :
       {Case{with(kArm, "length 2", "length two"), kMotion, "a.asf", 19, "found 'two'"},
        Case{with(kArm, "dof rx ry rz", "dof rx ry rx"), kMotion, "a.asf", 21, "a second time"},
        Case{with(kArm, "dof rx ry rz", "dof tx"), kMotion, "a.asf", 21, "expected rx, ry or rz"},
        Case{with(kArm, "upper fore", "upper four"), kMotion, "a.asf", 36, "found 'four'"},
        Case{with(kArm, "upper fore\n", "\n"), kMotion, "a.asf", 37, "not connected to the root"},
        Case{with(kArm, "root upper", "upper upper"), kMotion, "a.asf", 37, "not connected to the root"},
        Case{with(kArm, "name fore", "name upper"), kMotion, "a.asf", 32, "a second time"},
        Case{kArm, with(kMotion, "upper 0 0 0", "upper 0 0"), "a.amc", 6,
             "found 2 numbers for 'upper', expected 3"},
        Case{kArm, with(kMotion, "fore 0\n", "leg 0\n"), "a.amc", 7, "found the bone 'leg'"},
        Case{kArm, with(kMotion, "fore 0\n", ""), "a.amc", 4, "2 of 3 bones"},
        Case{kArm, with(kMotion, "fore 0\n", "fore x\n"), "a.amc", 7, "found 'x'"},
        Case{kArm, ":DEGREES\n", "a.amc", 2, "found no frame"},
        Case{":version 1.1\n:bonedata\n", kMotion, "a.asf", 2, "found no bone"}}) {
    try {
      AcclaimPoints reader(c.asf, "a.asf", c.amc, "a.amc");
      framesOf(reader);
      FAIL() << c.message;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), HasSubstr(c.message));
      EXPECT_EQ(e.pos().file, c.file) << e.what();
      EXPECT_EQ(e.pos().line, c.line) << e.what();
    }
  }
}

TEST(Acclaim, DropsTruncatedFrame) {
  for (const std::size_t cut : {2u, 8u, 20u, 31u}) {
    const std::string amc = kMotion.substr(0, kMotion.size() - cut);
    AcclaimPoints reader(kArm, "a.asf", amc, "a.amc");
    EXPECT_EQ(framesOf(reader).size(), 1u) << cut;
    ASSERT_EQ(reader.warnings().size(), 1u) << cut;
    EXPECT_THAT(reader.warnings()[0].text, HasSubstr("the last frame is truncated"));
  }
}

TEST(Acclaim, FindsSkeletonOfMotion) {
  const testing::ScratchFolder folder;
  const auto amc = folder.write("11_01.amc", kMotion);
  EXPECT_THROW(findAsf(amc, {}), ParseError);
  const auto other = folder.write("other.asf", kArm);
  EXPECT_EQ(findAsf(amc, {}), other) << "the only one";
  folder.write("1.asf", kArm);
  const auto own = folder.write("11.asf", kArm);
  EXPECT_EQ(findAsf(amc, {}), own) << "the longest begin of the name";
  EXPECT_EQ(findAsf(amc, other), other);
}

TEST(Acclaim, ReadsCmuCapture) {
  const auto amc = testing::sharedData("mocap/asfamc/11_01.amc");
  if (!std::filesystem::exists(amc)) GTEST_SKIP() << amc;
  const Recording r = openRecording(amc);
  EXPECT_EQ(r.report.format, "amc");
  EXPECT_EQ(r.frames.size(), 597u);
  EXPECT_EQ(r.report.units.name, "cmu");
  EXPECT_EQ(r.report.up.axis, "y");
  EXPECT_EQ(r.report.sides.found, "agree");
  EXPECT_EQ(r.report.mapped.size(), 14u);
  EXPECT_EQ(r.report.joint_map, "CMU, Acclaim names");
  EXPECT_GT(r.report.stature, 1.4);
  EXPECT_THAT(r.report.notes, Contains(HasSubstr("11.asf")));
  // Bones keep their lengths, knees bend backwards, and the lower foot of a walk stays near the floor.
  const double thigh = 7.33161 * 0.0254 / 0.45;
  for (const humanmodel::SkeletonFrame& f : r.frames) {
    ASSERT_NEAR((f[humanmodel::Joint::kKneeLeft] - f[humanmodel::Joint::kHipLeft]).norm(), thigh, 1e-9);
    EXPECT_LT(std::min(f[humanmodel::Joint::kToeLeft].z(), f[humanmodel::Joint::kToeRight].z()), 0.2);
    EXPECT_GT(f[humanmodel::Joint::kHeadTop].z(), f[humanmodel::Joint::kPelvis].z() + 0.4);
  }
  const Recording rest = openRecording(testing::sharedData("mocap/asfamc/11.asf"));
  EXPECT_EQ(rest.frames.size(), 1u);
  EXPECT_NEAR(rest.report.stature, r.report.stature, 0.05);
}

// CMU published the same captures as BVH; another person of the data base must have the same
// measures, to 0.07 of the stature: each skeleton was fitted to its own markers.
TEST(Acclaim, MatchesCmuBvh) {
  const auto amc = testing::sharedData("mocap/asfamc/11_01.amc"),
             bvh = testing::sharedData("mocap/bvh/cmu_12_01_walk_motionbuilder.bvh");
  if (!std::filesystem::exists(amc)) GTEST_SKIP() << amc;
  const Recording a = openRecording(amc), b = openRecording(bvh);
  EXPECT_EQ(a.report.units.name, b.report.units.name);
  EXPECT_EQ(a.report.up.axis, b.report.up.axis);
  EXPECT_NEAR(a.report.rate, b.report.rate, 0.01);
  EXPECT_NEAR(a.report.stature, b.report.stature, 0.25) << "two people";
  const auto share = [](const Recording& r, humanmodel::Joint i, humanmodel::Joint j) {
    return (r.frames[100][i] - r.frames[100][j]).norm() / r.report.stature;
  };
  for (const auto& [i, j] : {std::pair{humanmodel::Joint::kHipLeft, humanmodel::Joint::kKneeLeft},
                             {humanmodel::Joint::kKneeLeft, humanmodel::Joint::kAnkleLeft},
                             {humanmodel::Joint::kShoulderLeft, humanmodel::Joint::kElbowLeft},
                             {humanmodel::Joint::kElbowLeft, humanmodel::Joint::kWristLeft},
                             {humanmodel::Joint::kPelvis, humanmodel::Joint::kNeck},
                             {humanmodel::Joint::kShoulderLeft, humanmodel::Joint::kShoulderRight}})
    EXPECT_NEAR(share(a, i, j), share(b, i, j), 0.07)
        << humanmodel::jointName(i) << " to " << humanmodel::jointName(j);
}

}  // namespace acclaim_test
}  // namespace abstand::tracking
