// Whether images show objects whose places are known.
#include "tracking/tracker/known_objects.hpp"

#include <gtest/gtest.h>

namespace abstand::tracking {
namespace known_objects_test {

constexpr int kWidth = 40, kHeight = 30;

/// A wall at 3 m with a square of `side` pixels at depth z (m).
DepthImage squareAt(float z, int side, float wall = 3.0f) {
  DepthImage image(kWidth, kHeight);
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u) image.at(u, v) = u < side && v < side ? z : wall;
  return image;
}

bool shows(const DepthImage& image, const DepthImage& known) {
  KnownPixels pixels;
  pixels.add(image, known);
  return pixels.show();
}

TEST(KnownPixels, ShowAnObjectThatIsWhereItIsSaidToBe) {
  const DepthImage known = squareAt(2.0f, 20, 0.0f);
  EXPECT_TRUE(shows(squareAt(2.03f, 20), known));
  EXPECT_TRUE(shows(squareAt(2.0f, 17), known)) << "17 x 17 of 20 x 20 pixels";
  EXPECT_FALSE(shows(squareAt(2.0f, 14), known)) << "half of them";
  EXPECT_FALSE(shows(squareAt(3.0f, 20), known)) << "the wall behind";
}

TEST(KnownPixels, LeaveOutWhatIsHidden) {
  const DepthImage known = squareAt(2.0f, 20, 0.0f);
  DepthImage image = squareAt(2.0f, 20);
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < 8; ++u) image.at(u, v) = 1.0f;  // a person before it
  EXPECT_TRUE(shows(image, known));
  for (float& z : image.z) z = 1.0f;
  EXPECT_FALSE(shows(image, known)) << "all is hidden: not known";
  for (float& z : image.z) z = 0.0f;
  EXPECT_FALSE(shows(image, known)) << "nothing was measured";
}

}  // namespace known_objects_test
}  // namespace abstand::tracking
