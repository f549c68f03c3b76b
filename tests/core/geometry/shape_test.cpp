// Exact distances, areas and masses of the shapes, and how they are written.
#include "core/geometry/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::geometry {
namespace shape_test {

using testing::implicitValue;
using testing::pairUncertainty;
using testing::randomPoint;
using testing::randomUnit;
using testing::someShapes;

/// What shape.hpp promises, relative to the shape's size plus the point's distance from its centre.
constexpr double kExact = 1e-12;

struct DistanceCase {
  const char* name;
  Shape shape;
  Vector3d p;
  double distance;
  Vector3d nearest;  ///< NaN where several points are nearest
};
const Vector3d kAny = Vector3d::Constant(kNaN);

class ShapeDistanceTable : public ::testing::TestWithParam<DistanceCase> {};

TEST_P(ShapeDistanceTable, MatchesClosedForm) {
  const auto& c = GetParam();
  const auto found = distanceTo(c.shape, c.p);
  const double tolerance = kExact * (pairUncertainty(c.shape) + c.p.norm());
  EXPECT_NEAR(found.distance, c.distance, tolerance);
  EXPECT_NEAR(implicitValue(c.shape, found.nearest), 0.0, kExact);
  if (c.nearest.allFinite()) {
    EXPECT_LE((found.nearest - c.nearest).norm(), tolerance) << found.nearest.transpose();
  }
}

const double kRoot3 = std::sqrt(3.0);
INSTANTIATE_TEST_SUITE_P(
    Shapes, ShapeDistanceTable,
    ::testing::Values(
        DistanceCase{"sphere outside", Sphere{2}, {3, 0, 4}, 3, {1.2, 0, 1.6}},
        DistanceCase{"sphere inside", Sphere{2}, {0, -1, 0}, -1, {0, -2, 0}},
        DistanceCase{"sphere centre", Sphere{2}, {0, 0, 0}, -2, kAny},
        DistanceCase{"sphere tiny offset", Sphere{2}, {0, 0, 1e-300}, -2, {0, 0, 2}},
        DistanceCase{"cuboid over face", Cuboid{{2, 4, 6}}, {0.5, 0.5, 5}, 2, {0.5, 0.5, 3}},
        DistanceCase{"cuboid over edge", Cuboid{{2, 4, 6}}, {4, 6, 0}, 5, {1, 2, 0}},
        DistanceCase{"cuboid over corner", Cuboid{{2, 4, 6}}, {2, 3, 4}, kRoot3, {1, 2, 3}},
        DistanceCase{"cuboid on face", Cuboid{{2, 4, 6}}, {1, 0, 0}, 0, {1, 0, 0}},
        DistanceCase{"cuboid inside", Cuboid{{2, 4, 6}}, {0.5, -1.75, 0}, -0.25, {0.5, -2, 0}},
        DistanceCase{"cuboid centre", Cuboid{{2, 4, 6}}, {0, 0, 0}, -1, kAny},
        DistanceCase{"cylinder side", Cylinder{1, 4}, {3, 4, 1}, 4, {0.6, 0.8, 1}},
        DistanceCase{"cylinder cap", Cylinder{1, 4}, {0.5, 0, -3}, 1, {0.5, 0, -2}},
        DistanceCase{"cylinder beyond rim", Cylinder{1, 4}, {0, 4, 6}, 5, {0, 1, 2}},
        DistanceCase{"cylinder inside by side", Cylinder{1, 4}, {0, 0.75, 0.5}, -0.25, {0, 1, 0.5}},
        DistanceCase{"cylinder inside by cap", Cylinder{1, 4}, {0, 0.25, 1.5}, -0.5, {0, 0.25, 2}},
        DistanceCase{"cylinder axis", Cylinder{1, 4}, {0, 0, 0}, -1, kAny},
        DistanceCase{"cylinder axis above", Cylinder{1, 4}, {0, 0, 5}, 3, {0, 0, 2}},
        DistanceCase{"capsule side", Capsule{1, 4}, {0, 3, -2}, 2, {0, 1, -2}},
        DistanceCase{"capsule end", Capsule{1, 4}, {0, 3, 6}, 4, {0, 0.6, 2.8}},
        DistanceCase{"capsule axis", Capsule{1, 4}, {0, 0, 1}, -1, kAny},
        DistanceCase{"capsule axis inside the end", Capsule{1, 4}, {0, 0, 2.5}, -0.5, {0, 0, 3}},
        DistanceCase{"capsule without length", Capsule{1, 0}, {0, 0, 0}, -1, kAny},
        DistanceCase{"capsule without length outside", Capsule{1, 0}, {0, 0, -4}, 3, {0, 0, -1}},
        DistanceCase{"ellipsoid centre", Ellipsoid{{3, 2, 1}}, {0, 0, 0}, -1, kAny},
        DistanceCase{"ellipsoid centre, two short axes", Ellipsoid{{1, 2, 1}}, {0, 0, 0}, -1, kAny},
        DistanceCase{"ellipsoid centre, long y", Ellipsoid{{2, 3, 1}}, {-0.0, 0, -0.0}, -1, kAny},
        DistanceCase{"ellipsoid on long axis outside", Ellipsoid{{3, 2, 1}}, {-5, 0, 0}, 2, {-3, 0, 0}},
        DistanceCase{"ellipsoid on middle axis outside", Ellipsoid{{3, 2, 1}}, {0, 5, 0}, 3, {0, 2, 0}},
        DistanceCase{"ellipsoid on short axis inside", Ellipsoid{{3, 2, 1}}, {0, 0, 0.5}, -0.5, {0, 0, 1}},
        DistanceCase{"ellipsoid vertex", Ellipsoid{{3, 2, 1}}, {3, 0, 0}, 0, {3, 0, 0}},
        // the last centre of curvature on the long axis is at (9 - 1) / 3; beyond it the vertex is nearest
        DistanceCase{"ellipsoid beyond the evolute", Ellipsoid{{3, 2, 1}}, {2.7, 0, 0}, -0.3, {3, 0, 0}},
        // before it: x = 9 p / 8, z^2 = 1 - x^2 / 9
        DistanceCase{
            "ellipsoid before the evolute", Ellipsoid{{3, 2, 1}}, {1.6, 0, 0}, -std::hypot(0.2, 0.8), kAny},
        // spheroid: the nearest points form a circle
        DistanceCase{"oblate, on the axis", Ellipsoid{{2, 2, 1}}, {0, 0, 0.25}, -0.75, {0, 0, 1}},
        DistanceCase{"prolate, on the axis", Ellipsoid{{1, 1, 2}}, {0, 0, 0.75}, -std::sqrt(0.8125), kAny},
        DistanceCase{"ellipsoid as a ball", Ellipsoid{{2, 2, 2}}, {3, 0, 4}, 3, {1.2, 0, 1.6}},
        // p = x + t n with x = (3 s, 2 s, s), s = 1 / sqrt 3, n ~ (s / 3, s / 2, s), |n| = 7/6 s, t = 7/6
        DistanceCase{"ellipsoid oblique",
                     Ellipsoid{{3, 2, 1}},
                     {3 / kRoot3 + 1.0 / 3, -2 / kRoot3 - 0.5, 1 / kRoot3 + 1},
                     7.0 / 6,
                     {3 / kRoot3, -2 / kRoot3, 1 / kRoot3}}),
    [](const auto& i) {
      std::string name = i.param.name;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
      return name;
    });

/// Points at all scales: far, around, inside, and near or on the planes of symmetry.
Vector3d hardPoint(const Shape& shape, std::uint64_t seed) {
  const double size = pairUncertainty(shape);
  const double scales[] = {0.3, 1.0, 1.0, 3.0, 1e4};
  Vector3d p = randomPoint(seed, size * scales[seed % 5]);
  for (int i = 0; i < 3; ++i) {
    const double u = randomUnit(seed, 50 + static_cast<std::uint64_t>(i));
    if (u < 0.10) p[i] = 0.0;
    if (u > 0.90) p[i] *= std::pow(10.0, -300.0 * (u - 0.90) / 0.10);
  }
  return p;
}

TEST(ShapeDistanceProperties, NearestIsOnSurfaceWithRightSign) {
  for (const auto& shape : someShapes()) {
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
      const Vector3d p = hardPoint(shape, seed);
      const auto found = distanceTo(shape, p);
      const double tolerance = kExact * (pairUncertainty(shape) + p.norm());
      ASSERT_TRUE(std::isfinite(found.distance)) << shapeName(shape) << " " << seed;
      ASSERT_NEAR(std::abs(found.distance), (p - found.nearest).norm(), tolerance)
          << shapeName(shape) << " " << seed;
      ASSERT_NEAR(implicitValue(shape, found.nearest), 0.0, kExact) << shapeName(shape) << " " << seed;
      if (std::abs(found.distance) > tolerance) {
        ASSERT_EQ(found.distance > 0.0, implicitValue(shape, p) > 0.0) << shapeName(shape) << " " << seed;
      }
    }
  }
}

