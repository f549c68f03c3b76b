// A model that takes over the bone lengths of a recording.
#include "humanmodel/recording_lengths.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"

namespace abstand::humanmodel {
namespace recording_lengths_test {

constexpr double kRounding = 1e-12;

std::vector<SkeletonFrame> standing(double height, std::size_t frames) {
  HumanOptions options;
  options.height = height;
  std::vector<SkeletonFrame> all(frames, makeHuman(options).rest);
  for (std::size_t i = 0; i < frames; ++i) all[i].t = 0.01 * static_cast<double>(i);
  return all;
}

TEST(RecordingLengths, UseRecordedBonesAndKeepGirths) {
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

TEST(RecordingLengths, MediansIgnoreBrokenFrames) {
  std::vector<SkeletonFrame> recording = standing(1.8, 500);
  for (std::size_t i = 0; i < recording.size(); i += 4) recording[i].set(Joint::kKneeLeft, {50.0, 0.0, 0.0});
  for (std::size_t i = 1; i < recording.size(); i += 4)
    recording[i].set(Joint::kKneeLeft, Vector3d::Constant(kNaN), JointState::kMissing);
  const auto thigh = medianBone(recording, Joint::kHipLeft, Joint::kKneeLeft);
  ASSERT_TRUE(thigh);
  EXPECT_NEAR(*thigh, (recording[2][Joint::kHipRight] - recording[2][Joint::kKneeRight]).norm(), kRounding);
}

TEST(RecordingLengths, UnrecordedLengthsStay) {
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

TEST(RecordingLengths, RejectsWrongUnits) {
  std::vector<SkeletonFrame> recording = standing(1.9, 3);
  for (SkeletonFrame& f : recording)
    for (Vector3d& p : f.p) p *= 1000.0;
  EXPECT_THROW(makeHuman(withRecordingLengths({}, recording)), UsageError);
}

TEST(RecordingLengths, StandingAnkleIsRobustMinimum) {
  std::vector<SkeletonFrame> recording = standing(1.8, 100);
  const double ankle = recording[0][Joint::kAnkleLeft].z();
  // Half of the time in the air, and one frame below the ground.
  for (std::size_t i = 0; i < 50; ++i)
    for (Vector3d& p : recording[i].p) p.z() += 0.3;
  recording[70].set(Joint::kAnkleLeft, {0.0, 0.0, -3.0});
  ASSERT_TRUE(standingAnkle(recording, 0.0));
  EXPECT_NEAR(*standingAnkle(recording, 0.0), ankle, kRounding);
  EXPECT_FALSE(standingAnkle(recording, 1.0)) << "the floor is elsewhere";
  EXPECT_FALSE(standingAnkle(recording, -0.9));
  EXPECT_FALSE(standingAnkle({}, 0.0));
}

TEST(RecordingLengths, FitIsExactForModelBones) {
  const auto fit = fitLengths({}, standing(1.62, 300));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->stature, 1.62, kRounding);
  EXPECT_LT(fit->rms, kRounding);
  EXPECT_LT(fit->stature_spread, kRounding);
  EXPECT_EQ(fit->bones.size(), 10u);  // torso, head, four of the arms, four of the legs
  for (const BoneLength& b : fit->bones) {
    EXPECT_LT(b.spread, kRounding) << partName(b.part);
    EXPECT_LT(std::abs(b.residual), kRounding) << partName(b.part);
  }
}

TEST(RecordingLengths, LongerBoneAppearsAsResidual) {
  // One thigh 10 % longer than the rest says: ten bones, so the stature grows by one hundredth, and the thigh
  // keeps 9 % of its length as residual. Its spread: every tenth frame is 30 mm longer still.
  std::vector<SkeletonFrame> recording = standing(1.75, 200);
  const double thigh = (recording[0][Joint::kHipLeft] - recording[0][Joint::kKneeLeft]).norm();
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const double more = 0.1 * thigh + (i % 10 == 0 ? 0.03 : 0.0);
    // The whole lower leg goes along, so that the calf keeps its length.
    const Vector3d down =
        more * (recording[i][Joint::kKneeLeft] - recording[i][Joint::kHipLeft]).normalized();
    for (const Joint j : {Joint::kKneeLeft, Joint::kAnkleLeft, Joint::kToeLeft})
      recording[i].set(j, recording[i][j] + down);
  }
  const auto fit = fitLengths({}, recording);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->stature, 1.75 * 1.01, 1e-9);
  for (const BoneLength& b : fit->bones) {
    const bool is_it = b.part == BodyPart::kThighLeft;
    EXPECT_NEAR(b.spread, is_it ? 0.03 : 0.0, 1e-9) << partName(b.part);
    EXPECT_NEAR(b.residual, (is_it ? 1.1 : 1.0) * b.model / 1.01 - b.model, 1e-9) << partName(b.part);
  }
  EXPECT_FALSE(fitLengths({}, {}).has_value());
}

TEST(RecordingLengths, LegRatioMatchesStatures) {
  const std::vector<SkeletonFrame> recording = standing(1.6, 10);
  HumanOptions options;
  options.height = 1.8;
  const HumanModel model = makeHuman(options);
  ASSERT_TRUE(legRatio(model, recording));
  EXPECT_NEAR(*legRatio(model, recording), 1.8 / 1.6, kRounding);
  EXPECT_NEAR(*legRatio(model, recording[0]), 1.8 / 1.6, kRounding);
  EXPECT_FALSE(legRatio(model, SkeletonFrame{}));
}

}  // namespace recording_lengths_test
}  // namespace abstand::humanmodel
