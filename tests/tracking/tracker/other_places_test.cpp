// Postures seen from above, from low and from far.
#include <gtest/gtest.h>

#include "tests/tracking/tracker/posed_scenes.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {
namespace other_places_test {

using testing::JointErrors;

/// Of the only person, who is found in all images.
JointErrors errorsOf(const std::vector<testing::PosedScene>& scenes, const std::string& name) {
  const testing::SimulatedClip clip = testing::simulate(testing::sceneNamed(scenes, name));
  const ClipTrack track = trackClip(*clip.stream, {});
  EXPECT_EQ(track.people.size(), 1u) << name;
  if (track.people.empty()) return {};
  EXPECT_EQ(track.people[0].found, clip.truth.size()) << name;
  return testing::compare(track.people[0].frames, clip.truth);
}

/// From the side and above, one arm and one leg are hidden. Before these were lowered, they stood for each
/// other or explained the neck: 87 to 119 mm, and 0.83 to 0.999 of the joints were within their pose
/// uncertainty.
struct SeenFromAbove : ::testing::TestWithParam<const char*> {};

TEST_P(SeenFromAbove, HiddenLimbsHang) {
  constexpr double kRawMean = 0.050;                      // m, of tracked joints; the aim
  constexpr double kWithin = 0.99, kHiddenWithin = 0.97;  // shares
  const JointErrors errors = errorsOf(testing::posturesFromOtherPlaces(), GetParam());
  EXPECT_LE(JointErrors::mean(errors.tracked.error), kRawMean);
  EXPECT_GE(errors.tracked.within(), kWithin);
  EXPECT_GE(errors.inferred.within(), kHiddenWithin);
}

INSTANTIATE_TEST_SUITE_P(OtherPlaces, SeenFromAbove,
                         ::testing::Values("standing_above_from_270", "kneeling_above_from_90",
                                           "kneeling_above_from_270"));

// Bodies that face the camera explain too little of somebody behind the back of a chair: found in 24 and 39
// of 76 images before bodies that face away were searched for, too.
TEST(OtherPlaces, ShowSomebodyBehindTheBackOfAChair) {
  errorsOf(testing::posturesFromOtherPlaces(), "seated_high_from_225");
  errorsOf(testing::posturesFromAllSides(), "sitting_down_from_225");
}

// The back of a chair hides all but the head and the shoulders.
TEST(OtherPlaces, ShowHeadAndShouldersAlone) {
  const JointErrors errors = errorsOf(testing::posturesFromOtherPlaces(), "seated_low_from_180");
  EXPECT_GE(errors.tracked.within(), 0.99);
  EXPECT_GE(errors.inferred.within(), 0.97);
}

// Of somebody on the knees, far away, coarse images told the wrong front: 0.53 of the joints were covered.
TEST(OtherPlaces, DoNotTellTheFrontOfSomebodyFarAwayOnTheKnees) {
  const JointErrors errors = errorsOf(testing::posturesFromOtherPlaces(), "kneeling_far_from_45");
  EXPECT_GE(errors.tracked.within(), 0.99);
  EXPECT_GE(errors.inferred.within(), 0.97);
}

}  // namespace other_places_test
}  // namespace abstand::tracking
