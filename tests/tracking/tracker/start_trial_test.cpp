// Several candidates for the first body of a person, and paths of bodies.
#include "tracking/tracker/start_trial.hpp"

#include <gtest/gtest.h>

#include "humanmodel/joint_covariance.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace start_trial_test {

constexpr double kEnd = 1.2, kUsualCost = 1e-3;  // s, m^2
constexpr double kNear = 0.15;                   // m, mean error of a pose that is right
constexpr double kStep = 1.0 / 30.0;             // s

/// A person alone in the image, who reaches forward.
class StartTrialOfReaching : public ::testing::Test {
 protected:
  /// The images until `end` (s).
  std::vector<KeptMoment> moments(double end) {
    std::vector<KeptMoment> moments;
    for (DepthFrame frame; clip_.stream->next(frame) && frame.t < end + 0.5 * kStep;) {
      std::vector<std::uint8_t> mask(frame.image.z.size());
      for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = frame.image.z[i] > 0.0f;
      moments.push_back({moments.size(), frame.t, 0.0});
      moments.back().add({&frame.image, &clip_.stream->camera(), mask},
                         std::make_shared<const DepthFrame>(frame));
    }
    return moments;
  }
  std::shared_ptr<KnownBody> known() const {
    auto known = std::make_shared<KnownBody>();
    known->assumed.body.height = kStature;
    known->stature = Stature::given(kStature);
    known->facing.given = true;
    return known;
  }
  /// As of a first pass that decided, with this ratio (Facing::ratio).
  std::shared_ptr<KnownBody> decided(double ratio) const {
    const auto known = this->known();
    known->facing = {.away = ratio < 1.0, .ratio = ratio};
    return known;
  }
  static StartTrial::Result ranWith(StartTrial trial, std::vector<KeptMoment> moments) {
    trial.add(std::move(moments));
    return trial.run();
  }
  double error(const StartTrial::Result& result, std::size_t number) const {
    double sum = 0.0;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      sum += (result.bodies[number].frame.p[j] - clip_.truth[number].p[j]).norm();
    return sum / humanmodel::kJointCount;
  }
  void expectNear(const StartTrial::Result& result) const {
    ASSERT_FALSE(result.bodies.empty());
    for (std::size_t i = 0; i < result.bodies.size(); ++i) {
      EXPECT_TRUE(result.bodies[i].found) << i;
      EXPECT_LE(error(result, i), kNear) << i;
    }
  }

  static constexpr double kStature = 1.75;  // m
  testing::SimulatedClip clip_ =
      testing::simulate({.recording = testing::projectFile("data/scenes/hug_reach.bvh"), .end = kEnd});
};

TEST_F(StartTrialOfReaching, FindsThePersonInAllImages) {
  const StartTrial trial({}, known(), 0.0, kUsualCost);
  const double last_start = StartTrial::kEvery * static_cast<double>(StartTrial::kSearches - 1);
  EXPECT_NEAR(trial.end(), last_start + StartTrial::kCounted, 1e-12);
  expectNear(ranWith(trial, moments(trial.end())));
}

TEST_F(StartTrialOfReaching, TracksImagesBeforeTheStart) {
  constexpr double kStart = 0.2;  // s
  expectNear(ranWith(StartTrial({}, known(), kStart, kUsualCost), moments(0.6)));
}

TEST_F(StartTrialOfReaching, UsesTheFewImagesThereAre) {
  expectNear(ranWith(StartTrial({}, known(), 0.0, kUsualCost), moments(0.25)));
}

TEST_F(StartTrialOfReaching, NeedsNoUsualCost) {
  expectNear(ranWith(StartTrial({}, known(), 0.0, kInfinity), moments(0.4)));
}

TEST_F(StartTrialOfReaching, BodyOnAWrongPathLosesToTheSearches) {
  const auto wrong = known();
  RigPose bowed;  // forward, where nobody is
  bowed.X_WP.translation() = Vector3d(0.3, 0.3, 0.8);
  bowed.X_WP.linear() = Eigen::AngleAxisd(0.8, Vector3d::UnitY()).toRotationMatrix();
  wrong->assumed.path.add(0.0, bowed);
  expectNear(ranWith(StartTrial({}, wrong, 0.0, kUsualCost), moments(0.7)));
}

