// The learned background against two plain histories for each pixel.
#include "tracking/depth/people/learned_background.hpp"

#include <gtest/gtest.h>

#include "core/math/random.hpp"

namespace abstand::tracking {
namespace learned_background_test {

constexpr double kLearnAfter = 0.5;  // s
constexpr float kStep = 0.05f;       // s, between images

/// One pixel: an unassigned surface, and what was background last. Both are written in each image.
class PlainPixel {
 public:
  bool has(float z) const { return isStable(background_, z); }
  bool hasSettled(float z) const { return unassigned_.duration >= 0.7f && isStable(unassigned_, z); }
  void learn(float z) {
    if (!isStable(unassigned_, z)) {
      unassigned_ = {z, 0.5f * depthNoise(z), 0.0f};
      return;
    }
    unassigned_.deviation += 0.1f * (std::abs(z - unassigned_.z) - unassigned_.deviation);
    unassigned_.z += 0.1f * (z - unassigned_.z);
    unassigned_.duration += kStep;
    if (unassigned_.duration >= static_cast<float>(kLearnAfter)) background_ = unassigned_;
  }
  void cover() { unassigned_ = {}; }
  void set(float z) { background_ = {z, 0.5f * depthNoise(z), 0.0f}; }

 private:
  struct Surface {
    float z{0.0f}, deviation{0.0f}, duration{0.0f};
  };
  static bool isStable(const Surface& surface, float z) {
    return surface.z > 0.0f &&
           std::abs(z - surface.z) < std::max(depthNoise(z), std::min(4.0f * surface.deviation, 0.3f));
  }
  Surface unassigned_, background_;
};

TEST(LearnedBackground, IsThatOfPlainHistories) {
  constexpr std::size_t kPixels = 50;
  constexpr int kImages = 400;
  const std::array<float, 3> surfaces{1.0f, 2.0f, 2.4f};  // m
  LearnedBackground background(kPixels, kLearnAfter);
  std::vector<PlainPixel> plain(kPixels);
  std::vector<std::size_t> at(kPixels, 0);
  Random random(1, 0);
  int learned = 0, settled = 0;
  for (int image = 0; image < kImages; ++image)
    for (std::size_t i = 0; i < kPixels; ++i) {
      if (random.chance(0.04)) at[i] = random.below(surfaces.size());
      const float z = surfaces[at[i]] + static_cast<float>(random.between(-0.03, 0.03));
      ASSERT_EQ(background.has(i, z), plain[i].has(z)) << "pixel " << i << ", image " << image;
      ASSERT_EQ(background.hasSettled(i, z), plain[i].hasSettled(z)) << "pixel " << i << ", image " << image;
      learned += background.has(i, z);
      settled += background.hasSettled(i, z);
      // As PeopleFinder does: what is uncovered is set, a person covers, all else is learned.
      const bool is_person = !background.has(i, z) && random.chance(0.2);
      if (is_person && random.chance(0.2)) {
        background.set(i, z);
        plain[i].set(z);
      } else if (is_person) {
        background.cover(i);
        plain[i].cover();
        continue;
      }
      background.learn(i, z, kStep);
      plain[i].learn(z);
    }
  EXPECT_GT(learned, kImages) << "or the comparison means little";
  EXPECT_GT(settled, kImages);
}

}  // namespace learned_background_test
}  // namespace abstand::tracking
