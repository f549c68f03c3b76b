// T-poses before a movement are named, and nothing else is.
#include "tracking/recording/first_pose.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "core/base/text_file.hpp"
#include "humanmodel/human_model.hpp"
#include "tests/support/paths.hpp"
#include "tracking/bvh/bvh_recording.hpp"
#include "tracking/recording/recording.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace first_pose_test {

using humanmodel::Joint;
using humanmodel::SkeletonFrame;
using ::testing::Contains;
using ::testing::HasSubstr;

/// The standing model with its arms raised sideways by `angle` from hanging, rad.
SkeletonFrame raised(double angle) {
  SkeletonFrame f = humanmodel::makeHuman({}).rest;
  for (const double side : {1.0, -1.0}) {
    const auto at = [&](Joint left) {
      return static_cast<Joint>(static_cast<int>(left) + (side > 0 ? 0 : 4));
    };
    const Vector3d along(0.0, side * std::sin(angle), -std::cos(angle));
    f.set(at(Joint::kElbowLeft), f[at(Joint::kShoulderLeft)] + 0.3 * along);
    f.set(at(Joint::kWristLeft), f[at(Joint::kShoulderLeft)] + 0.55 * along);
  }
  return f;
}

constexpr double kT = 0.5 * kPi, kHanging = 0.1;

/// Arms raised by these angles, at a rate in Hz.
std::vector<SkeletonFrame> at(double rate, const std::vector<double>& angles) {
  std::vector<SkeletonFrame> frames;
  for (const double angle : angles) {
    frames.push_back(raised(angle));
    frames.back().t = static_cast<double>(frames.size() - 1) / rate;
  }
  return frames;
}

/// `held` frames of T-pose, a straight blend to hanging arms over `blend` steps, and half a second of rest.
std::vector<SkeletonFrame> added(double rate, int held, int blend) {
  std::vector<double> angles(static_cast<std::size_t>(held), kT);
  for (int i = 1; i <= blend; ++i) angles.push_back(kT + (kHanging - kT) * i / blend);
  angles.insert(angles.end(), static_cast<std::size_t>(0.5 * rate) + 2, kHanging);
  return at(rate, angles);
}

/// Arms that are lowered within `seconds` without a jerk, after `rest` seconds in the T-pose.
std::vector<SkeletonFrame> lowered(double rate, double rest, double seconds) {
  std::vector<double> angles;
  for (double t = 0.0; t < rest + seconds + 0.3; t += 1.0 / rate) {
    const double s = std::clamp((t - rest) / seconds, 0.0, 1.0);
    angles.push_back(kT + (kHanging - kT) * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s));
  }
  return at(rate, angles);
}

TEST(FirstPose, AddedTPoseIsFoundWithItsLength) {
  for (const double rate : {24.0, 30.0, 60.0, 120.0})
    for (const int held : {1, 2, 10, 50})
      for (const int blend : {1, 2, 4}) {
        const auto pose = leadingTPose(added(rate, held, blend));
        ASSERT_TRUE(pose) << rate << " " << held << " " << blend;
        EXPECT_EQ(pose->frames, static_cast<std::size_t>(held)) << rate << " " << blend;
        EXPECT_EQ(pose->steps, static_cast<std::size_t>(blend)) << rate << " " << held;
        EXPECT_NEAR(pose->seconds, blend / rate, 1e-9);
        EXPECT_NEAR(pose->turned, kT - kHanging, 1e-6);
      }
  EXPECT_EQ(
      warningOf({1, 1, 0.01, kT}),
      "the first frame is a T-pose; an arm turns by 90 degrees in the next frame (0.010 s), faster than a "
      "person can: a program added the pose, and its arms are not the person's");
  EXPECT_THAT(
      warningOf({10, 4, 0.04, kT}),
      HasSubstr("frames 1 to 10 are a T-pose; an arm turns by 90 degrees in the next 4 frames (0.040 s)"));
}

TEST(FirstPose, PersonWhoHoldsArmsAsideIsNotNamed) {
  for (const double rate : {10.0, 15.0, 30.0, 60.0, 120.0})
    for (const double rest : {0.0, 0.5, 3.0})
      for (const double seconds : {0.4, 0.6, 1.0, 3.0})
        EXPECT_FALSE(leadingTPose(lowered(rate, rest, seconds))) << rate << " " << rest << " " << seconds;
  // A recording that begins within a swing of 8 rad/s.
  EXPECT_FALSE(leadingTPose(at(30.0, {kT - 0.2, kT - 0.47, kT - 0.73, kT - 1.0, kT - 1.2, kHanging})));
  EXPECT_FALSE(leadingTPose(at(30.0, std::vector<double>(100, kT)))) << "it never ends";
}