TEST(ShapeDistanceProperties, NoSurfacePointIsNearer) {
  for (const auto& shape : someShapes()) {
    const double sagitta = pairUncertainty(shape) / 500.0;
    const auto mesh = tessellate(shape, sagitta);
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const Vector3d p = hardPoint(shape, seed);
      const double exact = std::abs(distanceTo(shape, p).distance);
      const double tolerance = kExact * (pairUncertainty(shape) + p.norm());
      for (const auto& v : mesh.vertices)
        ASSERT_LE(exact, (v - p).norm() + tolerance) << shapeName(shape) << " " << seed;
      ASSERT_NEAR(exact, testing::unsignedDistance(mesh, p), sagitta + tolerance)
          << shapeName(shape) << " " << seed;
    }
  }
}

TEST(ShapeDistanceProperties, IsLipschitzContinuous) {
  for (const auto& shape : someShapes()) {
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
      const Vector3d p = hardPoint(shape, 5 * (seed / 5) + 1);
      const double step = pairUncertainty(shape) * std::pow(10.0, -9.0 * randomUnit(seed, 1));
      const Vector3d q = p + randomPoint(seed + 1'000'000, step);
      const double difference = std::abs(distanceTo(shape, p).distance - distanceTo(shape, q).distance);
      ASSERT_LE(difference, (p - q).norm() + kExact * (pairUncertainty(shape) + p.norm()))
          << shapeName(shape) << " " << seed;
    }
  }
}

