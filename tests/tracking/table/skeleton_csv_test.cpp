// The plain skeleton CSV: to the bit and back, and what it refuses.
#include "tracking/table/skeleton_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <sstream>

#include "core/base/error.hpp"
#include "humanmodel/joint_covariance.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace skeleton_csv_test {

using ::testing::HasSubstr;

TEST(SkeletonCsv, RoundTripsBitExactly) {
  Recording written;
  for (std::uint64_t i = 0; i < 20; ++i) {
    humanmodel::SkeletonFrame f;
    f.t = static_cast<double>(i) * 0.0083333;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      if ((i + j) % 7 == 0) continue;  // a gap
      f.set(static_cast<humanmodel::Joint>(j), testing::randomPose(i * 100 + j).translation(),
            j % 3 == 0 ? humanmodel::JointState::kInferred : humanmodel::JointState::kTracked);
    }
    f.p[1].z() = -0.0;
    written.frames.push_back(f);
  }
  const testing::ScratchFolder folder;
  const auto file = folder.path() / "out.csv";
  writeSkeletonCsv(file, written);
  const Recording read = openRecording(file);
  EXPECT_EQ(read.report.format, "csv");
  EXPECT_EQ(read.report.gaps, 20u);
  EXPECT_NEAR(read.report.rate, 1.0 / 0.0083333, 1e-6);
  ASSERT_EQ(read.frames.size(), written.frames.size());
  for (std::size_t i = 0; i < written.frames.size(); ++i) {
    const auto &a = written.frames[i], &b = read.frames[i];
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a.t), std::bit_cast<std::uint64_t>(b.t));
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      ASSERT_EQ(a.state[j], b.state[j]) << i << " " << j;
      for (int k = 0; k < 3 && a.state[j] != humanmodel::JointState::kMissing; ++k)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(a.p[j][k]), std::bit_cast<std::uint64_t>(b.p[j][k]));
    }
  }
}

TEST(SkeletonCsv, CovariancesRoundTripAndAreTheSpreadWithoutTheirColumns) {
  Matrix3d stated;
  stated << 0.04, 0.01, -0.002, 0.01, 0.02, 0.003, -0.002, 0.003, 0.01;
  Recording written;
  for (int i = 0; i < 3; ++i) {
    humanmodel::SkeletonFrame f;
    f.t = 0.1 * i;
    f.set(humanmodel::Joint::kNeck, {1, 2, 3});
    f.set(humanmodel::Joint::kPelvis, {1, 2, 2});
    if (i != 1) humanmodel::setCovariance(f, humanmodel::Joint::kNeck, stated);
    if (i == 1) f.spread[static_cast<std::size_t>(humanmodel::Joint::kNeck)] = 0.05;
    written.frames.push_back(f);
  }
  std::ostringstream out;
  writeSkeletonCsv(out, written);
  EXPECT_THAT(out.str(), HasSubstr("neck.spread,neck.cxx,neck.cyy,neck.czz,neck.cxy,neck.cxz,neck.cyz\n"));
  EXPECT_EQ(out.str().find("pelvis.c"), out.str().find("pelvis.confidence")) << "none for the pelvis";
  const Recording read = readSkeletonCsv(out.str(), "t.csv");
  const Recording upright = [&] {
    RecordingOptions options;
    options.up = "y";
    return readSkeletonCsv(out.str(), "t.csv", options);
  }();
  for (std::size_t i = 0; i < 3; ++i) {
    const Matrix3d expected = i == 1 ? Matrix3d(Vector3d::Constant(0.05 * 0.05).asDiagonal()) : stated;
    EXPECT_TRUE(humanmodel::covarianceOf(read.frames[i], humanmodel::Joint::kNeck).isApprox(expected, 1e-15));
    EXPECT_TRUE(humanmodel::covarianceOf(read.frames[i], humanmodel::Joint::kPelvis).isZero(0.0));
  }
  // The point turns about x from y up to z up, and its ellipsoid with it.
  const Matrix3d R = Eigen::AngleAxisd(0.5 * kPi, Vector3d::UnitX()).toRotationMatrix();
  EXPECT_TRUE(upright.frames[0][humanmodel::Joint::kNeck].isApprox(R * Vector3d(1, 2, 3), 1e-12));
  EXPECT_TRUE(humanmodel::covarianceOf(upright.frames[0], humanmodel::Joint::kNeck)
                  .isApprox(R * stated * R.transpose(), 1e-12));
}

