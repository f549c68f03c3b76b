// A body that is followed where the person is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/support/paths.hpp"
#include "tests/tracking/tracker/posed_scenes.hpp"
#include "tests/tracking/tracker/seated_pose.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"
#include "tracking/tracker/body_tracker.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace searched_again_test {

constexpr double kNear = 0.15;  // m, mean error of a pose that is right

testing::SimulatedClip seatedClip() {
  const testing::PosedScene seated = testing::sceneNamed(testing::posturesFromAllSides(), "seated_from_45");
  return testing::simulate({.recording = {}, .eye = seated.eye}, testing::posedFrames(seated.postures), {});
}

/// A person alone in the image, who sits, and a tracker that takes up the body at a place.
struct SearchedAgain : ::testing::Test {
  void SetUp() override {
    start = seatedPose(rig);
    start.X_WP.translation() = clip.truth[0][humanmodel::Joint::kPelvis];
  }
  const TrackedBody& trackNext() {
    EXPECT_TRUE(clip.stream->next(frame));
    return track();
  }
  const TrackedBody& track() {
    mask.resize(frame.image.z.size());
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = frame.image.z[i] > 0.0f;
    const PersonImage image{&frame.image, &clip.stream->camera(), mask};
    return tracker.track(frame.t, {&image, 1});
  }
  double error(std::size_t number) const {
    double sum = 0.0;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      sum += (tracker.body().frame.p[j] - clip.truth[number].p[j]).norm();
    return sum / humanmodel::kJointCount;
  }

  testing::SimulatedClip clip = seatedClip();
  BodyRig rig = makeRig(humanmodel::makeHuman({}));
  BodyTracker tracker{rig, 1};
  RigPose start;
  DepthFrame frame;
  std::vector<std::uint8_t> mask;
};

TEST_F(SearchedAgain, BodyIsReplacedThatExplainsTheImageBadly) {
  start.X_WP.translation() += Vector3d(0.0, 1.5, -0.4);
  tracker.resume(start, {}, 0.0);
  EXPECT_TRUE(trackNext().found);
  EXPECT_TRUE(tracker.wasReplaced());
  EXPECT_LE(error(0), kNear);
  EXPECT_TRUE(trackNext().found);
  EXPECT_FALSE(tracker.wasReplaced()) << "in one image only";
}

// As after bending to the floor close to a camera: before, only bodies that sit replaced others.
TEST_F(SearchedAgain, BodyIsReplacedThatExplainsHardlyAnything) {
  clip = testing::simulate({.recording = testing::projectFile("data/scenes/hug_reach.bvh"), .end = 0.5});
  RigPose low = seatedPose(rig);
  low.X_WP.translation() = clip.truth[0][humanmodel::Joint::kPelvis] - Vector3d(0.5, 0.0, 0.6);
  tracker.resume(low, {}, 0.0);
  EXPECT_TRUE(trackNext().found);
  EXPECT_TRUE(tracker.wasReplaced());
  EXPECT_LE(error(0), kNear);
}

// Whether somebody kneels or sits is asked before the next fit: of memory that was not set before.
TEST_F(SearchedAgain, ResumedBodyIsPlaced) {
  tracker.resume(start, {}, 0.0);
  RigPlacement X_WS;
  place(rig, start, X_WS);
  for (std::size_t s = 0; s < kRigSegments; ++s) EXPECT_TRUE(tracker.body().X_WS[s].isApprox(X_WS[s])) << s;
}

TEST_F(SearchedAgain, BodyFacesAsExpected) {
  tracker.expectFacing(kPi);
  trackNext();
  ASSERT_TRUE(std::isfinite(tracker.body().misfit.cost)) << "although facing 0 explains the image better";
  EXPECT_LE(std::cos(yawOf(tracker.body().pose)), 0.0);
}

// A search takes as long as ten images: a wall that passes for a person must not take all of the time.
TEST_F(SearchedAgain, WallIsSearchedLessOften) {
  constexpr int kImages = 30, kEach = 10;
  ASSERT_TRUE(clip.stream->next(frame));
  const std::vector<float> person = frame.image.z;
  std::fill(frame.image.z.begin(), frame.image.z.end(), 2.5f);
  int searched = 0;
  for (int i = 0; i < kImages; ++i) {
    frame.t = i / 30.0;
    EXPECT_FALSE(track().found) << i;
    searched += tracker.searchedInVain();
    if (i < kEach) EXPECT_EQ(searched, i + 1);
  }
  EXPECT_GT(searched, kEach);
  EXPECT_LE(searched, kEach + (kImages - kEach) / 4);
  const std::vector<float> wall = std::exchange(frame.image.z, std::vector<float>(person.size(), 0.0f));
  EXPECT_FALSE(track().found);
  EXPECT_FALSE(tracker.searchedInVain()) << "nothing to search";
  frame.image.z = wall;
  for (int i = 0; i < 3; ++i) {
    frame.t += 1.0 / 30.0;
    track();
    EXPECT_TRUE(tracker.searchedInVain()) << "in view again, image " << i;
  }
  frame.image.z = person;
  frame.t += 0.3;  // s; any wait is over
  EXPECT_TRUE(track().found);
}

TEST_F(SearchedAgain, BodyThatExplainsTheImageIsFollowed) {
  tracker.resume(start, {}, 0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(trackNext().found);
    EXPECT_FALSE(tracker.wasReplaced()) << i;
    EXPECT_LE(error(i), kNear) << i;
  }
}

}  // namespace searched_again_test
}  // namespace abstand::tracking