TEST(ShapeDistanceProperties, EllipsoidNearestPointIsFootOfNormal) {
  // Twelve orders of magnitude between the axes, and points as near to the focal plane.
  const Vector3d axes[] = {
      {0.3, 0.1, 0.09}, {1, 1, 1e-3}, {1e-3, 1, 1e-3}, {1e6, 1, 1e-6}, {1, 1 - 1e-9, 1 + 1e-9}};
  for (const auto& a : axes) {
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
      Vector3d p = randomPoint(seed, 1.5).cwiseProduct(a);
      p[static_cast<int>(seed % 3)] *= std::pow(10.0, -16.0 * randomUnit(seed, 7));
      const auto found = distanceTo(Ellipsoid{a}, p);
      const Vector3d normal = found.nearest.cwiseQuotient(a.cwiseAbs2()).stableNormalized();
      const Vector3d back = p - found.distance * normal;
      ASSERT_LE((back - found.nearest).norm(), kExact * (a.maxCoeff() + p.norm()))
          << a.transpose() << " seed " << seed;
    }
  }
}

TEST(ShapeDistanceProperties, AllocatesNothing) {
  const auto shapes = someShapes();
  const testing::NoAlloc guard;
  double sum = 0.0;
  for (const auto& shape : shapes)
    for (std::uint64_t seed = 0; seed < 20; ++seed) sum += distanceTo(shape, randomPoint(seed, 0.3)).distance;
  EXPECT_EQ(guard.count(), 0);
  EXPECT_TRUE(std::isfinite(sum));
}

