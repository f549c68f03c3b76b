// Grouping of the images of several streams.
#include "tracking/tracker/depth_moments.hpp"

#include <gtest/gtest.h>

namespace abstand::tracking {
namespace depth_moments_test {

constexpr double kNear = 1e-9;  // s, sums of times

/// A stream of empty images at these times (s).
DepthStream streamAt(const std::vector<double>& times) {
  DepthSource source;
  source.camera.width = source.camera.height = 4;
  source.camera.fx = source.camera.fy = 4.0;
  source.t = times;
  source.load = [](std::size_t) { return DepthImage(4, 4); };
  return DepthStream(std::move(source));
}

std::vector<double> steps(double start, double step, std::size_t count) {
  std::vector<double> t;
  for (std::size_t i = 0; i < count; ++i) t.push_back(start + step * static_cast<double>(i));
  return t;
}

TEST(DepthMoments, UseNearestImageOfEachCamera) {
  DepthStream first = streamAt(steps(0.0, 1.0 / 30.0, 30)), second = streamAt(steps(0.0, 1.0 / 30.0, 30));
  const std::vector<ClipCamera> cameras{{&first, 0.0}, {&second, 0.010}};
  DepthMoments moments(cameras);
  ASSERT_EQ(moments.size(), 30u);
  DepthMoment moment;
  for (std::size_t i = 0; moments.next(moment); ++i) {
    ASSERT_TRUE(moment.frames[0] && moment.frames[1]);
    EXPECT_NEAR(moment.t, moment.frames[0]->t, kNear);
    EXPECT_NEAR(moment.frames[1]->t, moment.frames[0]->t, kNear);
    EXPECT_NEAR(moment.lag, 0.010, kNear);
    EXPECT_TRUE(moment.is_new[0] && moment.is_new[1]);
  }
  EXPECT_FALSE(moments.next(moment));
}

TEST(DepthMoments, SlowerCameraRepeatsImage) {
  DepthStream first = streamAt(steps(0.0, 1.0 / 30.0, 30)), second = streamAt(steps(0.0, 1.0 / 15.0, 15));
  const std::vector<ClipCamera> cameras{{&first, 0.0}, {&second, 0.0}};
  DepthMoments moments(cameras);
  DepthMoment moment;
  std::size_t images = 0;
  while (moments.next(moment)) {
    ASSERT_TRUE(moment.frames[1]);
    EXPECT_LE(moment.lag, 1.0 / 30.0 + kNear);
    images += moment.is_new[1];
  }
  EXPECT_EQ(images, 15u);
}

TEST(DepthMoments, GapOfOneCameraLeavesOther) {
  std::vector<double> broken = steps(0.0, 1.0 / 30.0, 15);
  for (const double t : steps(1.5, 1.0 / 30.0, 15)) broken.push_back(t);
  DepthStream first = streamAt(broken), second = streamAt(steps(0.0, 1.0 / 30.0, 60));
  const std::vector<ClipCamera> cameras{{&first, 0.0}, {&second, 0.0}};
  DepthMoments moments(cameras);
  DepthMoment moment;
  std::size_t alone = 0;
  double last = -1.0;
  while (moments.next(moment)) {
    EXPECT_GT(moment.t, last);
    EXPECT_LE(moment.t - last, last < 0.0 ? 2.0 : DepthMoments::kGap + 1.0 / 30.0);
    last = moment.t;
    alone += !moment.frames[0];
    EXPECT_TRUE(moment.frames[0] || moment.frames[1]);
  }
  EXPECT_GT(alone, 20u);
}

TEST(DepthMoments, CanBeReadAgain) {
  DepthStream first = streamAt(steps(0.0, 0.1, 3)), second = streamAt(steps(5.0, 0.1, 3));
  const std::vector<ClipCamera> cameras{{&first, 0.0}, {&second, 0.0}};
  DepthMoments moments(cameras);
  ASSERT_EQ(moments.size(), 6u);
  DepthMoment moment;
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; moments.next(moment); ++i) {
      EXPECT_EQ(moment.frames[0] != nullptr, i < 3);
      EXPECT_EQ(moment.frames[1] != nullptr, i >= 3);
    }
    moments.rewind();
  }
}

}  // namespace depth_moments_test
}  // namespace abstand::tracking
