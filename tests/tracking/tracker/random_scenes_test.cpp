// Clips drawn at random in which the body had been wrong, or lost.
#include "tests/tracking/tracker/random_scenes.hpp"

#include <gtest/gtest.h>

#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {
namespace random_scenes_test {

constexpr double kWithin = 0.98, kHiddenWithin = 0.97;  // shares; one clip of seed 1 has 0.987

struct Drawn {
  std::size_t clip;  // of seed 1
  double found;      // share of the images, at least
  const char* what;
};

struct RandomScenes : ::testing::TestWithParam<Drawn> {};

TEST_P(RandomScenes, JointsAreWithinTheirReach) {
  const auto& [number, found, what] = GetParam();
  const std::vector<testing::RandomScene> scenes = testing::randomScenes(1, 60);
  const std::string name = "random_1_" + std::to_string(number);
  testing::SimulatedClip clip = testing::sceneNamed(scenes, name).make();
  const ClipTrack track = trackClip(*clip.stream, {});
  ASSERT_FALSE(track.people.empty());
  const ClipPerson& person = track.people[0];
  EXPECT_GE(static_cast<double>(person.found), found * static_cast<double>(clip.truth.size()));
  const testing::JointErrors errors = testing::compare(person.frames, clip.truth);
  EXPECT_GE(errors.tracked.within(), kWithin);
  EXPECT_GE(errors.inferred.within(), kHiddenWithin);
}

INSTANTIATE_TEST_SUITE_P(Seed1, RandomScenes,
                         ::testing::Values(Drawn{8, 1.0, "RaisedHandSeenFromTheSide"},
                                           Drawn{17, 0.8, "SquatsAndRises"},
                                           Drawn{19, 1.0, "CutOffAtTheChest"},
                                           Drawn{24, 1.0, "KneelsWithRaisedHands"},
                                           Drawn{37, 0.55, "BendsAtFirst"}),
                         [](const auto& tested) { return std::string(tested.param.what); });

}  // namespace random_scenes_test
}  // namespace abstand::tracking
