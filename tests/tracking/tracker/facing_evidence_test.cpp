// Evidence of one image for the right facing direction and for the opposite one.
#include "tracking/tracker/facing_evidence.hpp"

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"
#include "tracking/tracker/body_follower.hpp"

namespace abstand::tracking {
namespace facing_evidence_test {

/// A person who stands and faces the camera, 2.8 m away: the right body, and one that faces the other way.
class EvidenceOfStanding : public ::testing::Test {
 protected:
  void SetUp() override {
    testing::SimulatedClip clip = testing::simulate(
        {.recording = testing::projectFile("data/scenes/hug_reach.bvh"), .end = 0.1, .width = 320});
    DepthFrame frame;
    ASSERT_TRUE(clip.stream->next(frame));
    std::vector<std::uint8_t> mask(frame.image.z.size());
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = frame.image.z[i] > 0.0f;
    const PersonImage image{&frame.image, &clip.stream->camera(), mask};
    ASSERT_TRUE(right.track(0.0, {&image, 1}).found);
    turned.startTurned(right);
    ASSERT_TRUE(turned.track(0.0, {&image, 1}).found);
  }

  static BodyFollower follower() {
    constexpr double kStature = 1.75;  // m
    humanmodel::HumanOptions body;
    body.height = kStature;
    return {body, Stature::given(kStature), {}, 1};
  }

  BodyFollower right = follower(), turned = follower();
};

TEST_F(EvidenceOfStanding, ShowsToesAndFront) {
  const FacingEvidence good = facingEvidence(*right.tracker), bad = facingEvidence(*turned.tracker);
  EXPECT_GT(good.low_points, 20.0);
  EXPECT_EQ(good.low_points, bad.low_points) << "the same image";
  EXPECT_LT(1.5 * good.low_cost, bad.low_cost) << "the toes are at the heels";
  EXPECT_LT(good.cost, bad.cost);
  EXPECT_GT(good.forward_W.x(), 0.9) << "to the camera";
  EXPECT_LT(bad.forward_W.x(), -0.9);
}

TEST_F(EvidenceOfStanding, AddsUpToTheCostOfTheImage) {
  constexpr double kRounding = 1e-6;  // relative; scores are floats
  const BodyTracker& tracker = *right.tracker;
  const FacingEvidence evidence = facingEvidence(tracker);
  const SeenPoints& points = tracker.seen().points();
  std::vector<float> score(SeenPoints::kMax), high;
  tracker.fit().scores(points, tracker.body().X_WS, DepthFit::kAll, score.data());
  for (std::size_t i = 0; i < points.count; ++i)
    if (points.point(i).z() >= FacingEvidence::kLow) high.push_back(score[i]);
  EXPECT_EQ(static_cast<double>(points.count - high.size()), evidence.low_points);
  const auto count = static_cast<double>(points.count);
  const double of_points = DepthFit::robustMean(score.data(), points.count) * count;
  const double of_high = DepthFit::robustMean(high.data(), high.size()) * static_cast<double>(high.size());
  EXPECT_NEAR(of_high + evidence.low_cost, of_points, kRounding * of_points);
}

TEST_F(EvidenceOfStanding, AllocatesNothing) {
  testing::NoAlloc guard;
  facingEvidence(*right.tracker);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace facing_evidence_test
}  // namespace abstand::tracking
