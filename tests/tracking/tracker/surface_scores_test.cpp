// Misfits of many points against those of single ones.
#include "tracking/tracker/surface_scores.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "tests/support/random_pose.hpp"
#include "tests/tracking/tracker/test_surface.hpp"

namespace abstand::tracking {
namespace surface_scores_test {

constexpr float kNormalWeight = 0.03f;  // m
constexpr double kRounding = 1e-5;      // m; float against double
constexpr float kHighest = std::numeric_limits<float>::max();

/// 301 points: not a multiple of any number of lanes.
struct SurfaceScores : ::testing::TestWithParam<bool> {
  std::unique_ptr<SeenPoints> points = std::make_unique<SeenPoints>();
  std::vector<float> best;
  FitSurface surface = surfaceOf(GetParam());
  Transform X_WS = testing::randomPose(9, 1.0);

  SurfaceScores() {
    points->count = 301;
    best.assign(points->count, kHighest);
    for (std::size_t i = 0; i < points->count; ++i) {
      const Vector3d p = X_WS * Vector3d(testing::randomPose(i + 1, 0.25).translation());
      const Vector3d n = testing::randomPose(i + 1000, 1.0).translation().normalized();
      points->x[i] = static_cast<float>(p.x()), points->nx[i] = static_cast<float>(n.x());
      points->y[i] = static_cast<float>(p.y()), points->ny[i] = static_cast<float>(n.y());
      points->z[i] = static_cast<float>(p.z()), points->nz[i] = static_cast<float>(n.z());
    }
  }
  ScoredPoints scored() const { return {*points, kNormalWeight}; }
  double expected(std::size_t i) const {
    Vector3d g;
    const double level = surface.level(X_WS.inverse() * points->point(i) - surface.centre.cast<double>(), g);
    return std::abs((level - 1.0) / g.norm()) +
           kNormalWeight * (1.0 - (X_WS.linear() * g.normalized()).dot(points->normal(i)));
  }
};

TEST_P(SurfaceScores, MatchSingleEvaluations) {
  scoreOf(surface, X_WS, scored(), best.data());
  for (std::size_t i = 0; i < points->count; ++i) EXPECT_NEAR(best[i], expected(i), kRounding);
}

TEST_P(SurfaceScores, OnlyLowerWhatIsHigher) {
  constexpr float kBest = 0.1f;  // m
  best.assign(points->count, kBest);
  scoreOf(surface, X_WS, scored(), best.data());
  int lowered = 0;
  for (std::size_t i = 0; i < points->count; ++i) {
    EXPECT_NEAR(best[i], std::min(expected(i), static_cast<double>(kBest)), kRounding);
    lowered += best[i] < kBest;
  }
  EXPECT_GT(lowered, 30);
  EXPECT_LT(lowered, 270);
}

TEST_P(SurfaceScores, AssignTheSegmentOfTheLowest) {
  const Transform X_WO = X_WS * Eigen::Translation3d(0.1, 0.0, 0.05);
  std::vector<float> other(points->count, kHighest);
  scoreOf(surface, X_WO, scored(), other.data());
  std::vector<std::int32_t> segment(points->count, -1);
  assignOf(surface, X_WS, scored(), 3, best.data(), segment.data());
  const std::vector<float> first = best;
  assignOf(surface, X_WO, scored(), 7, best.data(), segment.data());
  int changed = 0;
  for (std::size_t i = 0; i < points->count; ++i) {
    EXPECT_EQ(best[i], std::min(first[i], other[i]));
    EXPECT_EQ(segment[i], other[i] < first[i] ? 7 : 3);
    changed += segment[i] == 7;
  }
  EXPECT_GT(changed, 30);
  EXPECT_LT(changed, 270);
}

TEST_P(SurfaceScores, AddTheExtraTerm) {
  std::vector<float> extra(points->count), with = best;
  for (std::size_t i = 0; i < extra.size(); ++i) extra[i] = i % 3 == 0 ? 0.25f : 0.0f;
  scoreOf(surface, X_WS, scored(), best.data());
  scoreOf(surface, X_WS, {*points, kNormalWeight, extra.data()}, with.data());
  for (std::size_t i = 0; i < extra.size(); ++i) EXPECT_EQ(with[i], best[i] + extra[i]);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SurfaceScores, ::testing::Bool(),
                         [](const auto& one) { return one.param ? "drum" : "ellipsoid"; });

}  // namespace surface_scores_test
}  // namespace abstand::tracking
