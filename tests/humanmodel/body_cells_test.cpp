// Cells of a part's surface.
#include "humanmodel/body_cells.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace abstand::humanmodel {
namespace body_cells_test {

constexpr double kRounding = 1e-12;

TEST(BodyCells, ContainTheirCentres) {
  for (std::size_t cell = 0; cell < kCellCount; ++cell) EXPECT_EQ(cellOf(cellMiddle(cell)), cell);
}

TEST(BodyCells, ContainDirectionsBetweenCorners) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.01, 1.0);
  for (std::size_t cell = 0; cell < kCellCount; ++cell) {
    const auto corners = cellCorners(cell);
    for (int i = 0; i < 20; ++i) {
      Vector3d u = Vector3d::Zero();
      for (const Vector3d& corner : corners) u += share(random) * corner;
      EXPECT_EQ(cellOf(3.0 * u), cell);
    }
  }
}

TEST(BodyCells, CoverSphereWithOutwardOrientation) {
  // Girard: the solid angles of all cells, two spherical triangles each (van Oosterom and Strackee 1983), sum
  // up to that of the ball; a cell whose corners ran the other way would count negative.
  double sum = 0.0, smallest = kInfinity, largest = 0.0;
  for (std::size_t cell = 0; cell < kCellCount; ++cell) {
    const auto c = cellCorners(cell);
    double angle = 0.0;
    for (const auto& [a, b, d] : {std::tuple{c[0], c[1], c[2]}, std::tuple{c[0], c[2], c[3]}})
      angle += 2.0 * std::atan2(a.dot(b.cross(d)), 1.0 + a.dot(b) + b.dot(d) + d.dot(a));
    sum += angle;
    smallest = std::min(smallest, angle);
    largest = std::max(largest, angle);
  }
  EXPECT_NEAR(sum, 4.0 * std::numbers::pi, 1e-9);
  EXPECT_GT(smallest, 0.7 * largest) << "equal angles make cells of about equal size";
}

TEST(BodyCells, LieOnSurface) {
  const geometry::Ellipsoid ellipsoid{{0.1, 0.2, 0.4}};
  const geometry::Cuboid cuboid{{0.1, 0.2, 0.4}};
  for (std::size_t cell = 0; cell < kCellCount; ++cell)
    for (const geometry::Shape& shape : {geometry::Shape(ellipsoid), geometry::Shape(cuboid)}) {
      const Vector3d p = surfacePoint(shape, cellMiddle(cell));
      EXPECT_NEAR(geometry::distanceTo(shape, p).distance, 0.0, kRounding);
      EXPECT_EQ(cellOf(p.cwiseQuotient(Vector3d(0.5 * geometry::bounds(shape).extent()))), cell);
    }
}

TEST(BodyCells, HaveReadableNames) {
  EXPECT_EQ(cellPlace(cellOf({1.0, 0.01, 0.01})), "front");
  EXPECT_EQ(cellPlace(cellOf({-1.0, 0.01, 0.9})), "back, upper end");
  EXPECT_EQ(cellPlace(cellOf({0.01, 1.0, 0.01})), "left");
  EXPECT_EQ(cellPlace(cellOf({0.01, 0.01, -1.0})), "lower end");
}

}  // namespace body_cells_test
}  // namespace abstand::humanmodel
