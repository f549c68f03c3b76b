// A model that takes over the bone lengths of a recording.
#include "humanmodel/recording_lengths.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"

namespace abstand {
namespace {

constexpr double kRounding = 1e-12;

std::vector<SkeletonFrame> standing(double height, std::size_t frames) {
  HumanOptions options;
  options.height = height;
  std::vector<SkeletonFrame> all(frames, makeHuman(options).rest);
  for (std::size_t i = 0; i < frames; ++i) all[i].t = 0.01 * static_cast<double>(i);
  return all;
}

TEST(RecordingLengths, TheRecordingsBonesRuleAndGirthsStay) {
  const std::vector<SkeletonFrame> recording = standing(1.95, 1000);
  HumanOptions options;
  options.height = 1.70;
  const HumanModel usual = makeHuman(options), fitted = makeHuman(withRecordingLengths(options, recording));
  for (const HumanPart& p : fitted.parts) {
    const PartKind kind = kindOf(p.part);
    const double bone = (fitted.rest[p.proximal] - fitted.rest[p.distal]).norm();
    const double wanted = (recording[0][p.proximal] - recording[0][p.distal]).norm();
    if (kind == PartKind::kHand || kind == PartKind::kFoot)
      EXPECT_EQ(p.length, usual.part(p.part).length) << partName(p.part);
    else
      EXPECT_NEAR(bone, wanted, kRounding) << partName(p.part);
    EXPECT_NEAR(p.contour, usual.part(p.part).contour, kRounding) << partName(p.part);
  }
}

TEST(RecordingLengths, MediansShrugOffBrokenFrames) {
  std::vector<SkeletonFrame> recording = standing(1.8, 500);
  for (std::size_t i = 0; i < recording.size(); i += 4) recording[i].set(Joint::kKneeLeft, {50.0, 0.0, 0.0});
  for (std::size_t i = 1; i < recording.size(); i += 4)
    recording[i].set(Joint::kKneeLeft, Vector3d::Constant(kNaN), JointState::kMissing);
  const auto thigh = medianBone(recording, Joint::kHipLeft, Joint::kKneeLeft);
  ASSERT_TRUE(thigh);
  EXPECT_NEAR(*thigh, (recording[2][Joint::kHipRight] - recording[2][Joint::kKneeRight]).norm(), kRounding);
}

TEST(RecordingLengths, WhatIsNotRecordedStays) {
  EXPECT_TRUE(withRecordingLengths({}, {}).overrides.empty());
  std::vector<SkeletonFrame> recording = standing(1.9, 3);
  for (SkeletonFrame& f : recording)
    for (const Joint j : {Joint::kHeadTop, Joint::kWristLeft})
      f.set(j, Vector3d::Constant(kNaN), JointState::kMissing);
  HumanOptions options;
  options.overrides[BodyPart::kCalfLeft].length = 0.5;
  const HumanOptions fitted = withRecordingLengths(options, recording);
  EXPECT_FALSE(fitted.overrides.contains(BodyPart::kHead));
  EXPECT_EQ(fitted.overrides.at(BodyPart::kCalfLeft).length, 0.5) << "the user's own length rules";
  // One forearm is enough for both.
  EXPECT_EQ(fitted.overrides.at(BodyPart::kForearmLeft).length,
            fitted.overrides.at(BodyPart::kForearmRight).length);
}

TEST(RecordingLengths, WrongUnitsAreRefusedByName) {
  std::vector<SkeletonFrame> recording = standing(1.9, 3);
  for (SkeletonFrame& f : recording)
    for (Vector3d& p : f.p) p *= 1000.0;
  EXPECT_THROW(makeHuman(withRecordingLengths({}, recording)), UsageError);
}

TEST(RecordingLengths, LegRatio) {
  const std::vector<SkeletonFrame> recording = standing(1.6, 10);
  HumanOptions options;
  options.height = 1.8;
  const HumanModel model = makeHuman(options);
  ASSERT_TRUE(legRatio(model, recording));
  EXPECT_NEAR(*legRatio(model, recording), 1.8 / 1.6, kRounding);
  EXPECT_NEAR(*legRatio(model, recording[0]), 1.8 / 1.6, kRounding);
  EXPECT_FALSE(legRatio(model, SkeletonFrame{}));
}

}  // namespace
}  // namespace abstand
