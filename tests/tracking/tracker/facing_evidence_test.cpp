// Evidence of one image for the right facing direction and for the opposite one.
#include "tracking/tracker/facing_evidence.hpp"

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"
#include "tracking/tracker/body_follower.hpp"

namespace abstand::tracking {
namespace facing_evidence_test {

BodyFollower follower() {
  constexpr double kStature = 1.75;  // m
  humanmodel::HumanOptions body;
  body.height = kStature;
  return {body, Stature::given(kStature), {}, 1};
}

/// An image of a person who stands and faces the camera at `eye` (m), which looks at z = `look` (m).
struct ImageOfStanding {
  ImageOfStanding(const Vector3d& eye, double look)
      : clip{testing::simulate({.recording = testing::projectFile("data/scenes/hug_reach.bvh"),
                                .end = 0.1,
                                .eye = eye,
                                .look = {0.0, 0.0, look},
                                .width = 320})} {
    clip.stream->next(frame);
    for (const float z : frame.image.z) mask.push_back(z > 0.0f);
  }
  PersonImage person() const { return {&frame.image, &clip.stream->camera(), mask}; }

  testing::SimulatedClip clip;
  DepthFrame frame;
  std::vector<std::uint8_t> mask;
};

/// 2.8 m away: the right body, and one that faces the other way.
class EvidenceOfStanding : public ::testing::Test {
 protected:
  void SetUp() override {
    const ImageOfStanding standing({2.8, 0.0, 1.2}, 0.9);
    const PersonImage image = standing.person();
    ASSERT_TRUE(right.track(0.0, {&image, 1}).found);
    turned.startTurned(right);
    ASSERT_TRUE(turned.track(0.0, {&image, 1}).found);
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

// Images 0.8 m high at the person.
TEST(EvidenceOfSomebodyNear, IsLittleWithoutHeadAndFeet) {
  const auto shows_little = [](double look) {
    const ImageOfStanding near({1.0, 0.0, look}, look);
    const PersonImage image = near.person();
    BodyFollower body = follower();
    EXPECT_TRUE(body.track(0.0, {&image, 1}).found) << look;
    return facingEvidence(*body.tracker).shows_little;
  };
  EXPECT_TRUE(shows_little(1.1));
  EXPECT_FALSE(shows_little(1.5)) << "the head";
}

TEST_F(EvidenceOfStanding, AllocatesNothing) {
  testing::NoAlloc guard;
  facingEvidence(*right.tracker);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace facing_evidence_test
}  // namespace abstand::tracking
