// People on a chair and behind a bench, from several sides: the furniture is no part of them, and no person.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/tracking/tracker/posed_scenes.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {
namespace furniture_from_all_sides_test {

using testing::JointErrors;

constexpr double kWithin = 0.99, kHiddenWithin = 0.97;  // shares

struct Result {
  JointErrors errors;
  std::size_t found, images;
};

/// Of the only person.
Result track(const testing::PosedScene& scene) {
  auto clip = testing::simulate(scene);
  const ClipTrack track = trackClip(*clip.stream, {});
  EXPECT_EQ(track.people.size(), 1u) << scene.name;
  if (track.people.empty()) return {{}, 0, clip.truth.size()};
  return {testing::compare(track.people[0].frames, clip.truth), track.people[0].found, clip.truth.size()};
}

/// `kind`_from_ each of `sides` (degrees).
std::vector<testing::PosedScene> scenesOf(const std::string& kind, const std::vector<int>& sides) {
  std::vector<testing::PosedScene> scenes = testing::posturesFromAllSides();
  std::erase_if(scenes, [&](const testing::PosedScene& scene) {
    return std::none_of(sides.begin(), sides.end(),
                        [&](int side) { return scene.name == kind + "_from_" + std::to_string(side); });
  });
  return scenes;
}

// The end of the bench was a part of the person (424 and 514 mm from 90 and 270 degrees, 0.54 to 0.71 within
// their ellipsoids), and a part of it beside the person was a second one (from 135 degrees). Measured now: 31
// to 43 mm, and 0.96 to 1.00; without the bench in the images, it is 0.94 to 0.99, too.
TEST(FurnitureFromAllSides, BenchIsNoPartOfThePerson) {
  constexpr double kRawMean = 0.050;  // m, of tracked joints; the aim
  constexpr double kFromTheSide = 0.95;
  for (const testing::PosedScene& scene : scenesOf("bench", {90, 135, 270})) {
    const Result result = track(scene);
    EXPECT_EQ(result.found, result.images) << scene.name;
    EXPECT_LE(JointErrors::mean(result.errors.tracked.error), kRawMean) << scene.name;
    EXPECT_GE(result.errors.tracked.within(), kFromTheSide) << scene.name;
    EXPECT_GE(result.errors.inferred.within(), kHiddenWithin) << scene.name;
  }
}

// Without ChairSpace, 0.84 of the tracked joints of those who were found were within their ellipsoids, and
// from 225 degrees nobody was found.
TEST(FurnitureFromAllSides, ChairIsNoPartOfThePerson) {
  JointErrors::Stated tracked, inferred;
  for (const testing::PosedScene& scene : scenesOf("seated", {45, 135, 225, 315})) {
    const Result result = track(scene);
    EXPECT_EQ(result.found, result.images) << scene.name;
    tracked.add(result.errors.tracked);
    inferred.add(result.errors.inferred);
  }
  EXPECT_GE(tracked.within(), kWithin);
  EXPECT_GE(inferred.within(), kHiddenWithin);
}

}  // namespace furniture_from_all_sides_test
}  // namespace abstand::tracking
