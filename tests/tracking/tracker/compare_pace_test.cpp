// Cameras of different rates.
#include "tracking/tracker/compare_pace.hpp"

#include <gtest/gtest.h>

namespace abstand::tracking {
namespace compare_pace_test {

constexpr double kStep = 1.0 / 30.0, kLong = 10.0;  // s

struct Compared {
  int moments{0};
  std::vector<int> of_camera;
};

/// `is_new(i)`: of moment number i.
template <class IsNew>
Compared compare(std::size_t cameras, const IsNew& is_new) {
  ComparePace pace(cameras);
  Compared compared{0, std::vector<int>(cameras, 0)};
  for (int i = 0; i * kStep < kLong; ++i) {
    const std::vector<bool> now = is_new(i);
    if (!pace.isDue(i * kStep, now)) continue;
    pace.note(i * kStep, now);
    ++compared.moments;
    for (std::size_t c = 0; c < cameras; ++c) compared.of_camera[c] += now[c];
  }
  return compared;
}

TEST(ComparePace, EverySecondMomentOfEqualCameras) {
  EXPECT_EQ(compare(2, [](int) { return std::vector<bool>{true, true}; }).moments, 150);
}

TEST(ComparePace, NothingWithOneImage) {
  EXPECT_EQ(compare(2, [](int i) { return std::vector<bool>{true, i == 0}; }).moments, 1);
}

// The second and the third camera look in turns, and the first one always.
TEST(ComparePace, NoCameraIsLeftOut) {
  const Compared compared = compare(3, [](int i) { return std::vector<bool>{true, i % 2 == 0, i % 2 == 1}; });
  const int fewest = static_cast<int>(0.9 * kLong / (ComparePace::kOverdue + kStep));
  EXPECT_GE(compared.of_camera[1], fewest);
  EXPECT_GE(compared.of_camera[2], fewest);
  EXPECT_LE(compared.moments, 200) << "not every image";
}

}  // namespace compare_pace_test
}  // namespace abstand::tracking
