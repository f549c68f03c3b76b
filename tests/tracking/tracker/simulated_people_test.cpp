// Real captures, worn by a body that is not the model, seen by a simulated Kinect, and tracked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tests/tracking/tracker/captured_scenes.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {
namespace simulated_people_test {

using testing::ClipPlan;
using testing::JointErrors;

// Raw errors; and those once each joint's constant offset is taken off, as recordings do not mean the same
// point by a shoulder or a hip.
constexpr double kRawMean = 0.060, kRawP95 = 0.165;  // m
constexpr double kMean = 0.035, kP95 = 0.080;        // m
constexpr double kSeenMean = 0.080;                  // m, raw, from behind
constexpr double kHiddenBehind = 0.95;               // within reach; from behind, the trunk hides fists
constexpr double kLongestSwap = 0.2;                 // s
constexpr double kWithinReach = 0.99;                // of the raw errors of tracked joints
constexpr double kHiddenWithin = 0.97;               // of those of inferred ones
constexpr double kMaxLost = 0.01;                    // of the images

constexpr std::size_t kLate = 6;  // images until a head is found, as beside a waving hand

struct Case {
  testing::CapturedScene scene;
  double mean{kMean}, p95{kP95}, raw_mean{kRawMean}, raw_p95{kRawP95}, within_reach{kWithinReach};
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.scene.name; }

std::vector<Case> cases() {
  std::vector<Case> out;
  for (testing::CapturedScene& scene : testing::capturedScenes()) {
    Case c{std::move(scene)};
    // Its pelvis is 0.2 m from what other captures mean by it.
    if (c.scene.name == "jumping_jacks") c.within_reach = 0.95;
    // What is shown is itself as unsteady as a Kinect's joints.
    if (c.scene.name == "sit_to_stand") c.within_reach = 0.97;
    // Hands on the hips are hard to tell from the trunk.
    if (c.scene.name == "dancing")
      c.mean = 0.065, c.p95 = 0.200, c.raw_mean = 0.100, c.raw_p95 = 0.270, c.within_reach = 0.96;
    out.push_back(std::move(c));
  }
  return out;
}

class SimulatedPeople : public ::testing::TestWithParam<Case> {};

TEST_P(SimulatedPeople, AreTrackedWithinTolerance) {
  if (!exists(GetParam().scene.plan.recording)) GTEST_SKIP() << GetParam().scene.plan.recording;
  auto clip = testing::simulate(GetParam().scene.plan);
  const ClipTrack track = trackClip(*clip.stream, {});
  ASSERT_EQ(track.people.size(), 1u);
  EXPECT_THAT(track.people[0].held, ::testing::Each(0u)) << "things in empty hands";
  const JointErrors errors = testing::compare(track.people[0].frames, clip.truth);
  EXPECT_LE(JointErrors::mean(errors.aligned), GetParam().mean);
  EXPECT_LE(JointErrors::quantile(errors.aligned, 0.95), GetParam().p95);
  EXPECT_LE(JointErrors::mean(errors.raw), GetParam().raw_mean);
  EXPECT_LE(JointErrors::quantile(errors.raw, 0.95), GetParam().raw_p95);
  EXPECT_GE(errors.tracked.within(), GetParam().within_reach);
  EXPECT_GE(errors.inferred.within(), kHiddenWithin);
  EXPECT_LE(errors.longest_swap, kLongestSwap);
  EXPECT_GE(static_cast<double>(track.people[0].found),
            (1.0 - kMaxLost) * static_cast<double>(clip.truth.size()));
  EXPECT_GE(track.people[0].frames.size() + kLate, clip.truth.size());
  std::printf(
      "%s: raw errors %.0f mm on the mean, %.0f mm of 95 in 100, with the mean offsets taken off %.0f and "
      "%.0f; "
      "within reach: tracked %.3f (x %.1f), inferred %.3f (x %.1f); %.0f images a second\n",
      GetParam().scene.name.c_str(), 1e3 * JointErrors::mean(errors.raw),
      1e3 * JointErrors::quantile(errors.raw, 0.95), 1e3 * JointErrors::mean(errors.aligned),
      1e3 * JointErrors::quantile(errors.aligned, 0.95), errors.tracked.within(),
      errors.tracked.medianRatio(), errors.inferred.within(), errors.inferred.medianRatio(),
      static_cast<double>(track.images) / track.seconds);
}

// At 4 m feet and knees are too coarse to tell front from back: who faces the camera is not turned round.
TEST(Facing, DistantFrontalPersonIsFront) {
  ClipPlan plan{.recording = testing::projectFile("data/scenes/hug_reach.bvh"),
                .end = 1.0,
                .eye = {4.2, 0.0, 1.2},
                .width = 240};
  auto clip = testing::simulate(plan);
  const ClipTrack track = trackClip(*clip.stream, {});
  ASSERT_EQ(track.people.size(), 1u);
  EXPECT_FALSE(track.people[0].facing.away) << track.people[0].facing.ratio;
  const JointErrors errors = testing::compare(track.people[0].frames, clip.truth);
  EXPECT_EQ(errors.longest_swap, 0.0) << "left and right";
  std::printf("ratio %.2f\n", track.people[0].facing.ratio);
}

// The same people from behind: the feet, and the way knees and elbows bend, tell the back from the front.
class PeopleFromBehind : public ::testing::TestWithParam<Case> {};

TEST_P(PeopleFromBehind, AreReportedFacingAway) {
  ClipPlan plan = GetParam().scene.plan;
  if (!exists(plan.recording)) GTEST_SKIP() << plan.recording;
  const auto tracked = [](const ClipPlan& seen, bool& away) {
    auto clip = testing::simulate(seen);
    const ClipTrack track = trackClip(*clip.stream, {});
    away = !track.people.empty() && track.people[0].facing.away;
    std::printf("%s: %.2f\n", GetParam().scene.name.c_str(),
                track.people.empty() ? kNaN : track.people[0].facing.ratio);
    return testing::compare(
        track.people.empty() ? std::vector<humanmodel::SkeletonFrame>{} : track.people[0].frames, clip.truth);
  };
  bool away = false;
  plan.eye = {2.0 * plan.look.x() - plan.eye.x(), -plan.eye.y(), plan.eye.z()};
  const JointErrors errors = tracked(plan, away);
  EXPECT_TRUE(away);
  EXPECT_LE(errors.longest_swap, kLongestSwap);
  EXPECT_LE(JointErrors::mean(errors.tracked.error), kSeenMean);
  EXPECT_GE(errors.inferred.within(), kHiddenBehind);
  tracked(GetParam().scene.plan, away);
  EXPECT_FALSE(away) << "from the front";
}

std::vector<Case> walkersAndBoxers() {
  std::vector<Case> out;
  for (const Case& c : cases())
    for (const std::string_view name : {"boxing", "boxing_in_a_room", "reaching", "walking_up", "going_down"})
      if (name == c.scene.name) out.push_back(c);
  return out;
}
INSTANTIATE_TEST_SUITE_P(Captures, PeopleFromBehind, ::testing::ValuesIn(walkersAndBoxers()),
                         [](const auto& one) { return one.param.scene.name; });

INSTANTIATE_TEST_SUITE_P(Captures, SimulatedPeople, ::testing::ValuesIn(cases()),
                         [](const auto& one) { return one.param.scene.name; });

}  // namespace simulated_people_test
}  // namespace abstand::tracking
