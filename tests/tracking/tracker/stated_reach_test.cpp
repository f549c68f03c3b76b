// What is stated of a joint holds: the raw error, no offset taken off, lies within the reach of its spread.
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {
namespace stated_reach_test {

using testing::ClipPlan;
using testing::JointErrors;

// Shares of the raw errors within reach. Measured over the clips below: 0.991 and 1.000; the aim is 0.99.
constexpr double kTracked = 0.985, kInferred = 0.985;
// A reach that is much larger than the errors stops robots needlessly: median of reach / error.
constexpr double kMaxRatio = 8.0;
constexpr double kMinInferred = 0.15;      // m, of the spread
constexpr std::size_t kEnoughHidden = 50;  // joints

std::vector<ClipPlan> hardClips() {
  const auto mocap = [](const char* file) { return testing::sharedData(std::string("mocap/bvh/") + file); };
  const auto boxing = testing::debianBvh("Boxing_Toes.bvh");
  const auto reach = testing::projectFile("data/scenes/hug_reach.bvh");
  return {
      // Fists before the trunk, seen from behind.
      {.recording = boxing, .start = 2.0, .end = 3.2, .eye = {-2.8, 0.0, 1.2}, .width = 240},
      // From the side: one arm and one leg hide the other.
      {.recording = boxing, .start = 12.0, .end = 13.2, .eye = {1.0, -2.6, 1.2}, .width = 240},
      {.recording = reach, .end = 1.2, .turn = 0.5 * kPi, .width = 240},
      // Hands on the hips, a foot behind the other leg.
      {.recording = mocap("rokoko_jesse_dance.bvh"), .end = 1.2, .eye = {3.2, 0.0, 1.2}, .width = 240},
      {.recording = mocap("cmu_jumping_jacks_3dsmax_names.bvh"), .end = 1.2, .width = 240},
      {.recording = mocap("mocapbank_test.bvh"),
       .start = 1.5,
       .end = 2.7,
       .eye = {-3.2, 0.0, 1.2},
       .width = 240},
  };
}

TEST(StatedUncertainty, CoversErrorsOfTrackedAndInferredJoints) {
  JointErrors::Stated tracked, inferred;
  for (const ClipPlan& plan : hardClips()) {
    if (!exists(plan.recording)) continue;
    auto clip = testing::simulate(plan);
    const ClipTrack track = trackClip(*clip.stream, {});
    ASSERT_EQ(track.people.size(), 1u) << plan.recording;
    const JointErrors errors = testing::compare(track.people[0].frames, clip.truth);
    tracked.add(errors.tracked);
    inferred.add(errors.inferred);
    for (const humanmodel::SkeletonFrame& frame : track.people[0].frames)
      for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
        if (frame.state[j] == humanmodel::JointState::kInferred) {
          EXPECT_GE(frame.spread[j], kMinInferred);
        }
  }
  for (const auto& [name, stated] : {std::pair{"tracked", &tracked}, {"inferred", &inferred}})
    std::printf("%s: %zu joints, %.4f of the raw errors within reach, median of reach / error %.1f\n", name,
                stated->error.size(), stated->within(), stated->medianRatio());
  EXPECT_GE(tracked.within(), kTracked);
  EXPECT_LE(tracked.medianRatio(), kMaxRatio);
  ASSERT_GE(inferred.error.size(), kEnoughHidden);
  EXPECT_GE(inferred.within(), kInferred);
}

}  // namespace stated_reach_test
}  // namespace abstand::tracking
