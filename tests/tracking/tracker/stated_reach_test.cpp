// What is stated of a joint holds: the raw error, no offset taken off, lies within the reach of its spread.
#include <gtest/gtest.h>

#include "humanmodel/part_uncertainty.hpp"
#include "tests/tracking/tracker/captured_scenes.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {
namespace stated_reach_test {

using testing::JointErrors;

// Shares of the raw errors within reach. Measured over the clips below: 0.991 and 1.000; the aim is 0.99.
constexpr double kTracked = 0.985, kInferred = 0.985;
// A reach that is much larger than the errors stops robots needlessly: median of reach / error.
constexpr double kMaxRatio = 8.0;
constexpr std::size_t kEnoughHidden = 50;  // joints

TEST(StatedUncertainty, CoversErrorsOfTrackedAndInferredJoints) {
  JointErrors::Stated tracked, inferred;
  for (const auto& [name, plan] : testing::hardScenes()) {
    if (!exists(plan.recording)) continue;
    auto clip = testing::simulate(plan);
    const ClipTrack track = trackClip(*clip.stream, {});
    ASSERT_EQ(track.people.size(), 1u) << name;
    const JointErrors errors = testing::compare(track.people[0].frames, clip.truth);
    tracked.add(errors.tracked);
    inferred.add(errors.inferred);
    for (const humanmodel::SkeletonFrame& frame : track.people[0].frames)
      for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
        if (frame.state[j] == humanmodel::JointState::kInferred) {
          EXPECT_GE(humanmodel::partUncertainty(0.0, frame.spread[j]), HiddenSpread::kMin);
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
