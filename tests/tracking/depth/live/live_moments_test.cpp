// Several live cameras: images that arrive together belong together, whatever single cameras do.
#include "tracking/tracker/live_moments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/tracking/depth/live/live_frames.hpp"

namespace abstand::testing {
namespace live_moments_test {

using tracking::DepthMoments;
using tracking::LiveDepth;

struct Moment {
  double t, lag;
  std::vector<double> times;  ///< s, of the image of each camera; NaN: none
  std::vector<bool> is_new;
};

/// All moments of cameras with these roles (fake_freenect.cpp), at most `most`.
std::vector<Moment> moments(const char* roles, std::size_t cameras, std::size_t most = 1000) {
  ::setenv("FAKE_KINECT", roles, 1);
  std::vector<std::unique_ptr<LiveDepth>> opened;
  for (std::size_t c = 0; c < cameras; ++c)
    opened.push_back(
        std::make_unique<LiveDepth>("live:kinect:" + std::to_string(c + 1), tracking::DepthStreamOptions{}));
  tracking::LiveMoments live(std::move(opened));
  std::vector<Moment> all;
  tracking::DepthMoment moment;
  while (all.size() < most && live.next(moment, kPatience) == LiveDepth::Outcome::kFrame) {
    Moment& noted = all.emplace_back(Moment{moment.t, moment.lag, {}, moment.is_new});
    for (const tracking::DepthFrame* frame : moment.frames) noted.times.push_back(frame ? frame->t : kNaN);
  }
  return all;
}

std::size_t with(const std::vector<Moment>& all, std::size_t camera) {
  return static_cast<std::size_t>(std::count_if(
      all.begin(), all.end(), [&](const Moment& m) { return !std::isnan(m.times.at(camera)); }));
}

void expectOrder(const std::vector<Moment>& all) {
  double last = -kInfinity;
  for (const Moment& m : all) {
    EXPECT_GT(m.t, last);
    last = m.t;
    EXPECT_LE(m.lag, DepthMoments::kFarthest);
    bool is_new = false;
    for (std::size_t c = 0; c < m.times.size(); ++c) {
      EXPECT_FALSE(std::abs(m.times[c] - m.t) > m.lag);
      is_new = is_new || m.is_new[c];
    }
    EXPECT_TRUE(is_new);
  }
}

TEST(LiveMoments, ImagesThatArriveTogetherAreOneMoment) {
  if (!loadDriver(ABSTAND_FAKE_FREENECT)) GTEST_SKIP() << "libfreenect.h";
  const std::vector<Moment> all = moments("mm:5000,mm:5000", 2, 50);
  ASSERT_EQ(all.size(), 50u);
  expectOrder(all);
  const auto both = std::count_if(all.begin(), all.end(), [](const Moment& m) {
    return !std::isnan(m.times[0]) && !std::isnan(m.times[1]);
  });
  EXPECT_GT(both, 0);
}

TEST(LiveMoments, OtherCamerasGoOnWhereTheFirstEndsOrFallsSilent) {
  if (!loadDriver(ABSTAND_FAKE_FREENECT)) GTEST_SKIP() << "libfreenect.h";
  for (const char* roles : {"mm:5,mm:5000", "silent,mm:5000", "still:5,mm:5000"}) {
    const std::vector<Moment> all = moments(roles, 2, 40);
    EXPECT_EQ(all.size(), 40u) << roles;
    expectOrder(all);
    EXPECT_LE(with(all, 0), 35u) << roles;
    EXPECT_GE(with(all, 1), 30u) << roles;
    EXPECT_TRUE(std::isnan(all.back().times[0])) << roles << ": an old image belongs to no moment";
  }
}

TEST(LiveMoments, EndsWithTheLastCamera) {
  if (!loadDriver(ABSTAND_FAKE_FREENECT)) GTEST_SKIP() << "libfreenect.h";
  const std::vector<Moment> all = moments("mm:3,mm:9,mm:6", 3);
  expectOrder(all);
  EXPECT_LE(all.size(), 18u);
  EXPECT_FALSE(std::isnan(all.back().times[1])) << "the last image of the longest stream is delivered";
}

}  // namespace live_moments_test
}  // namespace abstand::testing
