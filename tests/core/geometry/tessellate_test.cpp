// Tessellations: closed, outward, within the sagitta, compact.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/base/error.hpp"
#include "core/geometry/shape.hpp"
#include "tests/support/brute_force.hpp"

namespace abstand::geometry {
namespace tessellate_test {

using testing::pairUncertainty;
using testing::randomPoint;
using testing::someShapes;

/// Every directed edge once, and its opposite once.
bool closedAndOriented(const TriangleMesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      if (!edges.insert({t[i], t[(i + 1) % 3]}).second) return false;
  for (const auto& [a, b] : edges)
    if (!edges.contains({b, a})) return false;
  return true;
}

double leastAngle(const TriangleMesh& mesh) {
  double least = kPi;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const Vector3d a = mesh.corner(t, (i + 1) % 3) - mesh.corner(t, i);
      const Vector3d b = mesh.corner(t, (i + 2) % 3) - mesh.corner(t, i);
      least = std::min(least, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  }
  return least;
}

/// Vertices are exact but for rounding, relative to the shape's size.
constexpr double kRounding = 1e-14;

TEST(Tessellate, IsClosedWithVerticesOnSurface) {
  for (const auto& shape : someShapes()) {
    for (const double part : {1.0, 0.05, 1e-3}) {
      SCOPED_TRACE(std::string(shapeName(shape)) + " " + std::to_string(part));
      const auto mesh = tessellate(shape, part * pairUncertainty(shape));
      EXPECT_TRUE(closedAndOriented(mesh));
      EXPECT_EQ(weld(mesh, 0.0).vertices.size(), mesh.vertices.size());
      for (const auto& v : mesh.vertices)
        ASSERT_LE(std::abs(distanceTo(shape, v).distance), kRounding * pairUncertainty(shape))
            << v.transpose();
      // Outwards: a step along the normal from the middle of a triangle leaves the convex body.
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vector3d a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
        const Vector3d normal = (b - a).cross(c - a);
        ASSERT_GT(normal.norm(), 0.0);
        ASSERT_GT(normal.dot(a + b + c), 0.0) << t;  // every shape is convex about its centre
      }
    }
  }
}

TEST(Tessellate, SurfaceIsWithinSagitta) {
  for (const auto& shape : someShapes()) {
    for (const double part : {0.02, 0.001}) {
      const double sagitta = part * pairUncertainty(shape);
      const auto mesh = tessellate(shape, sagitta);
      for (std::uint64_t seed = 0; seed < 150; ++seed) {
        const Vector3d on_surface = distanceTo(shape, randomPoint(seed, pairUncertainty(shape))).nearest;
        ASSERT_LE(testing::unsignedDistance(mesh, on_surface), sagitta * (1 + 1e-9))
            << shapeName(shape) << " " << seed;
      }
    }
  }
}

TEST(Tessellate, HasCompactTriangles) {
  // A ball's triangles stay near 60 degrees; a capsule's and a cylinder's have no needles at the pole.
  EXPECT_GT(leastAngle(tessellate(Sphere{0.1}, 1e-4)), 0.85);
  EXPECT_GT(leastAngle(tessellate(Capsule{0.1, 0.3}, 1e-4)), 0.2);
  EXPECT_GT(leastAngle(tessellate(Cylinder{0.1, 0.3}, 1e-5)), 0.2);
  EXPECT_GT(leastAngle(tessellate(Cylinder{0.01, 3.0}, 1e-3)), 0.2);
}

TEST(Tessellate, HasAtLeast32TrianglesAround) {
  for (const Shape& shape :
       std::vector<Shape>{Sphere{0.1}, Ellipsoid{{0.1, 0.2, 0.3}}, Cylinder{0.1, 0.2}, Capsule{0.1, 0.2}}) {
    const auto mesh = tessellate(shape, 1.0);
    // The plane z = 0 cuts that many triangles (those that touch it with an edge count as well).
    for (int axis = 0; axis < 3; ++axis) {
      if (axis < 2 && (std::holds_alternative<Cylinder>(shape))) continue;
      int cut = 0;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        Bounds b;
        for (int i = 0; i < 3; ++i) b.add(mesh.corner(t, i));
        if (b.lower[axis] <= 1e-6 && b.upper[axis] > 1e-6) ++cut;
      }
      EXPECT_GE(cut, 32) << shapeName(shape) << " " << axis;
    }
  }
}

TEST(Tessellate, MassesConvergeToExact) {
  for (const auto& shape : someShapes()) {
    SCOPED_TRACE(shapeName(shape));
    const auto exact = massProperties(shape);
    const double area = surfaceArea(shape);
    double last = kInfinity;
    for (const double part : {0.002, 0.0002}) {
      const double sagitta = part * bounds(shape).extent().minCoeff();
      const auto mesh = tessellate(shape, sagitta);
      const auto m = massProperties(mesh);
      const double error = exact.volume - m.volume;
      EXPECT_GE(error, -1e-12 * exact.volume) << "an inscribed mesh is not larger";
      EXPECT_LE(error, sagitta * area);
      EXPECT_LE(surfaceArea(mesh), area * (1 + 1e-12));
      EXPECT_LE((m.inertia - exact.inertia).norm(),
                6.0 * sagitta * area / exact.volume * exact.inertia.norm());
      EXPECT_LE(m.com.norm(), sagitta);
      EXPECT_TRUE(error < 0.2 * last || error < 1e-12 * exact.volume);
      last = error;
    }
    EXPECT_NEAR(surfaceArea(tessellate(shape, 0.001 * bounds(shape).extent().minCoeff())) / area, 1.0, 0.01);
  }
}

TEST(Tessellate, RejectsTooFineSagitta) {
  for (const double sagitta : {0.0, -1.0, kNaN, kInfinity, 1e-12}) {
    EXPECT_THROW(tessellate(Sphere{1.0}, sagitta), UsageError) << sagitta;
    EXPECT_THROW(tessellate(Cylinder{1.0, 1.0}, sagitta == 1e-12 ? 1e-16 : sagitta), UsageError) << sagitta;
    EXPECT_THROW(tessellate(Capsule{1.0, 1.0}, sagitta), UsageError) << sagitta;
  }
}

}  // namespace tessellate_test
}  // namespace abstand::geometry