TEST(SkeletonCsv, KeepsTheTwistOfParts) {
  const Eigen::Vector3f y = Eigen::Vector3f(0.3f, 0.9f, -0.1f).normalized();
  constexpr auto kWrist = static_cast<std::size_t>(humanmodel::Joint::kWristLeft);
  Recording written;
  for (int i = 0; i < 2; ++i) {
    humanmodel::SkeletonFrame f;
    f.t = 0.1 * i;
    f.set(humanmodel::Joint::kWristLeft, {1, 2, 3});
    f.set(humanmodel::Joint::kElbowLeft, {1, 2, 3.2});
    if (i == 0) f.lateral[kWrist] = y;
    written.frames.push_back(f);
  }
  std::ostringstream out;
  writeSkeletonCsv(out, written);
  EXPECT_THAT(out.str(), HasSubstr("wrist_left.lx,wrist_left.ly,wrist_left.lz"));
  EXPECT_EQ(out.str().find("elbow_left.l"), std::string::npos);
  const Recording read = readSkeletonCsv(out.str(), "t.csv");
  EXPECT_EQ(read.frames[0].lateral[kWrist], y) << "the same bits";
  EXPECT_TRUE(read.frames[1].lateral[kWrist].isZero(0.0f));
  const Recording upright = readSkeletonCsv(out.str(), "t.csv", {.up = "y"});
  EXPECT_LT((upright.frames[0].lateral[kWrist] - Eigen::Vector3f(y.x(), -y.z(), y.y())).norm(), 1e-6f);
  EXPECT_THROW(readSkeletonCsv("t,neck.x,neck.y,neck.z,neck.lx\n0,1,2,3,1\n", "t.csv"), ParseError);
}

TEST(SkeletonCsv, RefusesPartOfACovariance) {
  try {
    readSkeletonCsv("t,neck.x,neck.y,neck.z,neck.spread,neck.cxx\n0,1,2,3,0.1,0.01\n", "t.csv");
    FAIL();
  } catch (const ParseError& e) {
    EXPECT_THAT(e.what(), HasSubstr("found only some columns of the covariance of neck"));
  }
}

TEST(SkeletonCsv, ReadsForeignVariants) {
  const Recording r = readSkeletonCsv("t,neck.z,neck.x,neck.y\r\n0,3,1,2\r\n0.5,,,\r\n1,6,4,5", "t.csv");
  ASSERT_EQ(r.frames.size(), 3u);
  EXPECT_EQ(r.frames[0][humanmodel::Joint::kNeck], Vector3d(1, 2, 3));
  EXPECT_FALSE(r.frames[1].has(humanmodel::Joint::kNeck));
  EXPECT_FALSE(r.frames[0].has(humanmodel::Joint::kPelvis));
  EXPECT_EQ(r.report.gaps, 1u);
  EXPECT_EQ(r.report.rate, 2.0);
  EXPECT_EQ(r.report.up.axis, "z");
  const Recording turned =
      readSkeletonCsv("t,neck.x,neck.y,neck.z\n0,100,200,300\n", "t.csv", {.units = "cm", .up = "y"});
  EXPECT_LT((turned.frames[0][humanmodel::Joint::kNeck] - Vector3d(1, -3, 2)).norm(), 1e-12);
}

