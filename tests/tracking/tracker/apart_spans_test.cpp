// Two cameras that see a person at different places, or at different times.
#include "tracking/tracker/apart_spans.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/tracking/tracker/posed_person.hpp"
#include "tracking/tracker/late_spans.hpp"
#include "tracking/tracker/middle_joints.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace apart_spans_test {

using humanmodel::SkeletonFrame;

constexpr double kImage = 1.0 / 30.0;  // s
// m, of each joint of a body that a camera alone gives; and what the medians of five joints leave of it.
constexpr double kNoise = 0.02, kLeft = 0.02;
const Vector3d kPushed{0.1, -0.1, 0.03};  // m

/// Walks and moves the hands, for 9 s.
std::vector<SkeletonFrame> walking() {
  std::vector<testing::Posture> postures;
  for (int k = 0; k < 10; ++k)
    postures.push_back({.t = 1.1 * k - 0.01 * k * k,
                        .hips = {0.5 * (k % 2), 0.2 * (k % 3), 0.92},
                        .reach = k % 2 ? 0.9 : 0.1,
                        .low = k % 3 ? 1.3 : 0.9,
                        .foot = 0.5 * (k % 2)});
  return testing::posedFrames(postures);
}

/// As the second camera sees it: `off` (m) by the time, and by `late` images.
template <class Off>
std::vector<SeenTwice> seen(Off off, std::size_t late = 0, double late_since = kInfinity) {
  const std::vector<SkeletonFrame> frames = walking();
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(0.0, kNoise);
  const auto noisy = [&](SkeletonFrame frame, const Vector3d& shift) {
    for (Vector3d& p : frame.p) p += shift + Vector3d(normal(random), normal(random), normal(random));
    return middleJoints(frame);
  };
  std::vector<SeenTwice> all;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double t = frames[i].t;
    SkeletonFrame second = frames[t >= late_since ? i - std::min(i, late) : i];
    second.t = t;
    SeenTwice& one =
        all.emplace_back(SeenTwice{t, noisy(frames[i], Vector3d::Zero()), noisy(second, off(t))});
    one.off = offsetBetween(one.first, one.second).value();
  }
  return all;
}

TEST(MiddleJoints, AreThoseOfWhoFacesTheOtherWay) {
  const SkeletonFrame frame = walking()[20];
  const auto off = offsetBetween(middleJoints(frame), middleJoints(flippedFacing(frame)));
  ASSERT_TRUE(off);
  EXPECT_LT(off->norm(), 1e-12);
  SkeletonFrame arms;
  for (const humanmodel::Joint joint : {humanmodel::Joint::kWristLeft, humanmodel::Joint::kHandRight})
    arms.set(joint, frame[joint]);
  EXPECT_FALSE(offsetBetween(middleJoints(frame), middleJoints(arms)));
}

TEST(ApartSpans, BeginWithThePush) {
  const auto spans =
      apartSpans(seen([](double t) -> Vector3d { return t < 2.0 ? Vector3d::Zero() : kPushed; }));
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_NEAR(spans[0].since, 2.0, 2.0 * kImage);
  EXPECT_EQ(spans[0].until, kInfinity);
  EXPECT_NEAR(spans[0].distance, kPushed.norm(), kLeft);
}

TEST(ApartSpans, HoldFromTheStartAndEnd) {
  const auto spans =
      apartSpans(seen([](double t) -> Vector3d { return t < 3.0 ? kPushed : Vector3d::Zero(); }));
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(spans[0].since, -kInfinity);
  EXPECT_NEAR(spans[0].until, 3.0, 2.0 * kImage);
}

TEST(ApartSpans, HoldWhileThePersonIsOutOfView) {
  auto all = seen([](double t) -> Vector3d { return t > 2.5 && t < 5.5 ? kPushed : Vector3d::Zero(); });
  std::erase_if(
      all, [](const SeenTwice& one) { return (one.t > 2.0 && one.t < 3.0) || (one.t > 5.0 && one.t < 6.0); });
  const auto spans = apartSpans(all);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_NEAR(spans[0].since, 2.0, kImage);
  EXPECT_NEAR(spans[0].until, 6.0, kImage);
}

TEST(ApartSpans, AreNoneOfCalibratedCamerasAndShortErrors) {
  EXPECT_TRUE(apartSpans(seen([](double) -> Vector3d { return Vector3d::Constant(0.02); })).empty());
  EXPECT_TRUE(apartSpans(seen([](double t) -> Vector3d {
                return t > 2.0 && t < 2.4 ? kPushed : Vector3d::Zero();
              })).empty());
  EXPECT_TRUE(apartSpans(seen([](double) -> Vector3d { return {0.03, 0.03, 0.12}; })).empty());
  EXPECT_EQ(apartSpans(seen([](double) -> Vector3d { return {0.0, 0.0, 0.25}; })).size(), 1u);
  EXPECT_TRUE(apartSpans({}).empty());
}

TEST(ApartSpans, TellWhichCameraWasPushed) {
  auto pushed = seen([](double t) -> Vector3d { return t < 2.0 ? Vector3d::Zero() : kPushed; });
  EXPECT_EQ(whichJumped(pushed, 2.0), 1);
  for (SeenTwice& one : pushed) {
    std::swap(one.first, one.second);
    one.off = -one.off;
  }
  EXPECT_EQ(whichJumped(pushed, 2.0), 0);
  const auto drifting = seen([](double t) -> Vector3d { return 0.1 * t * kPushed; });
  EXPECT_EQ(whichJumped(drifting, 2.0), std::nullopt);
}

TEST(LateSpans, AreWhereMovementsComeLater) {
  const auto none = [](double) -> Vector3d { return Vector3d::Zero(); };
  EXPECT_TRUE(lateSpans(seen(none)).empty());
  const auto spans = lateSpans(seen(none, 8, 0.0));
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_NEAR(spans[0].late, 8.0 * kImage, kImage);
  EXPECT_EQ(spans[0].until, kInfinity);
  const auto later = lateSpans(seen(none, 8, 2.0));
  ASSERT_EQ(later.size(), 1u);
  EXPECT_LE(later[0].since, 2.0);
  EXPECT_NEAR(later[0].late, 8.0 * kImage, kImage);
}

}  // namespace apart_spans_test
}  // namespace abstand::tracking
