#include "app/tune/closest_approach.hpp"

#include <gtest/gtest.h>

namespace abstand::tune {
namespace closest_approach_test {

/// A hand with these clearances (m), a second apart; infinitely uncertain where it was not seen.
TunedRecording handOf(const std::vector<double>& clearance) {
  TunedRecording recording;
  recording.pass.links = {"link"};
  PartClearance part{};
  part.part = "hand_left";
  for (std::size_t i = 0; i < clearance.size(); ++i) {
    part.track.t.push_back(static_cast<double>(i));
    part.track.clearance.push_back(clearance[i]);
    part.track.between.push_back(kInfinity);
    part.distance.push_back(0.5);
    part.bound.push_back(0.0);
    part.uncertainty.push_back(0.5 - clearance[i]);
    part.age_uncertainty.push_back(0.0);
    part.latency_uncertainty.push_back(0.0);
    part.link.push_back(0);
    part.tool.push_back(kNoTool);
  }
  recording.pass.parts.push_back(part);
  return recording;
}

ClosestApproach::Verdict verdictOf(const std::vector<double>& clearance) {
  return closestApproaches({handOf(clearance)}, 0.0).front().verdict();
}

TEST(ClosestApproach, PartlyUnseenPartIsUnknown) {
  using Verdict = ClosestApproach::Verdict;
  EXPECT_EQ(verdictOf({0.3, 0.2}), Verdict::kApart);
  EXPECT_EQ(verdictOf({0.3, 0.0}), Verdict::kTouchPossible);
  EXPECT_EQ(verdictOf({0.3, -kInfinity, 0.2}), Verdict::kNotKnown);
  EXPECT_EQ(verdictOf({0.3, -kInfinity}), Verdict::kNotKnown) << "the last frame, behind which is no time";
  EXPECT_EQ(verdictOf({-kInfinity}), Verdict::kNotKnown) << "never seen";
}

TEST(ClosestApproach, SplitsPoseUncertaintyIntoShares) {
  constexpr double kCalibration = 0.01, kAge = 0.05;
  TunedRecording recording = handOf({0.4, 0.3, 0.35});
  PartClearance& hand = recording.pass.parts.front();
  hand.bound.assign(3, 0.02);
  for (std::size_t i = 0; i < 3; ++i) {
    hand.uncertainty[i] = hand.distance[i] - hand.bound[i] - hand.track.clearance[i];
    hand.age_uncertainty[i] = i == 1 ? kAge : 0.0;
  }
  const ClosestApproach c = closestApproaches({recording}, kCalibration).front();
  EXPECT_EQ(c.t, 1.0);
  EXPECT_NEAR(c.pose, 0.5 - 0.02 - 0.3 - kCalibration, 1e-12);
  EXPECT_EQ(c.pose_age, kAge);
  EXPECT_NEAR(c.poseTracker() + c.pose_age, c.pose, 1e-15) << "the shares are the whole";
  EXPECT_NEAR(c.clearance(), 0.3, 1e-12) << "and change nothing in it";
}

TEST(ClosestApproach, AgeShareIsAtMostPoseUncertainty) {
  TunedRecording recording = handOf({0.3});
  recording.pass.parts.front().age_uncertainty[0] = 1.0;
  const ClosestApproach c = closestApproaches({recording}, 0.0).front();
  EXPECT_EQ(c.pose_age, c.pose);
  EXPECT_EQ(c.poseTracker(), 0.0);
}

}  // namespace closest_approach_test
}  // namespace abstand::tune
