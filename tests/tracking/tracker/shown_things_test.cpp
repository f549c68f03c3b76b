// Things in front of a wall, and things that are said to be there.
#include "tracking/tracker/shown_things.hpp"

#include <gtest/gtest.h>

namespace abstand::tracking {
namespace shown_things_test {

constexpr int kWidth = 80, kHeight = 60;
constexpr float kWall = 3.0f, kThing = 2.0f;  // m

/// A thing in the columns from `left` on; `empty`: elsewhere, m.
DepthImage imageOf(int left, int columns, float empty) {
  DepthImage image(kWidth, kHeight);
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u)
      image.z[static_cast<std::size_t>(v * kWidth + u)] = u >= left && u < left + columns ? kThing : empty;
  return image;
}

struct ShownThingsTest : ::testing::Test {
  const DepthImage known = imageOf(20, 20, 0.0f);
  DepthCamera camera = [] {
    DepthCamera small;
    small.width = kWidth;
    small.height = kHeight;
    small.fx = small.fy = 70.0;
    small.cx = 39.5;
    small.cy = 29.5;
    return small;
  }();
  ShownThings shown;
  double t{0.0};
  bool see(const DepthImage& image, int images = 20) {
    bool are_shown = false;
    for (int k = 0; k < images; ++k) are_shown = shown.see(t += 1.0 / 30.0, image, &known, &known, camera);
    return are_shown;
  }
};

TEST_F(ShownThingsTest, ThingsInTheirPlaceAreShown) {
  EXPECT_TRUE(see(imageOf(20, 20, kWall)));
  EXPECT_EQ(shown.share(), 1.0);
}

TEST_F(ShownThingsTest, ThingsElsewhereAreNotShownUntilTheyAreThere) {
  EXPECT_TRUE(see(imageOf(50, 20, kWall), 1)) << "one image does not decide";
  EXPECT_FALSE(see(imageOf(50, 20, kWall)));
  EXPECT_EQ(shown.share(), 0.0);
  EXPECT_TRUE(see(imageOf(20, 20, kWall), 300));
}

TEST_F(ShownThingsTest, WhatHidesThemCountsNeither) {
  DepthImage hidden = imageOf(20, 20, kWall);
  for (float& z : hidden.z)
    if (z == kThing) z = 1.0f;
  EXPECT_TRUE(see(hidden));
  EXPECT_TRUE(std::isnan(shown.share())) << "somebody stands before them";
}

TEST_F(ShownThingsTest, UnknownThingsCompareNothing) {
  const DepthImage image = imageOf(50, 20, kWall);
  for (int k = 0; k < 100; ++k) EXPECT_TRUE(shown.see(0.1 * k, image, nullptr, nullptr, camera));
  EXPECT_TRUE(std::isnan(shown.share()));
}

}  // namespace shown_things_test
}  // namespace abstand::tracking
