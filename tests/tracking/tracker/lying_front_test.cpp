// People who lie on the front; which poses of people who lie count.
#include <gtest/gtest.h>

#include "tests/tracking/tracker/posed_scenes.hpp"
#include "tracking/tracker/clip_tracker.hpp"
#include "tracking/tracker/lying_start.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace lying_front_test {

using enum humanmodel::Joint;
using humanmodel::SkeletonFrame;
using testing::JointErrors;

constexpr double kWithin = 0.99, kHiddenWithin = 0.97;  // shares
constexpr double kHeadEnd = 0.3;                        // m; the other end is 1.5 m away
constexpr double kUnbiasedMean = 0.050;                 // m, measured: 0.044

testing::PosedScene sceneOf(const std::string& name) {
  return testing::sceneNamed(testing::heldOutScenes(), name);
}

class LyingOnTheFront : public ::testing::TestWithParam<const char*> {};

// Measured: 1.000 within. In `other_prone_feet_ahead_tall` lying on the back is assumed (mean error 0.41 m),
// and the reach covers both.
TEST_P(LyingOnTheFront, ReachCoversErrorsAndHeadIsAtItsEnd) {
  auto clip = testing::simulate(sceneOf(GetParam()));
  const ClipTrack track = trackClip(*clip.stream, {});
  ASSERT_EQ(track.people.size(), 1u);
  const std::vector<SkeletonFrame>& frames = track.people[0].frames;
  const JointErrors errors = testing::compare(frames, clip.truth);
  EXPECT_GE(errors.tracked.within(), kWithin);
  EXPECT_GE(errors.inferred.within(), kHiddenWithin);
  if (GetParam() == std::string("other_lying_on_the_front"))
    EXPECT_LE(JointErrors::mean(errors.tracked.error), kUnbiasedMean);
  EXPECT_EQ(track.people[0].found, clip.truth.size());
  for (const SkeletonFrame& frame : frames)
    EXPECT_LE((frame[kHeadTop] - clip.truth.front()[kHeadTop]).norm(), kHeadEnd) << frame.t << " s";
}

INSTANTIATE_TEST_SUITE_P(People, LyingOnTheFront,
                         ::testing::Values("other_lying_on_the_front", "other_prone_arms_down_tall",
                                           "other_prone_arms_up_tall", "other_prone_feet_ahead_tall",
                                           "other_prone_seen_from_above_small"));

class LyingPoses : public ::testing::Test {
 protected:
  static RigPose lying(bool on_front) {
    RigPose pose;
    const Vector3d x = (on_front ? -1.0 : 1.0) * Vector3d::UnitZ(), head = Vector3d::UnitX();
    pose.X_WP.linear() << x, head.cross(x), head;
    return pose;
  }
  bool add(double cost, const RigPose& pose, bool on_front, double gap = 0.0) {
    RigPlacement X_WS;
    place(rig_, pose, X_WS);
    std::array<double, kRigSegments> gaps{};
    gaps[index(RigSegment::kForearmLeft)] = gap;
    return fits_.add(cost, X_WS, gaps, on_front);
  }
  const BodyRig rig_ = makeRig(humanmodel::makeHuman({}));
  LyingFits fits_{rig_};
};

TEST_F(LyingPoses, SidesAreToldApartByTheCost) {
  EXPECT_TRUE(add(1.0, lying(false), false));
  EXPECT_FALSE(fits_.sidesAlike()) << "one side only";
  EXPECT_TRUE(add(1.1, lying(true), true));
  EXPECT_TRUE(fits_.sidesAlike());
  EXPECT_FALSE(fits_.onFront());
  EXPECT_DOUBLE_EQ(fits_.frontOverBack(), 1.1);
  EXPECT_TRUE(add(0.5, lying(true), true));
  EXPECT_FALSE(fits_.sidesAlike());
  EXPECT_TRUE(fits_.onFront());
}

TEST_F(LyingPoses, ArmThroughTheTrunkIsNotTheBest) {
  EXPECT_TRUE(add(1.0, lying(true), true, -0.08));
  EXPECT_TRUE(add(1.1, lying(true), true));
  EXPECT_FALSE(add(1.05, lying(true), true, -0.08));
}

TEST_F(LyingPoses, ReachIncludesPosesThatAreAlike) {
  RigPose moved = lying(true), far = lying(true);
  moved.X_WP.translation().x() += 0.4;
  far.X_WP.translation().x() += 0.9;
  add(1.0, lying(true), true);
  add(1.7, moved, true);
  add(1.8, far, true);
  for (const double apart : fits_.apart()) EXPECT_NEAR(apart, 0.4, 1e-9);
}

TEST(LyingTurnedRound, FeetPointToTheOtherSideOfTheTrunk) {
  SkeletonFrame back;
  back.set(kPelvis, {0.0, 0.0, 0.1});
  back.set(kNeck, {0.5, 0.0, 0.1});
  back.set(kHipLeft, {0.0, -0.1, 0.1});
  back.set(kHipRight, {0.0, 0.1, 0.1});
  for (const double side : {1.0, -1.0}) {
    back.set(side > 0.0 ? kAnkleLeft : kAnkleRight, {-0.9, -0.1 * side, 0.1});
    back.set(side > 0.0 ? kToeLeft : kToeRight, {-1.0, -0.1 * side, 0.2});
  }
  const SkeletonFrame front = flippedFacing(back);
  EXPECT_TRUE(front[kHipLeft].isApprox(back[kHipRight]));
  EXPECT_TRUE(front[kToeLeft].isApprox(Vector3d(-1.0, 0.1, 0.0)));
  EXPECT_EQ(mirrored(kToeLeft), kToeRight);
  EXPECT_EQ(mirrored(kNeck), kNeck);
}

}  // namespace lying_front_test
}  // namespace abstand::tracking
