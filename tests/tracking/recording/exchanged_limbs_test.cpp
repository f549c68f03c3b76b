// Left and right exchanged in arms or legs alone, or below a joint.
#include "tracking/recording/exchanged_limbs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "core/base/text_file.hpp"
#include "humanmodel/human_model.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/small_human.hpp"
#include "tracking/bvh/bvh_recording.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace exchanged_limbs_test {

using humanmodel::Joint;
using humanmodel::SkeletonFrame;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string otherSide(const std::string& name) {
  for (const auto& [from, to] : {std::pair{"Left", "Right"}, {"Right", "Left"}})
    if (const auto at = name.find(from); at != std::string::npos)
      return name.substr(0, at) + to + name.substr(at + std::string(from).size());
  return name;
}

bool hasAny(const std::string& name, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return name.find(word) != std::string::npos; });
}

bool isOfArm(const std::string& n) {
  return hasAny(n, {"Collar", "Shoulder", "Elbow", "Wrist", "Arm", "Hand"});
}
bool isOfLeg(const std::string& n) { return hasAny(n, {"Hip", "Knee", "Ankle", "Leg", "Foot", "Toe"}); }

/// The BVH file with the names of both sides exchanged where `of` says so.
std::string exchanged(const std::string& bvh, const std::function<bool(const std::string&)>& of) {
  std::istringstream in(bvh);
  std::string out;
  for (std::string line; std::getline(in, line); out += line + "\n") {
    const auto at = line.find("JOINT ");
    if (at == std::string::npos) continue;
    const std::string name = line.substr(at + 6);
    if (of(name)) line = "JOINT " + otherSide(name);
  }
  return out;
}

Recording read(const std::string& bvh) { return readBvhRecording(bvh, "t.bvh", {}); }

TEST(ExchangedLimbs, ArmsOrLegsAloneAreNamed) {
  const std::string bvh = testing::bvhOf({});
  EXPECT_THAT(read(bvh).report.warnings, IsEmpty());
  const Recording arms = read(exchanged(bvh, isOfArm));
  EXPECT_EQ(arms.report.sides.found, "agree");
  EXPECT_THAT(arms.report.sides.reason, HasSubstr("the shoulders are the other way round than the hips"));
  EXPECT_THAT(
      arms.report.warnings,
      Contains(HasSubstr("left and right seem exchanged in the arms: the left shoulder is on the side of "
                         "the right hip in 3 of 3 frames")));
  const Recording legs = read(exchanged(bvh, isOfLeg));
  EXPECT_THAT(legs.report.warnings, Contains(HasSubstr("left and right seem exchanged in the legs")));
  EXPECT_THAT(legs.report.warnings, Not(Contains(HasSubstr("set mirror"))));
  const Recording all = read(exchanged(bvh, [](const std::string&) { return true; }));
  EXPECT_THAT(all.report.warnings, Contains(HasSubstr("set mirror")));
  EXPECT_THAT(all.report.warnings, Not(Contains(HasSubstr("seem exchanged"))));
}

/// Frames of a person with the trunk turned by `turned` above the hips, rad.
std::vector<SkeletonFrame> twisted(double turned) {
  SkeletonFrame f = humanmodel::makeHuman({}).rest;
  const Matrix3d R = Eigen::AngleAxisd(turned, Vector3d::UnitZ()).toRotationMatrix();
  for (const Joint j : {Joint::kShoulderLeft, Joint::kShoulderRight}) f.set(j, R * f[j]);
  return std::vector<SkeletonFrame>(20, f);
}

TEST(ExchangedLimbs, TwistedTrunksAreNotNamed) {
  for (const double degrees : {0.0, 45.0, 90.0, 115.0}) {
    EXPECT_FALSE(opposedShoulders(twisted(degrees * kPi / 180.0))) << degrees;
    EXPECT_FALSE(opposedShoulders(twisted(-degrees * kPi / 180.0))) << degrees;
  }
  EXPECT_TRUE(opposedShoulders(twisted(kPi)));
  EXPECT_FALSE(opposedShoulders({}));
  EXPECT_FALSE(opposedShoulders(std::vector<SkeletonFrame>(5)));
}

/// A walk with legs that swing by `swing` rad, knees crossed by `crossed` m, and noise of `noise` m.
std::vector<SkeletonFrame> swinging(double swing, double crossed, double noise) {
  std::vector<SkeletonFrame> frames;
  unsigned seed = 1;
  const auto random = [&] {
    seed = seed * 1664525u + 1013904223u;
    return noise * (static_cast<double>(seed >> 8) / (1 << 23) - 1.0);
  };
  for (int i = 0; i < 200; ++i) {
    SkeletonFrame f = humanmodel::makeHuman({}).rest;
    for (const double side : {1.0, -1.0}) {
      const auto at = [&](Joint left) {
        return static_cast<Joint>(static_cast<int>(left) + (side > 0 ? 0 : 4));
      };
      const double angle = side * swing * std::sin(0.1 * i);
      const double aside = -side * crossed + 0.2 * swing * std::sin(0.07 * i);
      const double ahead = 0.42 * std::sin(angle);
      f.set(at(Joint::kKneeLeft),
            f[at(Joint::kHipLeft)] +
                Vector3d(ahead, aside, -std::sqrt(0.42 * 0.42 - ahead * ahead - aside * aside)));
      f.set(at(Joint::kAnkleLeft), f[at(Joint::kKneeLeft)] + Vector3d(0, 0, -0.42));
    }
    for (auto& p : f.p) p += Vector3d(random(), random(), random());
    frames.push_back(f);
  }
  return frames;
}

