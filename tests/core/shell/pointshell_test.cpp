// Pointshells: count, areas, normals, cover, order, and overlaps with a half-space.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.hpp"
#include "core/shell/sub_triangles.hpp"
#include "tests/core/shell/half_space.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::shell {
namespace pointshell_test {

constexpr double kSpacing = 0.005;
/// Areas are stored as floats.
constexpr double kAreaTolerance = 1e-6;
/// Bumps within the piece of a mesh that a point stands for do not count.
constexpr double kMeshAreaTolerance = 0.01;
/// The force law's promise, relative to the overlapping volume, for depths from one spacing on.
constexpr double kVolumeTolerance = 0.02;
/// In 85 of 100 orientations.
constexpr double kUsualTolerance = 0.01;
/// Over all orientations the errors cancel: the rule is unbiased.
constexpr double kMeanTolerance = 0.007;

struct Body {
  std::string name;
  geometry::Shape shape;
  bool smooth;
};

std::vector<Body> bodies() {
  return {{"sphere 50", geometry::Sphere{0.05}, true},
          {"sphere 100", geometry::Sphere{0.1}, true},
          {"ellipsoid", geometry::Ellipsoid{{0.06, 0.09, 0.12}}, true},
          {"capsule", geometry::Capsule{0.04, 0.2}, true},
          {"cuboid 100", geometry::Cuboid{{0.1, 0.1, 0.1}}, false},
          {"cuboid 200", geometry::Cuboid{{0.2, 0.15, 0.1}}, false},
          {"cylinder", geometry::Cylinder{0.05, 0.12}, false},
          {"plate", geometry::Cuboid{{0.2, 0.1, 0.002}}, false}};
}

double totalArea(const Pointshell& shell) {
  double sum = 0.0;
  for (const float a : shell.area) sum += a;
  return sum;
}

TEST(Pointshell, ThesisSphereHasExpectedPointCount) {
  const Pointshell shell = makePointshell(*geometry::makeSurface(geometry::Sphere{0.05}), kSpacing);
  EXPECT_GE(shell.size(), 1000u);
  EXPECT_LE(shell.size(), 1200u);
}

TEST(Pointshell, AreasSumToSurfaceAndNormalsPointInwards) {
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.name);
    const auto surface = geometry::makeSurface(body.shape);
    const Pointshell shell = makePointshell(*surface, kSpacing);
    EXPECT_NEAR(totalArea(shell) / surface->area(), 1.0, kAreaTolerance);
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < shell.size(); ++i) {
      const Vector3d p = shell.point(i), n = shell.normal(i);
      ASSERT_GT(shell.area[i], 0.0f);
      ASSERT_NEAR(n.norm(), 1.0, 1e-6);
      ASSERT_NEAR(geometry::distanceTo(body.shape, p).distance, 0.0, 1e-7);
      ASSERT_LT(geometry::distanceTo(body.shape, p + 1e-6 * n).distance, -0.9e-6);
      sum += shell.area[i] * n;
    }
    EXPECT_LE(sum.norm(), 1e-3 * surface->area());
    // "About spacing^2" a point, and never fewer than the flat density gives.
    const double mean = surface->area() / shell.size() / (kSpacing * kSpacing);
    EXPECT_LE(mean, 1.3);
    EXPECT_GE(mean, body.name == "plate" ? 0.4 : 0.65);
  }
}

TEST(Pointshell, CuboidFacesKeepTheirAreas) {
  const Vector3d size(0.2, 0.15, 0.1);
  const Pointshell shell = makePointshell(*geometry::makeSurface(geometry::Cuboid{size}), kSpacing);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      double area = 0.0;
      for (std::size_t i = 0; i < shell.size(); ++i) {
        if (shell.normal(i)[axis] * side > 0.5) area += shell.area[i];
      }
      EXPECT_NEAR(area / (size.prod() / size[axis]), 1.0, 0.01);
    }
  }
}

TEST(Pointshell, CoveringRadiusHoldsEverywhereAndIsTight) {
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.name);
    const auto surface = geometry::makeSurface(body.shape);
    const Pointshell shell = makePointshell(*surface, kSpacing);
    EXPECT_LE(shell.covering_radius, 0.95 * kSpacing);
    std::vector<Vector3f> points;
    for (std::size_t i = 0; i < shell.size(); ++i) points.push_back(shell.point(i).cast<float>());
    const NearestOfPoints nearest(points);
    std::uint32_t index = 0;
    double farthest = 0.0;
    const geometry::TriangleMesh mesh = geometry::tessellate(body.shape, 1e-5);
    const SubTriangles pool(mesh, 0.2 * kSpacing, kInfinity, PitchField(mesh, kSpacing));
    pool.forEach([&](std::uint32_t, const SubTriangles::View& piece) {
      const Vector3d p = geometry::distanceTo(body.shape, piece.centroid()).nearest;
      farthest = std::max(farthest, nearest.distance(p, index));
    });
    EXPECT_LE(farthest, shell.covering_radius);
    // The check above looks every fifth of a spacing, and a shape adds its sagitta of a hundredth.
    EXPECT_GE(farthest, shell.covering_radius - 0.1 * kSpacing);
  }
}

