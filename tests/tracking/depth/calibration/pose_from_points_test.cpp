// Poses of cameras found again, and tables that are refused.
#include "tracking/depth/calibration/pose_from_points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/math/random.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::testing {
namespace pose_from_points_test {

std::vector<tracking::MatchedPoint> matched(const Transform& X_WC, std::size_t count, double noise,
                                            std::uint64_t seed) {
  Random random(seed, 0);
  std::vector<tracking::MatchedPoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    tracking::MatchedPoint p;
    for (int k = 0; k < 3; ++k) p.p_C[k] = random.between(-1.0, 1.0) + (k == 2 ? 2.5 : 0.0);
    p.p_W = X_WC * p.p_C;
    // Uniform with that standard deviation.
    for (int k = 0; k < 3; ++k) p.p_W[k] += noise * std::sqrt(12.0) * (random.unit() - 0.5);
    points.push_back(p);
  }
  return points;
}

TEST(PoseFromPoints, RecoversPose) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Transform X_WC = randomPose(seed, 3.0);
    for (const std::size_t count : {3u, 4u, 20u}) {
      const tracking::PoseFit fit = tracking::fitPose(matched(X_WC, count, 0.0, seed + 100));
      EXPECT_LT((fit.X_WC.matrix() - X_WC.matrix()).cwiseAbs().maxCoeff(), 1e-9) << seed << ", " << count;
      EXPECT_LT(fit.worst, 1e-9);
      EXPECT_GT(fit.X_WC.linear().determinant(), 0.0);
    }
  }
}

TEST(PoseFromPoints, SigmaMatchesPointNoise) {
  constexpr double kNoise = 0.004;  // m
  double sum = 0.0;
  constexpr int kSets = 200;
  for (int i = 0; i < kSets; ++i)
    sum += std::pow(
        tracking::fitPose(matched(randomPose(7, 2.0), 5, kNoise, static_cast<std::uint64_t>(i) + 1)).sigma,
        2);
  // 200 sets of 9 freedoms: the mean of their squares is within a tenth.
  EXPECT_NEAR(std::sqrt(sum / kSets), kNoise, 0.1 * kNoise);
}

TEST(PoseFromPoints, CovarianceMatchesMonteCarlo) {
  constexpr double kNoise = 0.004;  // m
  constexpr int kSets = 400;
  const Transform truth = randomPose(7, 2.0);
  Matrix3d squares = Matrix3d::Zero(), stated = Matrix3d::Zero();
  double above = 0.0;
  for (int i = 0; i < kSets; ++i) {
    const tracking::PoseFit fit =
        tracking::fitPose(matched(truth, 8, kNoise, static_cast<std::uint64_t>(i) + 1));
    const Vector3d off = fit.X_WC.translation() - truth.translation();
    squares += off * off.transpose();
    stated += tracking::covarianceAt(fit.covariance, fit.X_WC.translation() - fit.middle);
    above += off.norm() > 3.0 * fit.spread;
  }
  // 400 sets of mostly two bad directions: the mean square is within 15 % (three standard deviations).
  EXPECT_NEAR(stated.trace() / squares.trace(), 1.0, 0.15);
  EXPECT_LE(above, 0.01 * kSets);
}

TEST(PoseFromPoints, ReportsWorstPoint) {
  auto points = matched(randomPose(3, 2.0), 12, 0.0, 5);
  points[8].p_W.x() += 0.05;
  const tracking::PoseFit fit = tracking::fitPose(points);
  EXPECT_EQ(fit.worst_point, 8u);
  EXPECT_GT(fit.worst, 0.03);
}

TEST(PoseFromPoints, RejectsTooFewAndCollinearPoints) {
  auto points = matched(randomPose(3, 2.0), 6, 0.0, 5);
  EXPECT_THROW(tracking::fitPose(std::span(points).first(2)), UsageError);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = {Vector3d(0.1, 0.2, 0.3) * static_cast<double>(i),
                 Vector3d(0.3, 0.2, 0.1) * static_cast<double>(i)};
  EXPECT_THROW(tracking::fitPose(points), UsageError);
}

TEST(PoseFromPoints, ReportsTableErrorsWithPosition) {
  const std::string header = "cx,cy,cz,wx,wy,wz\n";
  EXPECT_EQ(tracking::readMatchedPoints(header + "1,2,3,4,5,6\r\n\n-1,0,1e-3,4,5,6\n", "p.csv").size(), 2u);
  struct Wrong {
    std::string text, says;
  };
  for (const Wrong& wrong :
       {Wrong{"", "p.csv:1:1: error: found nothing"}, Wrong{"x,y\n", "p.csv:1:1: error: found 'x,y'"},
        Wrong{header + "1,2,3\n", "p.csv:2:7: error: found 3 numbers"},
        Wrong{header + "1,2,3,4,5,x\n", "p.csv:2:11: error: found 'x'"},
        Wrong{header + "1,2,3,4,5,6,7\n", "p.csv:2:13: error: found more"},
        Wrong{header + "nan,2,3,4,5,6\n", "p.csv:2:1: error: found 'nan'"}}) {
    try {
      tracking::readMatchedPoints(wrong.text, "p.csv");
      ADD_FAILURE() << wrong.text;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), ::testing::HasSubstr(wrong.says));
    }
  }
}

}  // namespace pose_from_points_test
}  // namespace abstand::testing
