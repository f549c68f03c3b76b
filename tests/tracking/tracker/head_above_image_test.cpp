// A tall person so near that the head is above the image.
#include <gtest/gtest.h>

#include "tests/tracking/tracker/posed_scenes.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {
namespace head_above_image_test {

using testing::JointErrors;

constexpr double kWithin = 0.99, kHiddenWithin = 0.97;  // shares
constexpr double kMean = 0.050;                         // m, of tracked joints

TEST(HeadAboveTheImage, PersonIsFollowedWithWideReachOfTheHead) {
  for (const testing::PosedScene& scene : testing::heldOutScenes()) {
    if (scene.name != "other_near_1_3_m_tall") continue;
    auto clip = testing::simulate(scene);
    const ClipTrack track = trackClip(*clip.stream, {});
    ASSERT_EQ(track.people.size(), 1u);
    const ClipPerson& person = track.people[0];
    EXPECT_EQ(person.found, clip.truth.size());
    EXPECT_FALSE(person.stature.known());
    EXPECT_LE(person.stature.interval[0], scene.stature);
    EXPECT_GE(person.stature.interval[1], scene.stature);
    const JointErrors errors = testing::compare(person.frames, clip.truth);
    EXPECT_GE(errors.tracked.within(), kWithin);
    EXPECT_GE(errors.inferred.within(), kHiddenWithin);
    EXPECT_LE(JointErrors::mean(errors.tracked.error), kMean);
    const auto vertex = static_cast<std::size_t>(humanmodel::Joint::kHeadTop);
    for (const humanmodel::SkeletonFrame& frame : person.frames)
      if (frame.has(humanmodel::Joint::kHeadTop))
        EXPECT_EQ(frame.state[vertex], humanmodel::JointState::kInferred) << frame.t << " s";
    return;
  }
  FAIL() << "no such scene";
}

}  // namespace head_above_image_test
}  // namespace abstand::tracking
