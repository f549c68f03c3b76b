// Units from the bones that are there, if the stature is not.
#include "tracking/recording/body_size.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "humanmodel/human_model.hpp"
#include "tracking/recording/conversion.hpp"

namespace abstand::tracking {
namespace body_size_test {

using humanmodel::Joint;
using humanmodel::SkeletonFrame;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The standing model in units of the file, with only some joints.
std::vector<SkeletonFrame> part(double height, double units_per_metre, std::initializer_list<Joint> joints) {
  humanmodel::HumanOptions options;
  options.height = height;
  const SkeletonFrame rest = humanmodel::makeHuman(options).rest;
  SkeletonFrame f;
  for (const Joint j : joints) f.set(j, units_per_metre * rest[j]);
  return {f};
}

TEST(BodySize, AnyKnownBoneDeterminesUnit) {
  struct Unit {
    const char* name;
    double per_metre;
  };
  for (const Unit& unit : {Unit{"m", 1.0}, Unit{"cm", 100.0}, Unit{"mm", 1000.0},
                           Unit{"inches", 1.0 / 0.0254}, Unit{"cmu", 0.45 / 0.0254}})
    for (const double height : {1.5, 1.75, 2.0})
      for (const auto& joints : {std::initializer_list<Joint>{Joint::kHipLeft, Joint::kKneeLeft},
                                 {Joint::kKneeRight, Joint::kAnkleRight},
                                 {Joint::kShoulderLeft, Joint::kElbowLeft, Joint::kWristLeft},
                                 {Joint::kHipLeft, Joint::kShoulderLeft, Joint::kKneeLeft}}) {
        const auto frames = part(height, unit.per_metre, joints);
        const auto bones = statureByBones(frames);
        ASSERT_TRUE(bones);
        const UnitChoice choice = chooseUnit("auto", std::nullopt, bones);
        EXPECT_EQ(choice.name, unit.name) << height << " " << humanmodel::jointName(*joints.begin());
        EXPECT_THAT(choice.reason, HasSubstr("of the usual bones the person is about"));
        EXPECT_THAT(choice.warning, IsEmpty());
      }
}

TEST(BodySize, UnknownBonesDetermineNoUnit) {
  EXPECT_FALSE(statureByBones(part(1.75, 1.0, {Joint::kHead, Joint::kNeck, Joint::kWristLeft})));
  EXPECT_FALSE(statureByBones({}));
  EXPECT_THAT(chooseUnit("auto", std::nullopt).warning, HasSubstr("units are unknown"));
  const UnitChoice odd = chooseUnit("auto", std::nullopt, BoneStature{7.0, 2});
  EXPECT_EQ(odd.name, "free");
  EXPECT_DOUBLE_EQ(odd.scale, 0.25);
  EXPECT_THAT(odd.warning, HasSubstr("scaled to about 1.75 m"));
  EXPECT_EQ(chooseUnit("mm", std::nullopt, BoneStature{7.0, 2}).name, "mm");
  EXPECT_EQ(chooseUnit("auto", 175.0, BoneStature{7.0, 2}).name, "cm") << "a stature is better";
}

/// All joints of the standing model in mm, with the unit that the file states.
RawRecording inMillimetres(double height, const UnitChoice& stated) {
  humanmodel::HumanOptions options;
  options.height = height;
  const SkeletonFrame rest = humanmodel::makeHuman(options).rest;
  RawRecording raw;
  SkeletonFrame f;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    f.set(static_cast<Joint>(j), 1000.0 * rest[static_cast<Joint>(j)]);
  raw.frames = {f, f};
  raw.frames.back().t = 0.01;
  raw.is_canonical = true;
  raw.match.joint.fill(-1);
  raw.unit = stated;
  return raw;
}

TEST(BodySize, StatedUnitIsDoubtedIfPersonIsImplausible) {
  const UnitChoice cm{"cm", "POINT:UNITS of the file", 0.01, ""}, mm{"mm", "the same", 0.001, ""};
  const RecordingReport wrong = convert(inMillimetres(1.75, cm), {}).report;
  EXPECT_EQ(wrong.units.name, "cm") << "a stated unit is kept";
  EXPECT_NEAR(wrong.scale, 0.01, 0.0);
  EXPECT_THAT(wrong.units.doubt,
              HasSubstr("with the stated unit cm (POINT:UNITS of the file) the person is 17."));
  EXPECT_THAT(wrong.units.doubt, HasSubstr("m tall, not 1.2 to 2.4 m; in mm it would be 1.7"));
  EXPECT_THAT(wrong.warnings, ::testing::Contains(wrong.units.doubt));
  for (const double height : {1.25, 1.75, 2.2})
    EXPECT_THAT(convert(inMillimetres(height, mm), {}).report.units.doubt, IsEmpty()) << height;
  EXPECT_THAT(convert(inMillimetres(1.75, cm), {.units = "mm"}).report.units.doubt, IsEmpty());
  EXPECT_THAT(convert(inMillimetres(1.75, cm), {.units = "cm"}).report.units.doubt, IsEmpty())
      << "not stated";
}

TEST(BodySize, StatedUnitIsDoubtedByAnyBone) {
  RawRecording raw = inMillimetres(1.75, {"m", "the head", 1.0, ""});
  for (SkeletonFrame& f : raw.frames) f.state.fill(humanmodel::JointState::kMissing);
  for (SkeletonFrame& f : raw.frames)
    for (const Joint j : {Joint::kHipLeft, Joint::kKneeLeft}) f.set(j, f[j]);
  EXPECT_THAT(convert(raw, {}).report.units.doubt, HasSubstr("in mm it would be 1.6"));
  EXPECT_THAT(doubtOfUnit({"mm", "", 0.001, ""}, 7.0), HasSubstr("no usual unit gives that"));
}

TEST(BodySize, StatedStatureDecidesUnit) {
  // Rough statures, as of leg markers: without the stated one no unit would give an adult.
  for (const double rough : {1250.0, 1350.0, 2200.0}) {
    EXPECT_EQ(chooseUnit("auto", rough).name, "free") << rough;
    const UnitChoice choice = chooseUnit("auto", rough, std::nullopt, 1.63);
    EXPECT_EQ(choice.name, "mm") << rough;
    EXPECT_THAT(choice.reason, HasSubstr("m in mm, near the 1.630 m that the file states"));
    EXPECT_THAT(choice.warning, IsEmpty());
  }
  EXPECT_EQ(chooseUnit("auto", std::nullopt, BoneStature{135.0, 2}, 1.63).name, "cm");
  EXPECT_EQ(chooseUnit("m", 135.0, std::nullopt, 1.63).name, "m") << "the user decides";
  const UnitChoice odd = chooseUnit("auto", 7.0, std::nullopt, 1.61);
  EXPECT_EQ(odd.name, "free");
  EXPECT_DOUBLE_EQ(odd.scale, 0.23);
  EXPECT_THAT(odd.warning,
              HasSubstr("no common unit comes near the 1.610 m that the file states, to which it is scaled"));

  RawRecording raw = inMillimetres(1.38, {});
  raw.unit.reset();
  raw.subject.height = 1.4;
  const RecordingReport report = convert(raw, {}).report;
  EXPECT_EQ(report.units.name, "mm");
  EXPECT_THAT(report.warnings, IsEmpty());
}

}  // namespace body_size_test
}  // namespace abstand::tracking
