// Real captures of many programs: what the reader makes of each is known, and bodies obey what bodies obey.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tracking/bvh/bvh_pose.hpp"
#include "tracking/bvh/bvh_reader.hpp"
#include "tracking/recording/recording.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace real_recordings_test {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kRatePerRate = 2e-4;           // the list rounds; a frame time of .03333 is 30.003 Hz
constexpr double kBoneLengthPerExtent = 1e-12;  // roundings of some ten turns

struct Capture {
  const char* file;
  std::size_t joints;  // end sites not counted
  std::size_t frames;
  double rate;  // Hz
  const char* units;
  const char* up;
  const char* map;
};

void PrintTo(const Capture& c, std::ostream* out) { *out << c.file; }

// Joints, frames, rates, up axes and units as the collection's list states them; scaled freely where it says
// that the units are not metric.
const Capture kCaptures[] = {
    {"blender_reactidle_003_genuine.bvh", 19, 918, 24.00, "free", "y", "Blender / Rigify"},
    {"bvhio_example.bvh", 18, 2, 30.00, "inches", "y", "Biovision, first names"},
    {"bvhtoolbox_walk01.bvh", 19, 101, 24.00, "cm", "y", "MotionBuilder / HumanIK"},
    {"cmu_12_01_walk_motionbuilder.bvh", 31, 524, 120.00, "cmu", "y", "CMU, MotionBuilder names"},
    {"cmu_jumping_jacks_3dsmax_names.bvh", 31, 125, 30.00, "cmu", "y", "CMU, 3ds Max names"},
    {"fair1_wave_hello.bvh", 27, 839, 119.88, "free", "z", "FAIR Animated Drawings"},
    {"mocapbank_test.bvh", 19, 455, 30.00, "cm", "y", "Mocapbank"},
    {"rokoko_jesse_dance.bvh", 60, 1007, 100.00, "cm", "y", "Rokoko Studio"},
    {"xsens_names_pybvh_test2.bvh", 23, 61, 120.00, "cm", "y", "Xsens MVN"},
    {"xzy_spine3_pybvh_test1.bvh", 24, 75, 30.00, "inches", "z", "MotionBuilder / HumanIK"},
    {"01_01.bvh", 31, 2752, 120.00, "cmu", "y", "CMU, MotionBuilder names"},
    {"01_03.bvh", 31, 4511, 120.00, "cmu", "y", "CMU, MotionBuilder names"},
    {"Boxing_Toes.bvh", 21, 3069, 100.00, "cm", "y", "Biovision"}};

std::filesystem::path pathOf(const Capture& c) {
  const std::string name = c.file;
  return name.starts_with("01_") || name.starts_with("Boxing") ? testing::debianBvh(name)
                                                               : testing::sharedData("mocap/bvh/" + name);
}

class RealRecording : public ::testing::TestWithParam<Capture> {};

TEST_P(RealRecording, IsReadAsPerson) {
  const auto file = pathOf(GetParam());
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  const Recording r = openRecording(file);
  const RecordingReport& report = r.report;
  const auto ends = std::count_if(report.joints.begin(), report.joints.end(),
                                  [](const auto& n) { return n.ends_with("/end"); });
  EXPECT_EQ(report.joints.size() - static_cast<std::size_t>(ends), GetParam().joints);
  EXPECT_EQ(r.frames.size(), GetParam().frames);
  EXPECT_NEAR(report.rate, GetParam().rate, kRatePerRate * GetParam().rate);
  EXPECT_EQ(report.units.name, GetParam().units);
  EXPECT_EQ(report.up.axis, GetParam().up);
  EXPECT_EQ(report.joint_map, GetParam().map);
  EXPECT_GE(report.stature, 1.4);
  EXPECT_LE(report.stature, 2.1);
  EXPECT_EQ(report.mapped.size(), 14u);
  EXPECT_THAT(report.missing_parts, IsEmpty());
  EXPECT_EQ(report.gaps, 0u);
  EXPECT_THAT(report.warnings, ::testing::Not(Contains(HasSubstr("swapped"))));
}

TEST_P(RealRecording, HasPlausibleBody) {
  const auto file = pathOf(GetParam());
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  const Recording r = openRecording(file);
  std::size_t upright = 0, head_above = 0, left_is_left = 0;
  for (const humanmodel::SkeletonFrame& f : r.frames) {
    using J = humanmodel::Joint;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) ASSERT_TRUE(f.p[j].allFinite());
    const Vector3d trunk = f[J::kNeck] - f[J::kPelvis];
    const Vector3d thighs = f[J::kKneeLeft] - f[J::kHipLeft] + f[J::kKneeRight] - f[J::kHipRight];
    if (trunk.z() < 0.8 * trunk.norm() || thighs.z() > -0.5 * thighs.norm())
      continue;  // bent, lying or sitting
    ++upright;
    const double lower_foot = std::min(f[J::kAnkleLeft].z(), f[J::kAnkleRight].z());  // the other may kick
    head_above += f[J::kHeadTop].z() > f[J::kPelvis].z() && f[J::kPelvis].z() > lower_foot;
    const Vector3d forward = f[J::kToeLeft] - f[J::kAnkleLeft] + f[J::kToeRight] - f[J::kAnkleRight];
    left_is_left += Vector3d::UnitZ().cross(forward).dot(f[J::kShoulderLeft] - f[J::kShoulderRight]) > 0.0;
  }
  ASSERT_GT(upright, 0u);
  EXPECT_EQ(head_above, upright);
  EXPECT_GT(static_cast<double>(left_is_left), 0.95 * static_cast<double>(upright))
      << "a twisted trunk is an exception";
}

TEST_P(RealRecording, KeepsBoneLengths) {
  const auto file = pathOf(GetParam());
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  BvhReader reader(readFile(file), file.string());
  const auto& joints = reader.hierarchy().joints;
  BvhPose pose(reader.hierarchy());
  std::size_t checked = 0;
  for (int i = 0; const auto values = reader.next(); ++i) {
    if (i % 50 != 0) continue;
    pose.set(*values);
    for (const BvhJoint& joint : joints) {
      const bool moves = std::any_of(joint.channels.begin(), joint.channels.end(),
                                     [](BvhChannel c) { return c <= BvhChannel::kZPosition; });
      if (joint.parent < 0 || moves) continue;
      const auto& p = pose.positions();
      const double length =
          (p[static_cast<std::size_t>(&joint - joints.data())] - p[static_cast<std::size_t>(joint.parent)])
              .norm();
      ASSERT_NEAR(length, joint.offset.norm(),
                  kBoneLengthPerExtent * (1.0 + p[0].norm() + joint.offset.norm()) * 100.0)
          << joint.name;
      ++checked;
    }
  }
  EXPECT_GT(checked, 0u);
}

INSTANTIATE_TEST_SUITE_P(Files, RealRecording, ::testing::ValuesIn(kCaptures), [](const auto& i) {
  std::string name = i.param.file;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

// Two fixtures are too small to be a person: they open, and it is said what cannot be moved.
TEST(TinyFixture, ReportsMissingParts) {
  for (const char* name : {"full_precision_frame_time.bvh", "rotation_first_root.bvh"}) {
    const auto file = testing::sharedData(std::string("mocap/bvh/") + name);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    const Recording r = openRecording(file);
    EXPECT_EQ(r.report.missing_parts.size(), 14u);
    EXPECT_THAT(r.report.warnings, Contains(HasSubstr("parts without motion in this file: torso (no neck)")));
    EXPECT_THAT(r.report.warnings, Contains(HasSubstr("units are unknown")));
  }
}

}  // namespace real_recordings_test
}  // namespace abstand::tracking
