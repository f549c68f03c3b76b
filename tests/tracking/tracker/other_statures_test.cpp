// People of unusual stature, and of a stature that their first posture does not show, tracked.
#include <gtest/gtest.h>

#include "tests/tracking/tracker/posed_scenes.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {
namespace other_statures_test {

constexpr double kStature = 0.04;                            // m
constexpr double kWithinReach = 0.99, kHiddenWithin = 0.97;  // shares
// m, raw mean of the tracked joints; of most others 0.018 to 0.046.
constexpr double kRawMean = 0.060;

struct OtherStatures : ::testing::TestWithParam<testing::PosedScene> {};

TEST_P(OtherStatures, AreMeasuredOrWithinAnInterval) {
  const testing::PosedScene& scene = GetParam();
  testing::SimulatedClip clip = testing::simulate(scene);
  const ClipTrack track = trackClip(*clip.stream, {});
  ASSERT_EQ(track.people.size(), 1u);
  const ClipPerson& person = track.people[0];
  EXPECT_EQ(person.found, clip.truth.size());
  // Who stands upright at some time.
  const bool stands =
      scene.postures.back().hips.z() > 0.9 && (scene.furniture.empty() || scene.name == "up_a_box");
  EXPECT_EQ(person.stature.known(), stands);
  if (person.stature.known()) {
    EXPECT_NEAR(person.stature.used, scene.stature, kStature);
  } else {
    EXPECT_LE(person.stature.interval[0], scene.stature);
    EXPECT_GE(person.stature.interval[1], scene.stature);
  }
  const testing::JointErrors errors = testing::compare(person.frames, clip.truth);
  EXPECT_GE(errors.tracked.within(), kWithinReach);
  EXPECT_GE(errors.inferred.within(), kHiddenWithin);
  EXPECT_LE(testing::JointErrors::mean(errors.tracked.error), kRawMean);
}

INSTANTIATE_TEST_SUITE_P(All, OtherStatures, ::testing::ValuesIn(testing::otherStatures()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace other_statures_test
}  // namespace abstand::tracking