TEST(SkeletonCsv, RejectsBadFilesWithPosition) {
  struct Case {
    const char* text;
    int line, column;
    const char* message;
  };
  const std::string head = "t,neck.x,neck.y,neck.z\n";
  for (const Case& c :
       {Case{"x,neck.x\n", 1, 1, "expected the column 't'"},
        Case{"t,nek.x,nek.y,nek.z\n", 1, 3, "did you mean 'neck'?"},
        Case{"t,neck.x,neck.w\n", 1, 10, "expected JOINT.x, .y, .z"},
        Case{"t,neck.x,neck.x\n", 1, 10, "a second time"},
        Case{"t,neck.x,neck.y\n0,1,2\n", 1, 0, "only some columns of neck"},
        Case{"t\n0\n", 1, 0, "found no joint"}, Case{"t,neck.x,neck.y,neck.z\n", 2, 0, "found no frame"},
        Case{"t,neck.x,neck.y,neck.z\n0,1,nan,3\n", 2, 5, "found 'nan'"},
        Case{"t,neck.x,neck.y,neck.z\n0,1,1e300,3\n", 2, 5, "expected a number below 1e9"},
        Case{"t,neck.x,neck.y,neck.z\n0,1,2\n", 2, 6, "expected 4 cells"},
        Case{"t,neck.x,neck.y,neck.z\n0,1,2,3,4\n", 2, 9, "expected 4 cells"},
        Case{"t,neck.x,neck.y,neck.z\n0,1,2,3\n0,1,2,3\n", 3, 1, "expected t to rise"}}) {
    try {
      readSkeletonCsv(c.text, "t.csv");
      FAIL() << c.message;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), HasSubstr(c.message));
      EXPECT_EQ(e.pos().line, c.line) << e.what();
      EXPECT_EQ(e.pos().column, c.column) << e.what();
    }
  }
}

constexpr char kDated[] =
    "t,pelvis.x,pelvis.y,pelvis.z,neck.x,neck.y,neck.z\n"
    "1764150000.25,0,0,1,0,0,1.5\n"
    "1764150000.5,0,0,1,0,0,1.5\n";

TEST(SkeletonCsv, TimesSince1970BeginAtZero) {
  const testing::ScratchFolder folder;
  folder.write("dated.csv", kDated);
  const Recording read = openRecording(folder.path() / "dated.csv");
  EXPECT_EQ(read.clock_start, 1764150000.25);
  ASSERT_EQ(read.frames.size(), 2u);
  EXPECT_EQ(read.frames[0].t, 0.0);
  EXPECT_EQ(read.frames[1].t, 0.25);
  EXPECT_THAT(read.report.rate_reason, HasSubstr("here at 0"));
  RecordingOptions options;
  options.rate = 10.0;
  EXPECT_TRUE(std::isnan(openRecording(folder.path() / "dated.csv", options).clock_start))
      << "the user's times are not those of the clock";
}

TEST(SkeletonCsv, TimesSinceTheStartStay) {
  const testing::ScratchFolder folder;
  folder.write("plain.csv", "t,pelvis.x,pelvis.y,pelvis.z\n5.5,0,0,1\n6,0,0,1\n");
  const Recording read = openRecording(folder.path() / "plain.csv");
  EXPECT_TRUE(std::isnan(read.clock_start));
  EXPECT_EQ(read.frames[0].t, 5.5);
  EXPECT_FALSE(read.frames[0].covariance.isStated()) << "what is not stated takes no memory";
}

TEST(SkeletonCsv, MillisecondsSince1970AreRefused) {
  const testing::ScratchFolder folder;
  folder.write("ms.csv", "t,pelvis.x,pelvis.y,pelvis.z\n1764150000250,0,0,1\n");
  try {
    openRecording(folder.path() / "ms.csv");
    FAIL() << "expected an error";
  } catch (const ParseError& e) {
    EXPECT_THAT(e.what(), HasSubstr("expected seconds"));
    EXPECT_EQ(e.pos().line, 2);
  }
}

}  // namespace skeleton_csv_test
}  // namespace abstand::tracking