TEST(FirstPose, OtherPosesAreNotNamed) {
  const SkeletonFrame t = raised(kT), hanging = raised(kHanging);
  EXPECT_TRUE(leadingTPose(at(100.0, {kT, kHanging, kHanging})));
  EXPECT_FALSE(leadingTPose(at(100.0, {kT, 0.47 * kPi}))) << "a movement that begins so";
  EXPECT_FALSE(leadingTPose(at(100.0, {kHanging, kT})));
  EXPECT_FALSE(leadingTPose(at(100.0, {0.3 * kPi, kHanging}))) << "an A-pose";
  EXPECT_FALSE(leadingTPose(std::vector{t}));
  EXPECT_FALSE(leadingTPose({}));
  SkeletonFrame bent = t;
  bent.set(Joint::kAnkleLeft, bent[Joint::kKneeLeft] + Vector3d(-0.4, 0.0, 0.0));
  EXPECT_FALSE(leadingTPose(std::vector{bent, hanging}));
  EXPECT_FALSE(leadingTPose(std::vector{SkeletonFrame{}, hanging}));
}

/// `frame` with legs that lean by `thigh` and `calf` (rad off vertical) to their sides.
SkeletonFrame astride(SkeletonFrame frame, double thigh, double calf) {
  for (const double side : {1.0, -1.0}) {
    const auto at = [&](Joint left) {
      return static_cast<Joint>(static_cast<int>(left) + (side > 0 ? 0 : 4));
    };
    const auto leaning = [&](double angle) {
      return Vector3d(0.0, side * std::sin(angle), -std::cos(angle));
    };
    frame.set(at(Joint::kKneeLeft), frame[at(Joint::kHipLeft)] + 0.42 * leaning(thigh));
    frame.set(at(Joint::kAnkleLeft), frame[at(Joint::kKneeLeft)] + 0.42 * leaning(calf));
  }
  return frame;
}

TEST(FirstPose, LegsMayLeanIfKneesAreExactlyStraight) {
  constexpr double kDegree = kPi / 180.0;
  const auto named = [](double thigh, double calf) {
    std::vector<SkeletonFrame> frames = at(100.0, {kT, kT, kHanging, kHanging});
    for (auto& f : frames) f = astride(f, thigh * kDegree, calf * kDegree);
    return leadingTPose(frames).has_value();
  };
  EXPECT_TRUE(named(20.0, 20.0));
  EXPECT_TRUE(named(20.0, 10.0));
  EXPECT_TRUE(named(30.0, 30.0));
  EXPECT_TRUE(named(42.0, 41.0));
  EXPECT_FALSE(named(30.0, 25.0)) << "the bent knees of a person";
  EXPECT_FALSE(named(50.0, 50.0)) << "a split";
}

/// The BVH file with its rest pose, where the root is, before the motion.
std::string withRestPose(const std::string& bvh) {
  const auto begin = bvh.find('\n', bvh.find("Frame Time:")) + 1;
  std::istringstream values(bvh.substr(begin, bvh.find('\n', begin) - begin));
  std::string rest;
  int i = 0;
  for (std::string value; values >> value; ++i) rest += (i < 6 ? value : "0") + " ";
  return bvh.substr(0, begin) + rest + "\n" + rest + "\n" + bvh.substr(begin);
}

/// In this capture the root leans forward to one side: a leg of the rest pose is 26 degrees off vertical.
TEST(FirstPose, RestPoseOfLeaningRootIsNamed) {
  const auto file = testing::sharedData("mocap/bvh/cmu_12_01_walk_motionbuilder.bvh");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  std::string walk = readFile(file);
  std::erase(walk, '\r');
  // Without the T-pose that the conversion has added; the number of frames is not that of the header.
  const auto begin = walk.find('\n', walk.find("Frame Time:")) + 1;
  walk.erase(begin, walk.find('\n', begin) + 1 - begin);
  EXPECT_THAT(readBvhRecording(walk, "w.bvh", {}).report.warnings,
              ::testing::Not(Contains(HasSubstr("T-pose"))));
  EXPECT_THAT(readBvhRecording(withRestPose(walk), "w.bvh", {}).report.warnings,
              Contains(HasSubstr("frames 1 to 2 are a T-pose")));
}

/// Conversions of the CMU data base begin with one; other captures do not.
TEST(FirstPose, RealTPosesAreWarnings) {
  const auto is_named = ::testing::Contains(HasSubstr("the first frame is a T-pose"));
  for (const char* name : {"01_01.bvh", "01_03.bvh"}) {
    const auto file = testing::debianBvh(name);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    EXPECT_THAT(openRecording(file).report.warnings, is_named) << name;
  }
  EXPECT_THAT(openRecording(testing::debianBvh("Boxing_Toes.bvh")).report.warnings, ::testing::Not(is_named));
  for (const char* name :
       {"bvh/bvhtoolbox_walk01.bvh", "bvh/cmu_jumping_jacks_3dsmax_names.bvh", "bvh/fair1_wave_hello.bvh",
        "bvh/rokoko_jesse_dance.bvh", "trc/motek/T.trc", "c3d/others/mocap36.c3d"}) {
    const auto file = testing::sharedData(std::string("mocap/") + name);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    EXPECT_THAT(openRecording(file).report.warnings, ::testing::Not(::testing::Contains(HasSubstr("T-pose"))))
        << name;
  }
}

}  // namespace first_pose_test
}  // namespace abstand::tracking
