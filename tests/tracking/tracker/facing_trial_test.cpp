// Facing directions compared image by image.
#include "tracking/tracker/facing_trial.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace abstand::tracking {
namespace facing_trial_test {

constexpr double kTolerance = 1e-12;  // of sums of up to 300 costs

FacingTrial trialOf(std::size_t images, double camera, double away) {
  FacingTrial trial;
  for (std::size_t i = 0; i < images; ++i) trial.add(camera, away);
  return trial;
}

double judged(const FacingTrial& trial) {
  Facing facing;
  trial.judge(facing);
  return facing.ratio;
}

TEST(FacingTrial, ComparesSumsOfCosts) {
  FacingTrial trial;
  EXPECT_TRUE(std::isnan(trial.ratio()));
  for (const bool away : {false, true}) EXPECT_FALSE(trial.isLikelyAway(away));
  trial.add(1.0, 3.0);
  trial.add(3.0, 3.0);
  EXPECT_NEAR(trial.ratio(), 1.5, kTolerance);
}

TEST(FacingTrial, JudgesWithEnoughImages) {
  EXPECT_TRUE(std::isnan(judged(trialOf(FacingTrial::kMinImages - 1, 1.0, 1.3))));
  EXPECT_NEAR(judged(trialOf(FacingTrial::kMinImages, 1.0, 1.3)), 1.3, kTolerance);
  EXPECT_NEAR(judged(trialOf(FacingTrial::kMinImages, 1.0, 1.0)), 1.0, kTolerance);
}

TEST(FacingTrial, JudgesClearCasesWithFewImages) {
  for (const double away : {1.6, 1.0 / 1.6}) {
    EXPECT_TRUE(std::isnan(judged(trialOf(FacingTrial::kFewImages - 1, 1.0, away)))) << away;
    EXPECT_NEAR(judged(trialOf(FacingTrial::kFewImages, 1.0, away)), away, kTolerance) << away;
  }
}

TEST(FacingTrial, AssumesTheLikelierDirection) {
  constexpr std::size_t kImages = FacingTrial::kMinImages;
  for (const bool away : {false, true}) {
    EXPECT_TRUE(trialOf(kImages, 1.0, 1.0 / (FacingTrial::kAlike + 0.01)).isLikelyAway(away)) << away;
    EXPECT_FALSE(trialOf(kImages, 1.0, FacingTrial::kAlike + 0.01).isLikelyAway(away)) << away;
    EXPECT_EQ(trialOf(kImages, 1.0, 1.0).isLikelyAway(away), away) << "as before";
  }
}

TEST(FacingTrial, AssumesAwayAfterFewImagesIfThatIsClearlyBetter) {
  for (const bool away : {false, true}) {
    EXPECT_TRUE(trialOf(1, 1.0, FacingTrial::kLikelyAwayAtFirst - 0.01).isLikelyAway(away)) << away;
    EXPECT_FALSE(trialOf(1, 1.0, FacingTrial::kLikelyAwayAtFirst + 0.01).isLikelyAway(away)) << away;
  }
}

TEST(FacingTrial, EndsAfterTheMostImages) {
  EXPECT_FALSE(trialOf(FacingTrial::kMaxImages - 1, 1.0, 1.0).complete());
  EXPECT_TRUE(trialOf(FacingTrial::kMaxImages, 1.0, 1.0).complete());
}

}  // namespace facing_trial_test
}  // namespace abstand::tracking