TEST_F(StartTrialOfReaching, BodyThatFacesTheOtherWayRefutesAWrongDecision) {
  const auto wrong = decided(0.7);
  RigPose away;
  away.X_WP.translation() = clip_.truth[0][humanmodel::Joint::kPelvis];
  away.X_WP.linear() = Eigen::AngleAxisd(kPi, Vector3d::UnitZ()).toRotationMatrix();
  wrong->assumed.path.add(0.0, away);
  const StartTrial::Result result = ranWith(StartTrial({}, wrong, 0.0, kUsualCost), moments(0.7));
  expectNear(result);
  const Facing& facing = result.tracker->facing();
  EXPECT_FALSE(facing.away);
  EXPECT_GT(facing.ratio, 1.0);
  EXPECT_FALSE(facing.decided()) << "the first pass saw the opposite";
}

// Both bodies are the person's until later images decide.
TEST_F(StartTrialOfReaching, UndecidedDirectionIsDecidedByLaterImages) {
  clip_ = testing::simulate({.recording = testing::projectFile("data/scenes/hug_reach.bvh"), .end = 2.5});
  StartTrial::Result result = ranWith(StartTrial({}, decided(0.75), 0.0, kUsualCost), moments(0.7));
  ASSERT_TRUE(result.contradicts_first);
  ASSERT_FALSE(result.tracker->facing().decided());
  EXPECT_TRUE(result.tracker->comparesFacings());
  const humanmodel::SkeletonFrame& frame = result.bodies.back().frame;
  using enum humanmodel::Joint;
  const Vector3d across = frame[kShoulderRight] - frame[kShoulderLeft];
  EXPECT_GE(humanmodel::reachAlong(humanmodel::covarianceOf(frame, kShoulderLeft), across.normalized()),
            across.norm())
      << "the other shoulder is there if the person faces the other way";
  for (const KeptMoment& moment : moments(2.5))
    EXPECT_TRUE(result.tracker->see(moment.t, moment.views())->found);
  EXPECT_TRUE(result.tracker->facing().decided());
  EXPECT_FALSE(result.tracker->facing().away);
  EXPECT_FALSE(result.tracker->comparesFacings());
}

TEST_F(StartTrialOfReaching, LongerTrialDecidesAlone) {
  clip_ = testing::simulate({.recording = testing::projectFile("data/scenes/hug_reach.bvh"), .end = 2.5});
  StartTrial trial({}, decided(0.75), 0.0, kUsualCost);
  const double end = trial.end();
  trial.add(moments(end));
  ASSERT_TRUE(trial.run().contradicts_first);
  EXPECT_TRUE(trial.extend());
  EXPECT_GT(trial.end(), end);
  EXPECT_FALSE(trial.extend()) << "once";
  trial.add(moments(trial.end()));
  const StartTrial::Result result = trial.run();
  expectNear(result);
  EXPECT_EQ(result.bodies.size(), trial.moments().size());
  EXPECT_FALSE(result.contradicts_first);
  EXPECT_TRUE(result.tracker->facing().decided());
  EXPECT_FALSE(result.tracker->facing().away);
}

TEST_F(StartTrialOfReaching, KeepsARightDecision) {
  const StartTrial::Result result = ranWith(StartTrial({}, decided(1.3), 0.0, kUsualCost), moments(0.7));
  expectNear(result);
  EXPECT_FALSE(result.tracker->facing().away);
  EXPECT_EQ(result.tracker->facing().ratio, 1.3);
}

TEST_F(StartTrialOfReaching, KeepsADirectionThatIsGiven) {
  const auto given = known();
  given->facing.away = true;
  const StartTrial::Result result = ranWith(StartTrial({}, given, 0.0, kUsualCost), moments(0.7));
  EXPECT_TRUE(result.tracker->facing().away);
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

TEST(BodyPath, TurnsRoundInPlace) {
  RigPose pose;
  pose.X_WP.translation() = Vector3d(1.0, 2.0, 3.0);
  pose.X_WP.linear() = Eigen::AngleAxisd(0.5, Vector3d::UnitZ()).toRotationMatrix();
  BodyPath path;
  path.add(1.0, pose);
  path.turn();
  const RigPose& turned = path.nearest(1.0)->pose;
  EXPECT_EQ(turned.X_WP.translation(), pose.X_WP.translation());
  EXPECT_NEAR(yawOf(turned), 0.5 - kPi, 1e-12);
}

}  // namespace start_trial_test
}  // namespace abstand::tracking