TEST(Pointshell, EveryPrefixIsCoarserShell) {
  const auto surface = geometry::makeSurface(geometry::Ellipsoid{{0.06, 0.09, 0.12}});
  const Pointshell shell = makePointshell(*surface, kSpacing);
  for (std::size_t m = 32; m <= shell.size(); m *= 2) {
    std::vector<Vector3f> points;
    for (std::size_t i = 0; i < m; ++i) points.push_back(shell.point(i).cast<float>());
    const NearestOfPoints nearest(points);
    std::uint32_t index = 0;
    double farthest = 0.0;
    for (std::size_t i = 0; i < shell.size(); ++i)
      farthest = std::max(farthest, nearest.distance(shell.point(i), index));
    // A hexagonal packing covers within 0.62 sqrt(area per point); farthest points within about 0.9, and
    // centring moves each by half a spacing at most.
    EXPECT_LE(farthest, 1.05 * std::sqrt(surface->area() / static_cast<double>(m)) + 0.5 * kSpacing) << m;
  }
}

TEST(Pointshell, IsDeterministicForAnyThreadCount) {
  const auto surface = geometry::makeSurface(geometry::Cylinder{0.05, 0.12});
  const Pointshell one = makePointshell(*surface, kSpacing, 1);
  for (const int threads : {1, 2, 3, 7}) {
    const Pointshell other = makePointshell(*surface, kSpacing, threads);
    EXPECT_EQ(one.x, other.x);
    EXPECT_EQ(one.nz, other.nz);
    EXPECT_EQ(one.area, other.area);
    EXPECT_EQ(one.covering_radius, other.covering_radius);
  }
}

TEST(Pointshell, RejectsUnsuitableInput) {
  EXPECT_THROW(makePointshell(*geometry::makeSurface(geometry::Sphere{0.05}), 0.0), UsageError);
  EXPECT_THROW(makePointshell(*geometry::makeSurface(geometry::Sphere{0.05}), kNaN), UsageError);
  const geometry::TriangleMesh flat{{Vector3d::Zero(), Vector3d::UnitX(), 2.0 * Vector3d::UnitX()},
                                    {{0, 1, 2}}};
  EXPECT_THROW(makePointshell(*geometry::makeSurface(flat), kSpacing), UsageError);
  const geometry::TriangleMesh huge{{Vector3d::Zero(), 1e9 * Vector3d::UnitX(), 1e9 * Vector3d::UnitY()},
                                    {{0, 1, 2}}};
  EXPECT_THROW(makePointshell(*geometry::makeSurface(huge), kSpacing), UsageError);
}

TEST(Pointshell, OpenSliversAndSmallBodiesGetPoints) {
  const geometry::TriangleMesh sliver{{Vector3d::Zero(), Vector3d(1.0, 0.0, 0.0), Vector3d(0.5, 1e-6, 0.0)},
                                      {{0, 1, 2}}};
  const Pointshell thin = makePointshell(*geometry::makeSurface(sliver), kSpacing);
  EXPECT_GE(thin.size(), 100u);
  EXPECT_LE(thin.covering_radius, kSpacing);
  const auto grain = geometry::makeSurface(geometry::Sphere{1e-4});
  const Pointshell small = makePointshell(*grain, kSpacing);
  EXPECT_GE(small.size(), 4u);
  EXPECT_NEAR(totalArea(small) / grain->area(), 1.0, kAreaTolerance);
}

/// Presses a body into a wall, in many orientations and depths, and compares with the exact overlap.
void pressIntoWall(const geometry::TriangleMesh& exact, const Pointshell& shell) {
  std::vector<Vector3d> directions;
  for (int i = 0; i < 27; ++i) {
    if (i != 13) directions.push_back(Vector3d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1).normalized());
  }
  for (std::uint64_t seed = 1; seed <= 74; ++seed)
    directions.push_back(testing::randomPose(seed).linear().col(2));
  // Nearly along the axes, edges and diagonals of a box: where an edge just tilts.
  for (std::uint64_t seed = 1; seed <= 104; ++seed) {
    const Vector3d tilt = 0.02 * double(seed % 5 + 1) * testing::randomPose(1000 + seed).linear().col(2);
    directions.push_back((directions[seed % 26] + tilt).normalized());
  }
  for (const double depth : {kSpacing, 0.0075, 0.01, 0.015, 0.02}) {
    SCOPED_TRACE(depth);
    double mean = 0.0;
    std::vector<double> errors;
    for (const Vector3d& u : directions) {
      const double level = testing::levelAt(exact, u, depth);
      const double volume = testing::volumeBelow(exact, u, level);
      const Vector3d force = testing::shellForce(shell, u, level);
      errors.push_back((force - volume * u).dot(u) / volume);
      mean += errors.back() / static_cast<double>(directions.size());
      errors.back() = std::abs(errors.back());
      EXPECT_LE(errors.back(), kVolumeTolerance) << u.transpose();
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LE(errors[errors.size() * 85 / 100], kUsualTolerance);
    EXPECT_LE(std::abs(mean), kMeanTolerance);
  }
}

TEST(Pointshell, ShapesPressedIntoWallGiveOverlapVolume) {
  for (const Body& body : bodies()) {
    if (body.name == "plate") continue;
    SCOPED_TRACE(body.name);
    pressIntoWall(geometry::tessellate(body.shape, 2e-5),
                  makePointshell(*geometry::makeSurface(body.shape), kSpacing));
  }
}

TEST(Pointshell, BunnyPressedIntoWallGivesOverlapVolume) {
  const auto file = testing::sharedData("meshes/bunny.off");
  if (!exists(file)) GTEST_SKIP() << file;
  const geometry::TriangleMesh mesh = testing::readOff(file, 0.2);
  const Pointshell shell = makePointshell(*geometry::makeSurface(mesh), kSpacing);
  EXPECT_NEAR(totalArea(shell) / geometry::surfaceArea(mesh), 1.0, kMeshAreaTolerance);
  EXPECT_LE(totalArea(shell), geometry::surfaceArea(mesh));
  pressIntoWall(mesh, shell);
}

}  // namespace pointshell_test
}  // namespace abstand::shell
