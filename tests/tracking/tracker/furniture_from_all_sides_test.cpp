// People on a chair and behind a bench, from several sides: the furniture is no part of them, and no person.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/tracking/tracker/captured_scenes.hpp"
#include "tests/tracking/tracker/posed_scenes.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {
namespace furniture_from_all_sides_test {

using testing::JointErrors;

constexpr double kWithin = 0.99, kHiddenWithin = 0.97;  // shares
constexpr double kRawMean = 0.050;                      // m, of tracked joints; the aim

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

/// Of tracked and inferred joints of several clips.
struct Stated {
  JointErrors::Stated tracked, inferred;
};

/// Each clip has a body in all images, and a raw mean of at most `raw_mean` (m).
Stated trackAll(const std::vector<testing::PosedScene>& scenes, double raw_mean = kInfinity) {
  Stated all;
  for (const testing::PosedScene& scene : scenes) {
    const Result result = track(scene);
    EXPECT_EQ(result.found, result.images) << scene.name;
    EXPECT_LE(JointErrors::mean(result.errors.tracked.error), raw_mean) << scene.name;
    all.tracked.add(result.errors.tracked);
    all.inferred.add(result.errors.inferred);
  }
  return all;
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
  const Stated stated = trackAll(scenesOf("seated", {45, 135, 225, 315}));
  EXPECT_GE(stated.tracked.within(), kWithin);
  EXPECT_GE(stated.inferred.within(), kHiddenWithin);
}

// Far legs were fitted to the surface of near ones: 0.71 to 0.80 of the tracked joints within their
// ellipsoids. Measured: 0.98 to 1.00.
TEST(FurnitureFromAllSides, LegsThatHideEachOtherAreBesideEachOther) {
  std::vector<testing::PosedScene> scenes = scenesOf("seated", {90, 270});
  scenes.push_back(scenesOf("standing_up", {90}).front());
  const Stated stated = trackAll(scenes);
  EXPECT_LE(JointErrors::mean(stated.tracked.error), kRawMean);
  EXPECT_GE(stated.tracked.within(), kWithin);
  EXPECT_GE(stated.inferred.within(), kHiddenWithin);
}

// The chair beside somebody who stands was a part of the body, which was not found in 37 of 76 images.
TEST(FurnitureFromAllSides, ChairIsKnownBeforeSomebodySitsDown) {
  const Stated stated = trackAll(scenesOf("sitting_down", {45, 135, 315}), kRawMean);
  EXPECT_GE(stated.tracked.within(), kWithin);
  EXPECT_GE(stated.inferred.within(), kHiddenWithin);
}

// A chair that somebody leaves was a second person in 96 to 121 of 121 images, in four of six similar clips.
TEST(FurnitureFromAllSides, ChairThatIsLeftIsNoPerson) {
  const std::vector<testing::FurnitureBox> chair{{{-0.67, -0.22, 0.37}, {-0.23, 0.22, 0.41}},
                                                 {{-0.71, -0.22, 0.0}, {-0.67, 0.22, 0.95}}};
  int seen = 0;
  for (const testing::CapturedScene& scene : testing::scenesFromAllSides()) {
    if (scene.name != "walking_from_90" && scene.name != "walking_from_180") continue;
    if (!exists(scene.plan.recording)) continue;
    ++seen;
    testing::ClipPlan plan = scene.plan;
    plan.end = plan.start + 3.0;
    plan.room = true;
    const auto clip = testing::simulate(plan, testing::simulate(plan).truth, chair);
    const ClipTrack track = trackClip(*clip.stream, {});
    ASSERT_EQ(track.people.size(), 1u) << scene.name;
    EXPECT_GE(testing::compare(track.people[0].frames, clip.truth).tracked.within(), 0.95) << scene.name;
  }
  if (seen == 0) GTEST_SKIP() << "no captures";
}

}  // namespace furniture_from_all_sides_test
}  // namespace abstand::tracking
