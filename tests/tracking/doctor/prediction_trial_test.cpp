// Guesses and reach sets on motions whose next moment is known.
#include "tracking/doctor/prediction_trial.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace abstand::tracking {
namespace prediction_trial_test {

constexpr double kAhead[] = {0.05, 0.1};

/// 2 s at 100 Hz of one joint.
Recording moving(const std::function<Vector3d(double)>& at) {
  Recording r;
  for (int i = 0; i < 200; ++i) {
    humanmodel::SkeletonFrame f;
    f.t = 0.01 * i;
    f.set(humanmodel::Joint::kHandLeft, at(f.t));
    r.frames.push_back(f);
  }
  return r;
}

TEST(PredictionTrial, StraightMotionIsPredicted) {
  const auto trials = tryPredictions(moving([](double t) { return Vector3d(1.5 * t, 0, 1); }), {1.6}, kAhead);
  ASSERT_EQ(trials.size(), 2u);
  // All but the first place have a velocity.
  EXPECT_EQ(trials[0].places, 195u);
  EXPECT_NEAR(trials[0].still_mean, 0.075, 1e-12);
  EXPECT_NEAR(trials[0].guess_mean, 0.075 / 195.0, 1e-12);
  EXPECT_NEAR(trials[0].guess_p95, 0.0, 1e-12);
  EXPECT_NEAR(trials[1].still_p95, 0.15, 1e-12);
  EXPECT_NEAR(trials[1].speed_needed, 1.5, 1e-9);
  EXPECT_EQ(trials[0].outside + trials[1].outside, 0u);
}

TEST(PredictionTrial, CountsBrokenBounds) {
  const auto trials = tryPredictions(moving([](double t) { return Vector3d(1.5 * t, 0, 1); }), {1.4}, kAhead);
  EXPECT_EQ(trials[0].outside, trials[0].places);
  // With a bound on the acceleration the reach set goes along: only the first place, without a velocity, is
  // out of it.
  const auto drifting =
      tryPredictions(moving([](double t) { return Vector3d(1.5 * t, 0, 1); }), {1.6, 1.0}, kAhead);
  EXPECT_EQ(drifting[0].outside, 1u);
}

TEST(PredictionTrial, ErrorIsDueToAcceleration) {
  const double a = 4.0;
  const auto trials =
      tryPredictions(moving([&](double t) { return Vector3d(0.5 * a * t * t, 0, 0); }), {}, kAhead);
  // The weights fall by 0.7 a step over 8 steps: the mean velocity is that of 2.1 steps ago, less the end of
  // the row; ahead h it misses a h (h / 2 + that age).
  double weight = 0.0, age = 0.0;
  for (int k = 0; k < 8; ++k) {
    weight += std::pow(0.7, k);
    age += std::pow(0.7, k) * (k + 0.5) * 0.01;
  }
  age /= weight;
  EXPECT_NEAR(trials[1].guess_p95, a * 0.1 * (0.05 + age), 1e-9);
}

TEST(PredictionTrial, IgnoresGapsAndGuessedJoints) {
  Recording r = moving([](double t) { return Vector3d(t, 0, 0); });
  for (int i = 50; i < 100; ++i)
    r.frames[static_cast<std::size_t>(i)].state[static_cast<std::size_t>(humanmodel::Joint::kHandLeft)] =
        humanmodel::JointState::kInferred;
  const auto trials = tryPredictions(r, {}, kAhead);
  // Of 50 places before the gap and 100 behind it, those whose later place lies in it or beyond the end do
  // not.
  EXPECT_EQ(trials[0].places, 45u + 95u);
  EXPECT_EQ(tryPredictions(Recording{}, {}, kAhead)[0].places, 0u);
}

}  // namespace prediction_trial_test
}  // namespace abstand::tracking
