// Facing directions compared image by image.
#include "tracking/tracker/facing_trial.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace abstand::tracking {
namespace facing_trial_test {

constexpr double kTolerance = 1e-12;    // of sums of up to 300 costs
constexpr double kPeriod = 1.0 / 30.0;  // s

/// Of a body whose feet are hidden.
FacingEvidence evidenceOf(double cost) {
  FacingEvidence evidence;
  evidence.cost = cost;
  return evidence;
}

constexpr double kSome = 2.0 * FacingTrial::kMinLowPoints;  // low points

/// Of a body at 2.8 m, of whose feet `points` are seen, with robust squares `low_cost` (m^2).
FacingEvidence evidenceOfFeet(double low_cost, double points = kSome) {
  FacingEvidence evidence = evidenceOf(1.0);
  evidence.low_points = points;
  evidence.low_cost = low_cost;
  evidence.distance = 2.8;
  return evidence;
}

/// The ratio of costs is `ratio`.
FacingTrial trialOf(std::size_t images, double ratio) {
  FacingTrial trial;
  for (std::size_t i = 0; i < images; ++i)
    trial.add(kPeriod * static_cast<double>(i), evidenceOf(1.0), evidenceOf(ratio));
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
  trial.add(0.0, evidenceOf(1.0), evidenceOf(3.0));
  trial.add(kPeriod, evidenceOf(3.0), evidenceOf(3.0));
  EXPECT_NEAR(trial.ratio(), 1.5, kTolerance);
}

TEST(FacingTrial, SettlesIfClearOrAfterManyImages) {
  const double very_clear = 1.1 * FacingTrial::kVeryClear;
  EXPECT_FALSE(FacingTrial{}.settles());
  EXPECT_FALSE(trialOf(FacingTrial::kMinImages - 1, very_clear).settles());
  for (const double ratio : {very_clear, 1.0 / very_clear})
    EXPECT_TRUE(trialOf(FacingTrial::kMinImages, ratio).settles());
  EXPECT_FALSE(trialOf(FacingTrial::kSettlingImages - 1, 1.5).settles());
  EXPECT_TRUE(trialOf(FacingTrial::kSettlingImages, 1.5).settles());
}

TEST(FacingTrial, JudgesWithEnoughImages) {
  EXPECT_TRUE(std::isnan(judged(trialOf(FacingTrial::kMinImages - 1, 1.3))));
  EXPECT_NEAR(judged(trialOf(FacingTrial::kMinImages, 1.3)), 1.3, kTolerance);
  EXPECT_NEAR(judged(trialOf(FacingTrial::kMinImages, 1.0)), 1.0, kTolerance);
}

TEST(FacingTrial, JudgesClearCasesWithFewImages) {
  for (const double away : {1.6, 1.0 / 1.6}) {
    EXPECT_TRUE(std::isnan(judged(trialOf(FacingTrial::kFewImages - 1, away)))) << away;
    EXPECT_NEAR(judged(trialOf(FacingTrial::kFewImages, away)), away, kTolerance) << away;
  }
}

TEST(FacingTrial, AssumesTheLikelierDirection) {
  constexpr std::size_t kImages = FacingTrial::kMinImages;
  for (const bool away : {false, true}) {
    EXPECT_TRUE(trialOf(kImages, 1.0 / (FacingTrial::kAlike + 0.01)).isLikelyAway(away)) << away;
    EXPECT_FALSE(trialOf(kImages, FacingTrial::kAlike + 0.01).isLikelyAway(away)) << away;
    EXPECT_EQ(trialOf(kImages, 1.0).isLikelyAway(away), away) << "as before";
  }
}

TEST(FacingTrial, AssumesAwayAfterFewImagesIfThatIsClearlyBetter) {
  for (const bool away : {false, true}) {
    EXPECT_TRUE(trialOf(1, FacingTrial::kLikelyAwayAtFirst - 0.01).isLikelyAway(away)) << away;
    EXPECT_FALSE(trialOf(1, FacingTrial::kLikelyAwayAtFirst + 0.01).isLikelyAway(away)) << away;
  }
}

TEST(FacingTrial, EndsAfterTheMostImages) {
  EXPECT_FALSE(trialOf(FacingTrial::kMaxImages - 1, 1.0).complete());
  EXPECT_TRUE(trialOf(FacingTrial::kMaxImages, 1.0).complete());
}

TEST(FacingTrial, FavoursFacingTheCameraIfThatExplainsTheFeet) {
  const auto ratio = [](double points, double low_camera, double low_away) {
    FacingTrial trial;
    for (int i = 0; i < 3; ++i)
      trial.add(kPeriod * i, evidenceOfFeet(low_camera, points), evidenceOfFeet(low_away, points));
    return trial.ratio();
  };
  EXPECT_GT(ratio(kSome, 0.02, 0.06), 1.1);
  EXPECT_NEAR(ratio(kSome, 0.06, 0.02), 1.0, kTolerance) << "never for facing away";
  EXPECT_NEAR(ratio(0.5 * FacingTrial::kMinLowPoints, 0.02, 0.06), 1.0, kTolerance) << "too few points";
}

TEST(FacingTrial, IsAgainstToesOfWhoFacesAwayInEmptySpace) {
  const auto ratio = [](double empty_camera, double empty_away, double distance = 2.8) {
    FacingEvidence camera = evidenceOfFeet(0.0), away = evidenceOfFeet(0.0);
    camera.empty_cost = empty_camera;
    away.empty_cost = empty_away;
    camera.distance = away.distance = distance;
    FacingTrial trial;
    trial.add(0.0, camera, away);
    return trial.ratio();
  };
  EXPECT_GT(ratio(0.0, 4e-6), 1.5);
  EXPECT_NEAR(ratio(4e-6, 0.0), 1.0, kTolerance) << "toes may be lost in the floor";
  EXPECT_LT(ratio(0.0, 4e-6, 5.6), ratio(0.0, 4e-6)) << "far away, noise places toes in empty space";
}

// The feet of somebody on the knees who faces away point to the camera.
TEST(FacingTrial, IgnoresToesOfWhoFacesAwayOnTheKnees) {
  constexpr int kImages = 10;
  const auto ratio = [](int kneeling) {
    const FacingEvidence camera = evidenceOfFeet(0.02);
    FacingEvidence away = evidenceOfFeet(0.06);
    FacingTrial trial;
    for (int i = 0; i < kImages; ++i) {
      away.kneels = i < kneeling;
      trial.add(kPeriod * i, camera, away);
    }
    return trial.ratio();
  };
  EXPECT_GT(ratio(0), 1.1);
  EXPECT_NEAR(ratio(2), ratio(0), kTolerance) << "of the other images";
  EXPECT_NEAR(ratio(6), 1.0, kTolerance) << "too few other ones";
  EXPECT_NEAR(ratio(kImages), 1.0, kTolerance);
}

TEST(FacingTrial, PersonIsCutIfAnyBodyIsInMostImages) {
  for (const std::size_t cut : {FacingTrial::kMinImages / 2, FacingTrial::kMinImages / 2 + 1}) {
    FacingTrial trial;
    for (std::size_t i = 0; i < FacingTrial::kMinImages; ++i) {
      FacingEvidence camera = evidenceOf(1.0);
      camera.shows_little = i < cut;
      trial.add(kPeriod * static_cast<double>(i), camera, evidenceOf(1.0));
    }
    Facing facing;
    trial.judge(facing);
    EXPECT_EQ(facing.shows_little, 2 * cut > FacingTrial::kMinImages) << cut;
  }
}

TEST(FacingTrial, PersonKneelsIfAnyBodyDoesInMostImages) {
  const auto kneels = [](std::size_t of_camera, std::size_t of_away) {
    FacingTrial trial;
    for (std::size_t i = 0; i < FacingTrial::kMinImages; ++i) {
      FacingEvidence camera = evidenceOf(1.0), away = evidenceOf(1.0);
      camera.kneels = i < of_camera;
      away.kneels = i < of_away;
      trial.add(kPeriod * static_cast<double>(i), camera, away);
    }
    Facing facing;
    trial.judge(facing);
    return facing.kneels;
  };
  constexpr std::size_t kHalf = FacingTrial::kMinImages / 2;
  EXPECT_FALSE(kneels(0, 0));
  EXPECT_FALSE(kneels(kHalf, kHalf));
  EXPECT_TRUE(kneels(kHalf + 1, 0));
  EXPECT_TRUE(kneels(0, kHalf + 1));
}

/// Ratio of a person who moves `step` (m) to +x in each of `images`, `period` (s) apart, whose bodies face
/// +x (to the camera) and -x.
double ratioOfWalk(int images, double step, double period) {
  FacingTrial trial;
  for (int i = 0; i < images; ++i) {
    FacingEvidence camera = evidenceOf(1.0), away = evidenceOf(1.0);
    camera.p_WP = away.p_WP = i * step * Vector3d::UnitX();
    away.forward_W = -Vector3d::UnitX();
    trial.add(period * i, camera, away);
  }
  return trial.ratio();
}

TEST(FacingTrial, FavoursWhoWalksForward) {
  constexpr int kImages = 31;
  EXPECT_NEAR(ratioOfWalk(kImages, 0.03, kPeriod), FacingTrial::kMaxOfWalking, kTolerance);
  EXPECT_NEAR(ratioOfWalk(kImages, -0.03, kPeriod), 1.0 / FacingTrial::kMaxOfWalking, kTolerance);
  EXPECT_NEAR(ratioOfWalk(kImages, 0.3, kPeriod), FacingTrial::kMaxOfWalking, kTolerance) << "no more";
  EXPECT_NEAR(ratioOfWalk(kImages, 0.9 / 30.0 * FacingTrial::kWalks, kPeriod), 1.0, kTolerance) << "shifts";
  EXPECT_NEAR(ratioOfWalk(kImages, 0.03, -kPeriod), 1.0 / FacingTrial::kMaxOfWalking, kTolerance)
      << "images in reverse order";
  EXPECT_NEAR(ratioOfWalk(kImages, 0.03, 2.0 * FacingTrial::kLongestStep), 1.0, kTolerance) << "gaps";
}

TEST(FacingTrial, DoesNotDecideByWalkingAlone) {
  Facing facing;
  facing.ratio = FacingTrial::kMaxOfWalking;
  EXPECT_FALSE(facing.decided());
  facing.ratio = 1.0 / FacingTrial::kMaxOfWalking;
  EXPECT_FALSE(facing.decided());
}

}  // namespace facing_trial_test
}  // namespace abstand::tracking
