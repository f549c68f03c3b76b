// Planes found among points that lie elsewhere, whose truth is known.
#include "tracking/depth/people/floor_consensus.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/random.hpp"

namespace abstand::testing {
namespace floor_consensus_test {

constexpr double kThick = 0.01;  // m

/// Half of the grid's rows, the lower ones, lie on a floor 1.2 m below the camera that leans by 10 degrees;
/// the rest, and every third point of the floor, anywhere in a cube.
struct Scattered {
  Scattered() {
    truth = {Eigen::AngleAxisd(unit::deg(10.0), Vector3d::UnitX()) * -Vector3d::UnitY(), 1.2};
    grid.columns = 40;
    grid.rows = 30;
    Random random(3, 0);
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        Vector3d p = random.inCube(1.5) + Vector3d(0, 0, 3.0);
        if (row >= grid.rows / 2 && (row + column) % 3 != 0) p -= truth.above(p) * truth.up;
        grid.points.push_back(p);
      }
  }
  std::size_t on(const tracking::FloorPlane& plane) const {
    std::size_t count = 0;
    for (const Vector3d& p : grid.points) count += std::abs(plane.above(p)) < kThick;
    return count;
  }
  tracking::FloorPlane truth;
  tracking::PointGrid grid;
};

TEST(FloorConsensus, FindsPlaneWithMostPoints) {
  const Scattered s;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const tracking::ConsensusOptions options{unit::deg(35.0), 0.999, 2000, seed};
    const auto count = [&](const tracking::FloorPlane& plane) { return s.on(plane); };
    const auto plane = tracking::consensusPlane(s.grid, options, count);
    ASSERT_TRUE(plane.has_value()) << seed;
    // Its three points are exact, but floats of PCL's.
    EXPECT_NEAR(plane->up.norm(), 1.0, 1e-6);
    EXPECT_GT(plane->up.dot(s.truth.up), std::cos(unit::deg(0.01))) << seed;
    EXPECT_NEAR(plane->height, s.truth.height, 1e-4) << seed;
    const auto again = tracking::consensusPlane(s.grid, options, count);
    EXPECT_EQ(again->up, plane->up);
    EXPECT_EQ(again->height, plane->height);
  }
}

TEST(FloorConsensus, RejectsTiltedAndUncountedPlanes) {
  const Scattered s;
  std::size_t most = 0;
  const auto plane =
      tracking::consensusPlane(s.grid, {unit::deg(8.0), 0.999, 500, 1}, [&](const tracking::FloorPlane& p) {
        EXPECT_LT(std::acos(-p.up.y()), unit::deg(8.01));
        most = std::max(most, s.on(p));
        return s.on(p);
      });
  EXPECT_LT(most, 200u);  // the floor has 400 and leans by 10 degrees
  ASSERT_TRUE(plane.has_value());
  EXPECT_FALSE(
      tracking::consensusPlane(s.grid, {unit::deg(35.0), 0.999, 500, 1}, [](const tracking::FloorPlane&) {
        return std::size_t{0};
      }).has_value());
}

TEST(FloorConsensus, FindsNothingInNearlyEmptyImages) {
  const auto all = [](const tracking::FloorPlane&) { return std::size_t{1}; };
  tracking::PointGrid grid;
  EXPECT_FALSE(tracking::consensusPlane(grid, {1.0, 0.99, 100, 1}, all).has_value());
  grid.columns = 100;
  grid.rows = 1;
  grid.points.assign(100, Vector3d::Zero());
  EXPECT_FALSE(tracking::consensusPlane(grid, {1.0, 0.99, 100, 1}, all).has_value());
  // Measured, but far from each other.
  for (const std::size_t i : {0u, 50u, 99u}) grid.points[i] = Vector3d(0.01 * i, 1.0, 2.0 + 0.1 * i);
  EXPECT_FALSE(tracking::consensusPlane(grid, {1.0, 0.99, 100, 1}, all).has_value());
}

}  // namespace floor_consensus_test
}  // namespace abstand::testing
