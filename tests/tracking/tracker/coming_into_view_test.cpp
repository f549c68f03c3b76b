#include "tracking/tracker/coming_into_view.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/tracker/small_camera.hpp"

namespace abstand::tracking {
namespace coming_into_view_test {

constexpr double kPeriod = 1.0 / 30.0;  // s

/// Images of a flat person, 2 m away, in the columns from `left` to `right`.
struct Columns {
  Columns(int left, int right) {
    for (float& z : image.z) z = 2.0f;
    for (int v = 30; v < 90; ++v)
      for (int u = left; u <= right; ++u) mask[static_cast<std::size_t>(v * camera.width + u)] = 1;
  }
  PersonImage person(std::size_t number = 0) const { return {&image, &camera, mask, number}; }

  DepthCamera camera = smallCamera();
  DepthImage image{160, 120};
  std::vector<std::uint8_t> mask = std::vector<std::uint8_t>(160 * 120);
};

TEST(VisibleArea, IsThatOfASurfaceAcrossTheRays) {
  const Columns columns(20, 39);
  const double pixel = 2.0 / 145.0;  // m
  EXPECT_NEAR(visibleArea(std::array{columns.person()}), 60 * 20 * pixel * pixel, 1e-12);
  EXPECT_NEAR(visibleArea(std::array{columns.person(), columns.person(1)}), 2 * 60 * 20 * pixel * pixel,
              1e-12);
}

TEST(ComingIntoView, StartsWhereNearlyAllIsSeen) {
  ComingIntoView coming;
  EXPECT_TRUE(std::isnan(coming.start()));
  constexpr int kWide = 30, kFirst = 5;
  for (int i = 0; i < 60; ++i) {
    const Columns columns(0, std::min(kWide, kFirst + i) - 1);
    coming.see(kPeriod * i, std::array{columns.person()});
  }
  // 26 of 30 columns are the first with 0.85 of the surface.
  EXPECT_NEAR(coming.start(), kPeriod * (26 - kFirst), 1e-12);
  // Of the first ten images, with 5 to 14 columns, the one with 12.
  EXPECT_NEAR(coming.start(kPeriod * 9.5), kPeriod * (12 - kFirst), 1e-12);
}

TEST(ComingIntoView, StartsWhenTheBorderCutsNothingOff) {
  ComingIntoView coming;
  for (int i = 0; i < 20; ++i) {
    const Columns columns(i, 10 + 3 * i);
    coming.see(kPeriod * i, std::array{columns.person()});
  }
  // The border is 3 % of 160 pixels.
  EXPECT_NEAR(coming.start(), kPeriod * 5, 1e-12);
}

TEST(ComingIntoView, GrowsWhileBorderCutsMoreAndMore) {
  ComingIntoView coming;
  int i = 0;
  const auto see = [&](int left, int right) {
    const Columns columns(left, right);
    coming.see(kPeriod * i++, std::array{columns.person()});
  };
  EXPECT_TRUE(coming.isGrowing());
  for (int k = 0; k < 20; ++k) {
    see(0, 5 + k);
    EXPECT_TRUE(coming.isGrowing()) << k;
  }
  for (int k = 0; k < 8; ++k) see(0, 24);
  EXPECT_FALSE(coming.isGrowing());
}

TEST(ComingIntoView, PersonInTheMiddleIsNotAwaited) {
  ComingIntoView coming;
  const Columns columns(40, 60);
  coming.see(0.0, std::array{columns.person()});
  EXPECT_FALSE(coming.isGrowing());
}

TEST(ComingIntoView, OneCameraThatSeesAllIsEnough) {
  ComingIntoView coming;
  const Columns cut(0, 20), whole(40, 60);
  coming.see(0.0, std::array{cut.person(), whole.person(1)});
  EXPECT_FALSE(coming.isGrowing());
}

TEST(ComingIntoView, EndsAfterSomeSeconds) {
  ComingIntoView coming;
  for (int i = 0; kPeriod * i <= ComingIntoView::kLongest + 0.1; ++i) {
    const Columns columns(0, 3 + 2 * i);
    coming.see(kPeriod * i, std::array{columns.person()});
    EXPECT_EQ(coming.isGrowing(), kPeriod * i <= ComingIntoView::kLongest) << i;
  }
}

}  // namespace coming_into_view_test
}  // namespace abstand::tracking
