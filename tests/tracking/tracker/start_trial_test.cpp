// Several candidates for the first body of a person, and paths of bodies.
#include "tracking/tracker/start_trial.hpp"

#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"

namespace abstand::tracking {
namespace start_trial_test {

constexpr double kEnd = 1.2, kUsualCost = 1e-3;  // s, m^2
constexpr double kNear = 0.15;                   // m, mean error of a pose that is right

/// A person alone in the image, who reaches forward.
class StartTrialOfReaching : public ::testing::Test {
 protected:
  /// Shows images to a trial, and returns the number of the last one.
  std::size_t run(StartTrial& trial) {
    std::size_t number = 0;
    for (DepthFrame frame; clip_.stream->next(frame); ++number) {
      std::vector<std::uint8_t> mask(frame.image.z.size());
      for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = frame.image.z[i] > 0.0f;
      const PersonImage image{&frame.image, &clip_.stream->camera(), mask};
      if (trial.see(number, frame.t, {&image, 1})) return number;
    }
    ADD_FAILURE() << "the trial does not end";
    return number;
  }
  std::shared_ptr<KnownBody> known() const {
    auto known = std::make_shared<KnownBody>();
    known->assumed.body.height = kStature;
    known->stature = Stature::given(kStature);
    known->facing.given = true;
    return known;
  }
  double error(const StartTrial::Seen& seen) const {
    double sum = 0.0;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      sum += (seen.body.frame.p[j] - clip_.truth[seen.number].p[j]).norm();
    return sum / humanmodel::kJointCount;
  }

  static constexpr double kStature = 1.75;  // m
  testing::SimulatedClip clip_ =
      testing::simulate({.recording = testing::projectFile("data/scenes/hug_reach.bvh"), .end = kEnd});
};

TEST_F(StartTrialOfReaching, KeepsTheBodiesOfTheBestCandidate) {
  StartTrial trial({}, known(), 0.0, kEnd, kUsualCost);
  const std::size_t last = run(trial);
  const double counted_from = StartTrial::kEvery * static_cast<double>(StartTrial::kSearches - 1);
  EXPECT_NEAR(clip_.truth[last].t, counted_from + StartTrial::kCounted, 1.0 / 30.0);
  const StartTrial::Candidate& best = trial.best();
  ASSERT_FALSE(best.seen.empty());
  EXPECT_EQ(best.seen.back().number, last);
  EXPECT_EQ(last - best.seen.front().number + 1, best.seen.size()) << "without a gap";
  EXPECT_LE(error(best.seen.front()), kNear);
  EXPECT_LE(error(best.seen.back()), kNear);
}

TEST_F(StartTrialOfReaching, EndsWithTheLastImageOfThePerson) {
  constexpr double kGone = 0.25;  // s
  StartTrial trial({}, known(), 0.0, kGone, kUsualCost);
  EXPECT_NEAR(clip_.truth[run(trial)].t, kGone, 1.0 / 30.0);
  EXPECT_FALSE(trial.best().seen.empty());
}

TEST_F(StartTrialOfReaching, BodyOnAWrongPathLosesToTheSearches) {
  const auto wrong = known();
  RigPose bowed;  // forward, where nobody is
  bowed.X_WP.translation() = Vector3d(0.3, 0.3, 0.8);
  bowed.X_WP.linear() = Eigen::AngleAxisd(0.8, Vector3d::UnitY()).toRotationMatrix();
  wrong->assumed.path.add(0.0, bowed);
  StartTrial trial({}, wrong, 0.0, kEnd, kUsualCost);
  run(trial);
  EXPECT_LE(error(trial.best().seen.back()), kNear);
}

TEST(BodyPath, FindsTheNearestPose) {
  BodyPath path;
  EXPECT_EQ(path.nearest(0.0), nullptr);
  EXPECT_EQ(path.start(), kInfinity);
  for (const double t : {1.0, 2.0, 4.0}) path.add(t, {});
  EXPECT_EQ(path.start(), 1.0);
  EXPECT_EQ(path.nearest(0.0)->t, 1.0);
  EXPECT_EQ(path.nearest(2.9)->t, 2.0);
  EXPECT_EQ(path.nearest(9.0)->t, 4.0);
}

TEST(BodyPath, KeepsTheFirstPoses) {
  BodyPath path;
  for (std::size_t i = 0; i <= BodyPath::kMaxPoses; ++i) path.add(static_cast<double>(i), {});
  EXPECT_EQ(path.nearest(1e6)->t, static_cast<double>(BodyPath::kMaxPoses - 1));
}

}  // namespace start_trial_test
}  // namespace abstand::tracking
