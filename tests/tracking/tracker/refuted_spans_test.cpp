// Bodies that two cameras see at different places although their silhouettes agree.
#include "tracking/tracker/refuted_spans.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/tracker/small_camera.hpp"

namespace abstand::tracking {
namespace refuted_spans_test {

constexpr double kImage = 1.0 / 30.0;  // s
constexpr std::size_t kImages = 60;

/// For two seconds, a person at the origin whom the second camera sees at `off` (m).
std::vector<SeenTwice> bodiesOff(const Vector3d& off) {
  std::vector<SeenTwice> seen(kImages);
  for (std::size_t i = 0; i < kImages; ++i) {
    seen[i].t = static_cast<double>(i) * kImage;
    seen[i].first.set(humanmodel::Joint::kPelvis, {0.0, 0.0, 1.0});
    seen[i].second.set(humanmodel::Joint::kPelvis, Vector3d(0.0, 0.0, 1.0) + off);
    seen[i].off = off;
  }
  return seen;
}

std::vector<ThroughAt> sharesOf(double share, std::size_t known = kImages) {
  std::vector<ThroughAt> through(kImages);
  for (std::size_t i = 0; i < kImages; ++i)
    through[i] = {.t = static_cast<double>(i) * kImage, .share = i < known ? share : kNaN};
  return through;
}

const DepthCamera kFront = smallCameraAt({2.5, 0.0, 1.0}, {0.0, 0.0, 1.0}),
                  kSide = smallCameraAt({0.0, 2.5, 1.0}, {0.0, 0.0, 1.0}),
                  kBehind = smallCameraAt({-2.5, 0.0, 1.0}, {0.0, 0.0, 1.0});

std::size_t left(const Vector3d& off, const std::vector<ThroughAt>& through, const DepthCamera& second) {
  return withoutRefuted({{.distance = off.norm()}}, bodiesOff(off), through, kFront, second).size();
}

TEST(RefutedSpans, NothingIsSeenThrough) {
  for (const Vector3d& off : {Vector3d(0.15, 0.0, 0.0), Vector3d(0.0, 0.15, 0.0), Vector3d(0.0, 0.0, -0.15)})
    EXPECT_EQ(left(off, sharesOf(0.0), kSide), 0u) << off.transpose();
}

TEST(RefutedSpans, RealOnesStay) {
  const Vector3d aside(0.0, 0.15, 0.0);
  EXPECT_EQ(left(aside, sharesOf(ThroughAt::kShare), kSide), 1u) << "much is seen through";
  EXPECT_EQ(left(aside, sharesOf(kNaN), kSide), 1u) << "it is not known what is";
  EXPECT_EQ(left(aside, sharesOf(0.0, kImages / 3), kSide), 1u) << "it is hardly known";
  EXPECT_EQ(left({0.15, 0.0, 0.0}, sharesOf(0.0), kBehind), 1u) << "along the rays of both";
  EXPECT_EQ(left({0.0, 0.06, 0.0}, sharesOf(0.0), kSide), 1u) << "too little to be seen";
}

}  // namespace refuted_spans_test
}  // namespace abstand::tracking