TEST(ShapeArea, EllipsoidsMatchSpheroidClosedForms) {
  for (const double q : {0.001, 0.1, 0.9, 0.999999, 1.000001, 1.5, 10.0, 1000.0}) {
    // semi-axes 1, 1, q
    const double e = std::sqrt(std::abs(1.0 - q * q)) / std::max(1.0, q);
    const double expected =
        q < 1.0 ? 2 * kPi * (1 + q * q / e * std::atanh(e)) : 2 * kPi * (1 + q / e * std::asin(e));
    // the closed forms themselves lose digits as e goes to 0
    EXPECT_NEAR(surfaceArea(Ellipsoid{{1, 1, q}}) / expected, 1.0, 1e-9) << q;
    EXPECT_NEAR(surfaceArea(Ellipsoid{{q, 1, 1}}) / surfaceArea(Ellipsoid{{1, 1, q}}), 1.0, 1e-14) << q;
  }
  EXPECT_NEAR(surfaceArea(Ellipsoid{{2, 2, 2}}), 16 * kPi, 1e-13);
  // by Gauss quadrature over the height and trapezoids round it
  EXPECT_NEAR(surfaceArea(Ellipsoid{{3, 2, 1}}), 48.882146302582, 1e-11);
}

TEST(ShapeMass, MatchesClosedForm) {
  const auto box = massProperties(Shape{Cuboid{{1, 2, 3}}});
  EXPECT_NEAR(box.volume, 6, 1e-14);
  EXPECT_TRUE(box.inertia.isApprox(Vector3d(6.5, 5, 2.5).asDiagonal().toDenseMatrix(), 1e-14));
  // A capsule's ends are a ball cut in halves: with no middle part it is the ball.
  const auto ball = massProperties(Shape{Sphere{0.2}});
  const auto pill = massProperties(Shape{Capsule{0.2, 0.0}});
  EXPECT_NEAR(pill.volume, ball.volume, 1e-16);
  EXPECT_TRUE(pill.inertia.isApprox(ball.inertia, 1e-14));
  EXPECT_TRUE(massProperties(Shape{Ellipsoid{{0.2, 0.2, 0.2}}}).inertia.isApprox(ball.inertia, 1e-14));
}

TEST(ShapeText, ParsesDocumentedSyntax) {
  EXPECT_EQ(std::get<Sphere>(*parseShape("sphere:0.05")).radius, 0.05);
  EXPECT_EQ(std::get<Cuboid>(*parseShape("cuboid:1,2,3")).size, Vector3d(1, 2, 3));
  EXPECT_EQ(std::get<Ellipsoid>(*parseShape("ellipsoid:.1,2e-1,3")).semi_axes, Vector3d(0.1, 0.2, 3));
  EXPECT_EQ(std::get<Cylinder>(*parseShape("cylinder:0.1,0.5")).length, 0.5);
  EXPECT_EQ(std::get<Capsule>(*parseShape("capsule:0.1,0")).length, 0.0);
  for (const char* name : {"robot.stl", "sphere", "C:sphere.stl", "", ":", "Sphere:1", " sphere:1"})
    EXPECT_FALSE(parseShape(name)) << name;
  for (const char* wrong : {"sphere:", "sphere:-1", "sphere:0", "sphere:1,2", "sphere:nan", "sphere:1e9",
                            "cuboid:1,2", "cuboid:1,2,3,4", "cuboid:1,,3", "capsule:0.1,-1", "cylinder:1,0",
                            "cylinder:0x1,1", "ellipsoid:1,2,3 ", "sphere:1e-300"})
    EXPECT_THROW(parseShape(wrong), UsageError) << wrong;
}

TEST(ShapeText, ReportsFoundAndExpected) {
  try {
    parseShape("cuboid:1,2");
    FAIL();
  } catch (const UsageError& e) {
    EXPECT_STREQ(e.what(), "cuboid:1,2: found 2 numbers, expected cuboid:x,y,z in metres");
  }
  EXPECT_THROW(validate(Sphere{kNaN}), UsageError);
  EXPECT_THROW(validate(Ellipsoid{{1, kInfinity, 1}}), UsageError);
  for (const auto& shape : someShapes()) EXPECT_NO_THROW(validate(shape));
}

}  // namespace shape_test
}  // namespace abstand::geometry