void exchange(std::vector<SkeletonFrame>& frames, std::initializer_list<Joint> left) {
  for (SkeletonFrame& f : frames)
    for (const Joint j : left)
      std::swap(f.p[static_cast<std::size_t>(j)], f.p[static_cast<std::size_t>(j) + 4]);
}

TEST(ExchangedLimbs, CalvesAreNamedIfTheyMove) {
  for (const double noise : {0.0, 0.001}) {
    auto frames = swinging(0.4, 0.0, noise);
    EXPECT_THAT(exchangedLimbs(frames), IsEmpty());
    exchange(frames, {Joint::kKneeLeft, Joint::kAnkleLeft, Joint::kToeLeft});
    EXPECT_THAT(exchangedLimbs(frames), ::testing::ElementsAre(HasSubstr(
                                            "left and right seem exchanged from the knees on: the distance "
                                            "from the left hip to the left knee varies by")));
  }
  auto still = swinging(0.0, 0.0, 0.005);
  exchange(still, {Joint::kKneeLeft, Joint::kAnkleLeft, Joint::kToeLeft});
  EXPECT_THAT(exchangedLimbs(still), IsEmpty()) << "nothing shows it";
}

/// Each knee is below the other hip, or beyond.
TEST(ExchangedLimbs, CrossedLegsAreNotNamed) {
  for (const double crossed : {0.1, 0.2, 0.3})
    for (const double noise : {0.0, 0.005, 0.03})
      for (const double swing : {0.0, 0.1, 0.4})
        EXPECT_THAT(exchangedLimbs(swinging(swing, crossed, noise)), IsEmpty()) << crossed << " " << noise;
}

TEST(ExchangedLimbs, RealCapturesAreNamedOnlyIfExchanged) {
  for (const char* name : {"bvhtoolbox_walk01.bvh", "mocapbank_test.bvh", "rokoko_jesse_dance.bvh",
                           "xsens_names_pybvh_test2.bvh", "fair1_wave_hello.bvh"}) {
    const auto file = testing::sharedData(std::string("mocap/bvh/") + name);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    std::string bvh = readFile(file);
    std::erase(bvh, '\r');
    EXPECT_THAT(read(bvh).report.warnings, Not(Contains(HasSubstr("seem exchanged")))) << name;
    EXPECT_THAT(read(exchanged(bvh, isOfArm)).report.warnings,
                Contains(HasSubstr("seem exchanged in the arms")))
        << name;
    EXPECT_THAT(read(exchanged(bvh, isOfLeg)).report.warnings,
                Contains(HasSubstr("seem exchanged in the legs")))
        << name;
    // "LeftLeg" is the calf, "LeftUpLeg" the thigh; "LeftForeArm" follows "LeftArm".
    const auto isOfCalf = [](const std::string& n) {
      return hasAny(n, {"Knee", "Ankle", "LeftLeg", "RightLeg", "Foot", "Toe"});
    };
    const auto isOfForearm = [](const std::string& n) {
      return hasAny(n, {"Elbow", "Wrist", "ForeArm", "Hand"});
    };
    EXPECT_THAT(read(exchanged(bvh, isOfCalf)).report.warnings,
                Contains(HasSubstr("seem exchanged from the knees on")))
        << name;
    EXPECT_THAT(read(exchanged(bvh, isOfForearm)).report.warnings,
                Contains(HasSubstr("seem exchanged from the elbows on")))
        << name;
  }
}

/// Sensors and fitted bodies of other kinds.
TEST(ExchangedLimbs, OtherRealRecordingsAreNotNamed) {
  for (const char* name :
       {"kinect/irds_kinect_v2/215_18_0_1_1_stand.csv", "kinect/irds_kinect_v2/217_18_0_1_1_wheelchair.csv",
        "kinect/irds_kinect_v2/217_18_2_3_1_wheelchair.csv",
        "kinect/uiprmd_kinect_v2/m05_s01_e01_positions.txt", "depth/utd_mhad/a18_s1_t1_skeleton.mat",
        "depth/utd_mhad/a25_s3_t1_skeleton.mat", "mocap/asfamc/11_01.amc", "mocap/c3d/others/mocap36.c3d",
        "mocap/trc/motek/ballet_reduced.trc"}) {
    const auto file = testing::sharedData(name);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    EXPECT_THAT(openRecording(file).report.warnings, Not(Contains(HasSubstr("seem exchanged")))) << name;
  }
}

}  // namespace exchanged_limbs_test
}  // namespace abstand::tracking
