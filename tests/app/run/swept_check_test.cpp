// Between two frames nothing is missed: passing by in closed form, passing through, and turning.
#include "app/run/swept_check.hpp"

#include <gtest/gtest.h>

#include "app/run/distance_check.hpp"
#include "core/structure/haptic_structure.hpp"

namespace abstand::run {
namespace swept_check_test {

std::shared_ptr<const structure::HapticStructure> build(const char* name, const geometry::Shape& shape) {
  structure::HapticOptions options;
  options.voxel_size = options.point_spacing = 0.01;
  return structure::buildHapticStructure(name, geometry::makeSurface(shape), options);
}

/// A wall across x = 0, 2 cm thick, and a ball of 5 cm.
class SweptCheckTest : public ::testing::Test {
 protected:
  SweptCheckTest() {
    wall_ = scene_.addObject({"wall", "objects", build("wall", geometry::Cuboid{{0.02, 0.6, 0.6}}), 0.0});
    ball_ = scene_.addObject({"ball", "objects", build("ball", geometry::Sphere{0.05}), 0.0});
    scene_.addPair(wall_, ball_);
  }
  /// The pair's results with the ball at p.
  std::vector<query::PairResult> at(double t, const Vector3d& p) {
    Transform X = Transform::Identity();
    X.translation() = p;
    scene_.setPose(ball_, X, t);
    scene_.step();
    return {scene_.pairs()[0].result};
  }

  scene::Scene scene_;
  ObjectId wall_{0}, ball_{0};
};

TEST_F(SweptCheckTest, PassingObjectMatchesClosedForm) {
  SweptCheck swept(scene_);
  const double limit = 0.2;
  EXPECT_EQ(swept.frame(0.0, at(0.0, {0.11, -1, 0}), {&limit, 1})[0].lower, kInfinity) << "nothing before";
  const auto between = swept.frame(0.01, at(0.01, {0.11, 1, 0}), {&limit, 1})[0];
  // 0.11 m less the half wall and the ball's radius, while y is within the wall.
  EXPECT_NEAR(between.upper, 0.05, 2e-4);
  EXPECT_LE(between.lower, 0.05);
  EXPECT_GT(between.lower, 0.05 - 2e-3);
  // A millimetre beyond the rim is 10 um farther away, less than the check tells apart.
  EXPECT_NEAR(between.t, 0.005, 0.0015 + 0.5e-5);
}

TEST_F(SweptCheckTest, DistantObjectNeedsNoQuery) {
  SweptCheck swept(scene_);
  const double limit = 0.1;
  swept.frame(0.0, at(0.0, {1.0, 0, 0}), {&limit, 1});
  const auto between = swept.frame(0.01, at(0.01, {0.9, 0, 0}), {&limit, 1})[0];
  EXPECT_EQ(swept.queries(), 0);
  EXPECT_GE(between.lower, limit);
  EXPECT_LE(between.lower, 0.84);
}

TEST_F(SweptCheckTest, PassThroughIsFoundOnlyBetweenFrames) {
  for (const bool look : {false, true}) {
    DistanceCheck check(scene_, 0.01, false, look, "");
    check.frame(0.0, at(0.0, {0.4, 0, 0}));
    check.frame(0.01, at(0.01, {-0.4, 0, 0}));
    CheckResult all;
    check.finish({}, all);
    ASSERT_EQ(all.violations.size(), look ? 1u : 0u);
    if (!look) continue;
    // In the middle the ball is in the wall by its radius and half the wall.
    EXPECT_LT(all.violations[0].min_distance, -0.04);
    EXPECT_GT(all.violations[0].start, 0.004);
    EXPECT_LT(all.violations[0].start, 0.006);
    EXPECT_GT(all.swept_queries, 0);
  }
}

TEST_F(SweptCheckTest, BackwardJumpIsNotSwept) {
  SweptCheck swept(scene_);
  const double limit = 0.1;
  swept.frame(1.0, at(1.0, {0.4, 0, 0}), {&limit, 1});
  EXPECT_EQ(swept.frame(0.0, at(0.0, {-0.4, 0, 0}), {&limit, 1})[0].lower, kInfinity);
}

}  // namespace swept_check_test
}  // namespace abstand::run
