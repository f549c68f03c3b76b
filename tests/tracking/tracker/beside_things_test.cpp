// People beside things that are there from the first image on: things are no limbs, and nobody else.
#include "tests/tracking/tracker/beside_things.hpp"

#include <gtest/gtest.h>

#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {
namespace beside_things_test {

using testing::JointErrors;

/// Before ThingsBeside, each of these was lost, fitted to the thing, or had a second person beside it.
struct Beside : ::testing::TestWithParam<const char*> {};

TEST_P(Beside, ThingIsNoLimb) {
  constexpr double kRawMean = 0.050;                      // m, of tracked joints; the aim
  constexpr double kWithin = 0.99, kHiddenWithin = 0.97;  // shares
  const testing::SimulatedClip clip =
      testing::simulate(testing::sceneNamed(testing::scenesBesideThings(), GetParam()));
  const ClipTrack track = trackClip(*clip.stream, {});
  ASSERT_EQ(track.people.size(), 1u);
  EXPECT_EQ(track.people[0].found, clip.truth.size());
  const JointErrors errors = testing::compare(track.people[0].frames, clip.truth);
  EXPECT_LE(JointErrors::mean(errors.tracked.error), kRawMean);
  EXPECT_GE(errors.tracked.within(), kWithin);
  EXPECT_GE(errors.inferred.within(), kHiddenWithin);
}

INSTANTIATE_TEST_SUITE_P(Things, Beside,
                         ::testing::Values("beside_chair_at_90", "beside_chair_at_135", "beside_crate_at_315",
                                           "beside_cupboard_at_90", "beside_stand_at_45"));

}  // namespace beside_things_test
}  // namespace abstand::tracking
