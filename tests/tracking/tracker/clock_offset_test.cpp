// Clocks of two recordings of one person.
#include "tracking/tracker/clock_offset.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/tracking/tracker/posed_person.hpp"

namespace abstand::tracking {
namespace clock_offset_test {

using humanmodel::SkeletonFrame;
using testing::Posture;

constexpr double kStep = 0.004;  // s, of the search and of interpolation between images

/// A person whose hands move; `noise` (m) of each joint, `late` (s) added to all times, `shift` (m) of all
/// joints.
std::vector<SkeletonFrame> waving(double noise, double late, const Vector3d& shift) {
  std::vector<Posture> postures;
  for (int k = 0; k < 7; ++k)
    postures.push_back({.t = 0.7 * k + 0.05 * k * k, .reach = k % 2 ? 0.45 : 0.1, .low = k % 3 ? 1.3 : 0.9});
  std::vector<SkeletonFrame> frames = testing::posedFrames(postures);
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;  // scaled by `noise`, as a distribution of no width is none
  for (SkeletonFrame& frame : frames) {
    frame.t += late;
    for (Vector3d& p : frame.p) p += shift + noise * Vector3d(normal(random), normal(random), normal(random));
  }
  return frames;
}

TEST(ClockOffset, IsRecoveredForAnyCameraPose) {
  const auto first = waving(0.0, 0.0, Vector3d::Zero());
  for (const double late : {-3.1, -0.5, 0.0, 0.017, 1.25}) {
    // Later by `late`: that much is to be taken off.
    const ClockOffset found = estimateClockOffset(first, waving(0.02, late, {0.2, -0.1, 0.05}));
    EXPECT_TRUE(found.decided) << late;
    EXPECT_NEAR(found.offset, -late, kStep) << late;
    EXPECT_LT(found.apart, 0.05);
  }
}

TEST(ClockOffset, IsUndecidedForStandingPerson) {
  const std::vector<Posture> still{{.t = 0.0}, {.t = 5.0}};
  auto first = testing::posedFrames(still), second = first;
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal(0.0, 0.03);
  for (SkeletonFrame& frame : second)
    for (Vector3d& p : frame.p) p += Vector3d(normal(random), normal(random), normal(random));
  EXPECT_FALSE(estimateClockOffset(first, second).decided);
}

TEST(ClockOffset, IsUndecidedWithoutCommonTime) {
  const auto first = waving(0.0, 0.0, Vector3d::Zero());
  EXPECT_FALSE(estimateClockOffset(first, waving(0.0, 60.0, Vector3d::Zero())).decided);
  EXPECT_FALSE(estimateClockOffset(first, {}).decided);
  EXPECT_EQ(estimateClockOffset({}, first).overlap, 0.0);
}

}  // namespace clock_offset_test
}  // namespace abstand::tracking
