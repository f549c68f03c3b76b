// The certified distance of a tracked person in a scene is not above the true one.
#include <gtest/gtest.h>

#include <string_view>

#include "tests/tracking/tracker/captured_scenes.hpp"
#include "tests/tracking/tracker/certified_clip.hpp"
#include "tests/tracking/tracker/posed_scenes.hpp"

namespace abstand::tracking {
namespace certified_distance_test {

// The aim. scripts/tracking-table prints the figures of all clips.
constexpr double kHeld = 0.99;

void expectHeld(const std::string& name, const testing::SimulatedClip& clip) {
  const ClipTrack track = trackClip(*clip.stream, {});
  ASSERT_EQ(track.people.size(), 1u) << name;
  const testing::CertifiedDistances of = testing::certifiedDistances(clip, track);
  ASSERT_GT(of.truth.size(), 0u) << name;
  EXPECT_GE(of.held(), kHeld) << name << ", largest violation " << of.largestViolation() << " m";
  using testing::CertifiedDistances;
  EXPECT_LE(CertifiedDistances::medianSlack(of.certified, of.truth),
            CertifiedDistances::medianSlack(of.of_radius, of.truth))
      << "the direction of the nearest points is of use";
}

TEST(CertifiedDistance, IsNotAboveTrueOneOfCapture) {
  for (const testing::CapturedScene& scene : testing::hardScenes())
    if ((scene.name == "boxing_from_the_side" || scene.name == "dancing_short") &&
        exists(scene.plan.recording))
      expectHeld(scene.name, testing::simulate(scene.plan));
}

TEST(CertifiedDistance, IsNotAboveTrueOneBehindBench) {
  for (const testing::PosedScene& scene : testing::posedScenes())
    if (scene.name == "still_behind_a_bench") expectHeld(scene.name, testing::simulate(scene));
}

}  // namespace certified_distance_test
}  // namespace abstand::tracking
