// A person whom one camera sees in front of the background, and another one elsewhere.
#include "tracking/tracker/through_spans.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/tracker/small_camera.hpp"
#include "tracking/tracker/refuted_spans.hpp"

namespace abstand::tracking {
namespace through_spans_test {

constexpr double kImage = 1.0 / 30.0;  // s
constexpr double kRadius = 0.2,
                 kWall = 2.0;  // m, of an upright cylinder at the origin; of the walls behind it
constexpr double kAway = 2.5;  // m, of the cameras

/// From a camera that stands at the angle `at` about z, at half the height of the cylinder.
struct View {
  DepthCamera camera;
  DepthImage image;
  std::vector<std::uint8_t> labels;

  explicit View(double at)
      : camera(smallCameraAt({kAway * std::cos(at), kAway * std::sin(at), 1.0}, {0.0, 0.0, 1.0})),
        image(camera.width, camera.height),
        labels(image.z.size(), 0) {
    for (int v = 0; v < image.height; ++v)
      for (int u = 0; u < image.width; ++u) {
        // |z (x, 1) - (0, kAway)|^2 = kRadius^2 for the ray through (x, y, 1).
        const Eigen::Vector2d ray(camera.at(u, v, 1.0).x(), 1.0);
        const double b = kAway / ray.squaredNorm();
        const double root = b * b - (kAway * kAway - kRadius * kRadius) / ray.squaredNorm();
        image.at(u, v) = static_cast<float>(root >= 0.0 ? b - std::sqrt(root) : kAway + kWall);
        labels[static_cast<std::size_t>(v * image.width + u)] = root >= 0.0;
      }
  }
  LabelledImage labelled() const { return {&image, &camera, labels}; }
};

TEST(SeenThrough, IsNothingOfCalibratedCameras) {
  for (const double between : {0.5, 1.5, 3.1}) {
    const ThroughAt at = throughAt(0.0, View(0.0).labelled(), View(between).labelled());
    EXPECT_LT(at.share, 0.5 * ThroughAt::kShare) << between;
  }
}

/// Whatever the angle between the cameras; a displacement along the ray of one is seen by the other one only.
TEST(SeenThrough, MeasuresHowFarACameraIsAside) {
  // m: a pixel, and what the estimate gives for distances that are not evenly distributed, as of a cylinder.
  constexpr double kPixel = 0.017, kShareOfIt = 0.1;
  for (const double between : {0.5, 1.5, 3.1})
    for (const double aside : {0.1, 0.2}) {
      const View first(0.0);
      View second(between);
      second.camera.X_WC.translate(Vector3d(aside, 0.0, 0.0));
      const ThroughAt at = throughAt(0.0, first.labelled(), second.labelled());
      EXPECT_GT(at.share, ThroughAt::kShare);
      EXPECT_NEAR(at.displacement, aside, kPixel + kShareOfIt * aside) << between;
    }
}

/// A camera that is aside by what withoutRefuted() expects to be seen.
TEST(SeenThrough, ShowsTheSmallestErrorThatRefutes) {
  const double aside = kShowsBeyond * SeenThrough::farFrom(kAway);
  for (const double between : {0.5, 1.0, 1.5, 2.2, 3.1}) {
    const View first(0.0);
    View second(between);
    second.camera.X_WC.translate(Vector3d(aside, 0.0, 0.0));
    EXPECT_GT(throughAt(0.0, first.labelled(), second.labelled()).share, 2.0 * kNothingThrough) << between;
  }
}

TEST(SeenThrough, IsUnknownWithoutPeople) {
  View first(0.0), second(1.5);
  first.labels.assign(first.labels.size(), 0);
  second.labels.assign(second.labels.size(), 0);
  EXPECT_TRUE(std::isnan(throughAt(0.0, first.labelled(), second.labelled()).share));
}

std::vector<ThroughAt> seriesOf(double since, double until) {
  std::vector<ThroughAt> seen;
  for (int i = 0; i < 120; ++i) {
    const double t = i * kImage;
    const bool is_apart = t >= since && t < until;
    seen.push_back({.t = t, .share = is_apart ? 0.1 : 0.0, .displacement = is_apart ? 0.15 : 0.0});
  }
  return seen;
}

TEST(ThroughSpans, BeginAndEndWithTheDisagreement) {
  constexpr double kHalfWindow = 0.25 + kImage;  // s
  const std::vector<ApartSpan> spans = throughSpans(seriesOf(1.0, 2.5));
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_NEAR(spans[0].since, 1.0, kHalfWindow);
  EXPECT_NEAR(spans[0].until, 2.5, kHalfWindow);
  EXPECT_EQ(spans[0].distance, 0.15);
  const std::vector<ApartSpan> always = throughSpans(seriesOf(-1.0, 9.0));
  ASSERT_EQ(always.size(), 1u);
  EXPECT_EQ(always[0].since, -kInfinity);
  EXPECT_EQ(always[0].until, kInfinity);
}

TEST(ThroughSpans, ShortOnesAndUnknownTimesAreNone) {
  EXPECT_TRUE(throughSpans(seriesOf(1.0, 1.3)).empty());
  std::vector<ThroughAt> unknown = seriesOf(1.0, 2.5);
  for (ThroughAt& one : unknown)
    if (one.share > 0.0) one.share = kNaN;
  EXPECT_TRUE(throughSpans(unknown).empty());
}

}  // namespace through_spans_test
}  // namespace abstand::tracking
