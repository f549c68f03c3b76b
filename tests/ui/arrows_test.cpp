// Lengths of the arrows of the 3D view.
#include "ui/viewport/arrows.hpp"

#include <gtest/gtest.h>
#include <vtkNew.h>

namespace abstand::ui {
namespace arrows_test {

constexpr double kRounding = 1e-6;       // m; points of arrows are single precision
constexpr double kLongestArrow = 0.4;    // m
constexpr double kShortestArrow = 0.06;  // m

/// Two bodies that push each other apart along x at the origin.
struct ArrowsTest : ::testing::Test {
  void SetUp() override {
    outline.objects.resize(2);
    outline.pairs.resize(1);
    outline.pairs[0].first = 0;
    outline.pairs[0].second = 1;
    snapshot.objects.resize(2);
    snapshot.pairs.resize(1);
    options.auto_scale = false;
    arrows.open(outline);
  }
  /// Length that is drawn, m, for this force of the pair, N.
  double lengthOf(double newtons) {
    query::PairResult& result = snapshot.pairs[0].result;
    result.contacts = 1;
    result.force_a = Vector3d(newtons, 0, 0);
    result.witness_a = result.witness_b = Vector3d::Zero();
    arrows.refresh(outline, snapshot, options);
    double bounds[6];
    renderer->ComputeVisiblePropBounds(bounds);
    EXPECT_NEAR(bounds[0], -bounds[1], kRounding) << "the other body is pushed as hard";
    return bounds[1] > bounds[0] ? bounds[1] : 0.0;
  }
  vtkNew<vtkRenderer> renderer;
  Arrows arrows{renderer};
  view::SceneOutline outline;
  view::SceneSnapshot snapshot;
  ViewOptions options;
};

TEST_F(ArrowsTest, LengthIsProportionalToForceOnFixedScale) {
  options.metres_per_newton = 0.002;
  EXPECT_NEAR(lengthOf(50.0), 0.1, kRounding);
  EXPECT_NEAR(lengthOf(100.0), 0.2, kRounding);
  options.metres_per_newton = 0.001;
  EXPECT_NEAR(lengthOf(100.0), 0.1, kRounding);
}

TEST_F(ArrowsTest, LengthHasLimits) {
  options.metres_per_newton = 0.002;
  EXPECT_NEAR(lengthOf(5000.0), kLongestArrow, kRounding);
  EXPECT_NEAR(lengthOf(1.0), kShortestArrow, kRounding);
}

TEST_F(ArrowsTest, LargestForceIsLongestOnAutomaticScale) {
  options.auto_scale = true;
  EXPECT_NEAR(lengthOf(3.0), kLongestArrow, kRounding);
  EXPECT_NEAR(lengthOf(300.0), kLongestArrow, kRounding);
  EXPECT_EQ(arrows.virtualScale().value, 300.0) << "the legend says what that length means";
  EXPECT_NEAR(arrows.virtualScale().metres, kLongestArrow, kRounding);
}

TEST_F(ArrowsTest, SmallForcesAreNotDrawn) {
  options.min_force = 2.0;
  EXPECT_EQ(lengthOf(1.9), 0.0);
  EXPECT_EQ(arrows.virtualScale().metres, 0.0) << "no line in the legend";
  EXPECT_GT(lengthOf(2.1), 0.0);
}

TEST_F(ArrowsTest, TouchingBodiesHaveContactForces) {
  snapshot.pairs[0].result.distance = 0.05;
  lengthOf(10.0);
  EXPECT_EQ(arrows.forceScale().metres, 0.0);
  EXPECT_GT(arrows.virtualScale().metres, 0.0);
  snapshot.pairs[0].result.distance = -0.01;
  lengthOf(10.0);
  EXPECT_GT(arrows.forceScale().metres, 0.0);
  EXPECT_EQ(arrows.virtualScale().metres, 0.0);
}

}  // namespace arrows_test
}  // namespace abstand::ui
