// What is measured, what is an interval, and what is said of it.
#include "tracking/tracker/stature.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tracking/tracker/tracked_recording.hpp"

namespace abstand::tracking {
namespace stature_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kNear = 0.05;  // m

/// A flat person: 0.5 m broad, from z = `low` to z = `high`, 3 m before a level camera 1 m above the floor.
struct Flat {
  DepthCamera camera;
  DepthImage image;
  std::vector<std::uint8_t> mask;

  Flat(double low, double high) {
    camera.width = 320;
    camera.height = 240;
    camera.fx = camera.fy = 290.0;
    camera.cx = 159.5;
    camera.cy = 119.5;
    camera.X_WC.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    camera.X_WC.translation() = Vector3d(0, 0, 1);
    image = DepthImage(camera.width, camera.height);
    mask.assign(image.z.size(), 0);
    for (int v = 0; v < camera.height; ++v) {
      for (int u = 0; u < camera.width; ++u) {
        const Vector3d p = camera.X_WC * camera.at(u, v, 3.0);
        if (std::abs(p.y()) > 0.25 || p.z() < low || p.z() > high) continue;
        image.z[static_cast<std::size_t>(v * camera.width + u)] = 3.0f;
        mask[static_cast<std::size_t>(v * camera.width + u)] = 1;
      }
    }
  }
  PersonImage person() const { return {&image, &camera, mask}; }
  VerticalExtent extent() const {
    const PersonImage one = person();
    return verticalExtent({&one, 1});
  }
};

Stature of(double low, double high) {
  return measureStature(std::vector<VerticalExtent>(15, Flat(low, high).extent()));
}

TEST(Stature, IsMeasuredForUprightPerson) {
  const Stature s = of(0.0, 1.8);
  EXPECT_TRUE(s.known());
  EXPECT_NEAR(s.used, 1.8, kNear);
  EXPECT_EQ(s.deviation(), 0.0);
  EXPECT_THAT(statureReason(s), HasSubstr("measured"));
}

TEST(Stature, OutOfRangeExtentIsNotReportedAsMeasured) {
  for (const double height : {0.8, 1.2, 1.35}) {
    const Stature s = of(0.0, height);
    EXPECT_FALSE(s.known()) << height;
    EXPECT_NEAR(s.interval[0], std::max(Stature::kShortest, height), kNear);
    EXPECT_EQ(s.interval[1], Stature::kTallest);
    EXPECT_GT(s.deviation(), 0.1);
    EXPECT_THAT(statureReason(s), HasSubstr("unknown, between"));
  }
  // Arms over the head: the extent says nothing.
  const Stature raised = measureStature(std::vector<VerticalExtent>(15, {2.25, 2.25, true}));
  EXPECT_FALSE(raised.known());
  EXPECT_THAT(raised.interval, ElementsAre(Stature::kShortest, Stature::kTallest));
}

TEST(Stature, IsIntervalForTruncatedOrHiddenPerson) {
  // Above 2.24 m and below -0.24 m the camera sees nothing.
  EXPECT_TRUE(Flat(0.0, 1.8).extent().whole);
  EXPECT_FALSE(Flat(-2.0, 1.8).extent().whole) << "cut below";
  EXPECT_FALSE(Flat(0.0, 3.0).extent().whole) << "cut above";
  EXPECT_FALSE(Flat(0.7, 1.8).extent().whole) << "behind a table";
  const Stature s = of(0.7, 1.8);
  EXPECT_FALSE(s.known());
  EXPECT_NEAR(s.used, 1.8, kNear) << "how high the head is says more than how much is seen";
  EXPECT_NEAR(s.interval[0], 1.1, kNear) << "as much is seen";
}

TEST(Stature, IsNotTakenFromSeatedOrHeadlessPerson) {
  // Seated or kneeling; a body of 1.3 m would have its legs in the air.
  EXPECT_EQ(of(0.0, 1.3).used, Stature::kUsual);
  EXPECT_EQ(measureStature(std::vector<VerticalExtent>(15, {2.25, 2.25, true})).used, Stature::kUsual);
  EXPECT_TRUE(Flat(0.0, 3.0).extent().headless);
  EXPECT_FALSE(Flat(0.0, 1.8).extent().headless);
  const auto cutAt = [](double top) {
    return measureStature(std::vector<VerticalExtent>(15, {top, top, false, true})).used;
  };
  EXPECT_EQ(cutAt(1.6), Stature::kUsual);
  EXPECT_NEAR(cutAt(1.8), 1.8, kNear);
}

TEST(Stature, OfRaisedArmsIsAnIntervalUpToTheSeenHeight) {
  const Stature s = Stature::ofRaisedArms(1.94);
  EXPECT_FALSE(s.known());
  EXPECT_NEAR(s.used, 1.74, kNear);
  EXPECT_THAT(s.interval, ElementsAre(Stature::kShortest, 1.94));
  EXPECT_THAT(s.reason, HasSubstr("1.94 m"));
  EXPECT_NEAR(Stature::ofRaisedArms(1.5).used, 1.3, kNear) << "a child";
}

TEST(Stature, OfSeatedPersonIsAnIntervalFromTheSeenHeight) {
  const Stature s = Stature::ofSeated(1.46);
  EXPECT_FALSE(s.known());
  EXPECT_THAT(s.interval, ElementsAre(1.46, Stature::kTallest));
  EXPECT_NEAR(s.used, 1.87, kNear);
  EXPECT_EQ(Stature::ofSeated(1.2).used, Stature::kUsual);
  EXPECT_EQ(Stature::ofSeated(1.9).used, Stature::kTallest);
  EXPECT_THAT(statureReason(s), HasSubstr("sits"));
}

TEST(Stature, IsNarrowedByTheLengthsOfParts) {
  Stature s = of(0.0, 1.3);
  const double before = s.deviation();
  s.narrow({1.6, 1.8});
  EXPECT_THAT(s.interval, ElementsAre(1.6 - Stature::kProportions, 1.8 + Stature::kProportions));
  EXPECT_LT(s.deviation(), 0.6 * before);
  s.narrow({1.2, 2.5});
  EXPECT_THAT(s.interval, ElementsAre(1.6 - Stature::kProportions, 1.8 + Stature::kProportions)) << "wider";
  s.narrow({1.9, 2.0});
  EXPECT_EQ(s.interval[0], s.used) << "the body that is used stays within";
}

TEST(Stature, DeviationIsThatFromTheStatureUsed) {
  Stature s;
  s.used = 1.7;
  s.interval = {1.5, 2.1};
  // Mean square over the interval, by the midpoint rule.
  constexpr int kSteps = 10000;
  double sum = 0.0;
  for (int k = 0; k < kSteps; ++k) sum += std::pow(1.5 + 0.6 * (k + 0.5) / kSteps - s.used, 2) / kSteps;
  EXPECT_NEAR(s.deviation(), std::sqrt(sum), 1e-6);
}

TEST(Stature, RareOnesCostMore) {
  EXPECT_DOUBLE_EQ(Stature::unusual(1.70), 1.0);
  EXPECT_NEAR(Stature::unusual(1.80), 1.05, 1e-12) << "a standard deviation";
  EXPECT_NEAR(Stature::unusual(1.60), 1.05, 1e-12);
  EXPECT_NEAR(Stature::unusual(2.00), 1.45, 1e-12) << "three";
}

TEST(Stature, IsUnknownWithoutImages) {
  const Stature s = measureStature({});
  EXPECT_FALSE(s.known());
  EXPECT_GT(s.used, 0.0);
  EXPECT_FALSE(Stature{}.known());
}

TEST(Stature, UnknownIsAWarning) {
  ClipPerson person;
  person.facing.given = true;
  person.stature = Stature::given(1.5);
  EXPECT_THAT(trackWarnings(person), IsEmpty());
  person.stature = of(0.0, 1.2);
  EXPECT_THAT(trackWarnings(person), ElementsAre(HasSubstr("--height")));
}

TEST(Facing, UndecidedIsAWarning) {
  ClipPerson person;
  person.stature = Stature::given(1.75);
  const auto decided = [&](double ratio) {
    person.facing.ratio = ratio;
    return person.facing.decided();
  };
  EXPECT_TRUE(decided(0.6));
  EXPECT_TRUE(decided(1.6));
  person.facing.away = true;
  EXPECT_FALSE(decided(0.85));
  EXPECT_THAT(trackWarnings(person), ElementsAre(HasSubstr("facing away from the camera is assumed")));
  person.facing.away = false;
  for (const double ratio : {1.0, 1.03, 1.06, kNaN}) {
    EXPECT_FALSE(decided(ratio)) << ratio;
    EXPECT_THAT(trackWarnings(person), ElementsAre(HasSubstr("facing the camera is assumed")));
    EXPECT_THAT(facingReason(person.facing),
                HasSubstr(std::isnan(ratio) ? "initially facing the camera, assumed without comparison"
                                            : "initially facing the camera, undecided"));
  }
  person.facing.given = true;
  EXPECT_THAT(trackWarnings(person), IsEmpty());
}

}  // namespace stature_test
}  // namespace abstand::tracking
