// What is stated of a joint holds: the raw error, no offset taken off, lies within the reach of its spread.
#include <gtest/gtest.h>

#include "humanmodel/part_uncertainty.hpp"
#include "tests/tracking/tracker/captured_scenes.hpp"
#include "tests/tracking/tracker/posed_scenes.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {
namespace stated_reach_test {

using testing::JointErrors;

// Shares of the raw errors within reach. Measured over the clips below: 0.999 and 1.000 (tracked without
// JointMotion: 0.996).
constexpr double kTracked = 0.9975, kInferred = 0.985;
// The aim, for every clip. Measured: 0.995; without JointMotion 0.983.
constexpr double kTrackedOfClip = 0.99;
// Median of reach / error of a seated person of unknown stature. Measured: 7.2; 10.2 when visible joints were
// given the same share of the stature's deviation as hidden ones.
constexpr double kMaxRatioSeated = 8.0;
// A reach that is much larger than the errors stops robots needlessly: median of reach / error.
constexpr double kMaxRatio = 8.0;
// Likewise of a person whom the body explains well. Measured: 3.6; 4.8 with the constants of doubtful fits.
constexpr double kMaxRatioOfGoodFit = 4.0;
constexpr std::size_t kEnoughHidden = 50;  // joints

TEST(StatedUncertainty, CoversErrorsOfTrackedAndInferredJoints) {
  JointErrors::Stated tracked, inferred;
  for (const auto& [name, plan, furniture] : testing::hardScenes()) {
    if (!exists(plan.recording)) continue;
    auto clip = testing::simulate(plan);
    const ClipTrack track = trackClip(*clip.stream, {});
    ASSERT_EQ(track.people.size(), 1u) << name;
    const JointErrors errors = testing::compare(track.people[0].frames, clip.truth);
    EXPECT_GE(errors.tracked.within(), kTrackedOfClip) << name;
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

// People in motion, and those who sit, from behind and from the side: the first search often finds a wrong
// pose, and the back was taken for the front. Decided facings are right. Measured: 0.995, 0.994 (aim: 0.99,
// 0.97; docs/tracking.md has all clips).
TEST(StatedUncertainty, CoversPeopleFromAllSides) {
  constexpr double kTrackedFromAllSides = 0.98, kInferredFromAllSides = 0.96;
  constexpr double kTurnedRound = 0.3;  // s
  constexpr int kEnoughDecided = 10;
  int decided = 0;
  JointErrors::Stated tracked, inferred;
  for (const auto& [name, plan, furniture] : testing::scenesFromAllSides()) {
    if (!exists(plan.recording)) continue;
    if (!name.starts_with("boxing") && !name.starts_with("jumping") && !name.starts_with("sitting")) continue;
    if (name.ends_with("_0") || name.ends_with("45") || name.ends_with("_90") || name.ends_with("315"))
      continue;
    auto clip = testing::simulate(plan);
    const ClipTrack track = trackClip(*clip.stream, {});
    ASSERT_FALSE(track.people.empty()) << name;
    const JointErrors errors = testing::compare(track.people[0].frames, clip.truth);
    tracked.add(errors.tracked);
    inferred.add(errors.inferred);
    if (!track.people[0].facing.decided()) continue;
    ++decided;
    EXPECT_LE(errors.longest_swap, kTurnedRound) << name;
  }
  std::printf("from all sides: %zu joints, %.4f of the raw errors within reach, of inferred ones %.4f\n",
              tracked.error.size(), tracked.within(), inferred.within());
  if (tracked.error.empty()) GTEST_SKIP() << "no capture";
  EXPECT_GE(decided, kEnoughDecided) << "of 12 clips";
  EXPECT_GE(tracked.within(), kTrackedFromAllSides);
  EXPECT_GE(inferred.within(), kInferredFromAllSides);
}

TEST(StatedUncertainty, IsSmallWhereTheBodyExplainsThePersonWell) {
  for (const auto& [name, plan, furniture] : testing::capturedScenes()) {
    if (name != "reaching") continue;
    if (!exists(plan.recording)) GTEST_SKIP();
    auto clip = testing::simulate(plan);
    const ClipTrack track = trackClip(*clip.stream, {});
    ASSERT_EQ(track.people.size(), 1u);
    const JointErrors errors = testing::compare(track.people[0].frames, clip.truth);
    EXPECT_GE(errors.tracked.within(), kTrackedOfClip);
    EXPECT_LE(errors.tracked.medianRatio(), kMaxRatioOfGoodFit);
    return;
  }
  FAIL() << "no such capture";
}

// With these seeds of the search, an arm was at a wrong place for some images, and certain of it: 0.959 to
// 0.986 of the tracked joints were within reach.
TEST(StatedUncertainty, CoversArmsThatTheSearchPutElsewhere) {
  const std::pair<const char*, std::uint64_t> cases[] = {{"near_hands_over_the_image", 2},
                                                         {"near_hands_over_the_image", 3},
                                                         {"lying_down", 3},
                                                         {"other_prone_arms_up_tall", 2}};
  std::vector<testing::PosedScene> scenes = testing::posedScenes();
  for (testing::PosedScene& scene : testing::heldOutScenes()) scenes.push_back(std::move(scene));
  for (const auto& [clip_name, seed] : cases) {
    const std::string name = clip_name;
    auto clip = testing::simulate(testing::sceneNamed(scenes, name));
    ClipTrackerOptions options;
    options.person.seed = seed;
    const ClipTrack track = trackClip(*clip.stream, options);
    ASSERT_EQ(track.people.size(), 1u) << name;
    EXPECT_GE(testing::compare(track.people[0].frames, clip.truth).tracked.within(), kTrackedOfClip)
        << name << ", seed " << seed;
  }
}

TEST(StatedUncertainty, OfUnknownStatureIsSmallForVisibleJoints) {
  for (const testing::PosedScene& scene : testing::posedScenes()) {
    if (scene.name != "seated") continue;
    auto clip = testing::simulate(scene);
    const ClipTrack track = trackClip(*clip.stream, {});
    ASSERT_EQ(track.people.size(), 1u);
    EXPECT_FALSE(track.people[0].stature.known());
    const JointErrors errors = testing::compare(track.people[0].frames, clip.truth);
    EXPECT_GE(errors.tracked.within(), kTrackedOfClip);
    EXPECT_LE(errors.tracked.medianRatio(), kMaxRatioSeated);
    return;
  }
  FAIL() << "no seated person";
}

}  // namespace stated_reach_test
}  // namespace abstand::tracking
