// Surfaces of shapes and meshes: nearest points, sides, winding numbers.
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/geometry/mesh_surface.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/paths.hpp"

namespace abstand::geometry {
namespace surface_test {

using testing::NoAlloc;
using testing::randomPoint;
using testing::randomUnit;

// Of the extent: double rounding through a triangle's own frame.
constexpr double kExact = 1e-9;
// Dipoles of clusters 2.5 radii away, over a closed mesh.
constexpr double kDipoleError = 0.05;

TriangleMesh moved(TriangleMesh mesh, const Vector3d& by, bool flip = false) {
  for (Vector3d& v : mesh.vertices) v += by;
  if (flip) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return mesh;
}

TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (auto t : b.triangles) {
    for (auto& v : t) v += offset;
    a.triangles.push_back(t);
  }
  return a;
}

TriangleMesh box(double edge) { return tessellate(Cuboid{Vector3d::Constant(edge)}, 1e-3); }

// The plane, where p projects into the triangle, and the three edges, in long double: exact for slivers too,
// as near an edge the edge itself gives the same distance.
double slowDistance(const TriangleMesh& mesh, const Vector3d& p) {
  using Vector = Eigen::Matrix<long double, 3, 1>;
  long double least = std::numeric_limits<long double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Vector, 3> v;
    for (int i = 0; i < 3; ++i) v[i] = mesh.corner(t, i).cast<long double>() - p.cast<long double>();
    const Vector n = (v[1] - v[0]).cross(v[2] - v[0]).normalized();
    bool within = true;
    for (int i = 0; i < 3; ++i) {
      const Vector e = v[(i + 1) % 3] - v[i];
      within = within && e.cross(-v[i]).dot(n) >= 0;
      const long double s = std::clamp<long double>(-v[i].dot(e) / e.squaredNorm(), 0, 1);
      least = std::min(least, (v[i] + s * e).norm());
    }
    if (within) least = std::min(least, std::abs(n.dot(v[0])));
  }
  return static_cast<double>(least);
}

// Points in a box 1.6 times as large as the body, and points very near to its surface.
std::vector<Vector3d> probes(const Surface& surface, int count) {
  const Bounds b = surface.bounds();
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const Vector3d p = b.centre() + 0.8 * randomPoint(i, 1.0).cwiseProduct(b.extent());
    points.push_back(p);
    points.push_back(surface.closest(p).point + 1e-3 * b.extent().norm() * randomPoint(i + 100'000, 1.0));
  }
  return points;
}

void expectClosestPointsExact(const MeshSurface& surface, int count) {
  const TriangleMesh mesh = surface.mesh(0.0);
  const double tolerance = kExact * surface.bounds().extent().norm();
  std::uint32_t hint = kNoHint;
  for (const Vector3d& p : probes(surface, count)) {
    const SurfacePoint nearest = surface.closest(p);
    ASSERT_NEAR(nearest.distance, slowDistance(mesh, p), tolerance);
    ASSERT_NEAR((p - nearest.point).norm(), nearest.distance, tolerance);
    ASSERT_LE(slowDistance(mesh, nearest.point), tolerance);
    // Any hint, even of a far point, gives the same answer.
    const SurfacePoint hinted = surface.closest(p, hint);
    ASSERT_EQ(hinted.distance, nearest.distance);
    ASSERT_EQ(hinted.hint, nearest.hint);
    hint = nearest.hint;
  }
}

class MeshFiles : public ::testing::TestWithParam<const char*> {};

TEST_P(MeshFiles, ClosestPointsMatchBruteForce) {
  const auto file = testing::sharedData(std::string("meshes/") + GetParam());
  if (!exists(file)) GTEST_SKIP() << file;
  expectClosestPointsExact(MeshSurface(mesh_file::loadMesh(file).mesh), 150);
}

TEST_P(MeshFiles, SidesMatchExactWindingNumbers) {
  const auto file = testing::sharedData(std::string("meshes/") + GetParam());
  if (!exists(file)) GTEST_SKIP() << file;
  const MeshSurface surface(mesh_file::loadMesh(file).mesh);
  const double near = 1e-6 * surface.bounds().extent().norm();
  int checked = 0;
  for (const Vector3d& p : probes(surface, 150)) {
    const double exact = surface.windingNumber().exactAt(p);
    ASSERT_NEAR(surface.windingNumber().at(p), exact, kDipoleError);
    const Bounds b = surface.bounds();
    const bool in_bounds = (p.array() >= b.lower.array()).all() && (p.array() <= b.upper.array()).all();
    if (!in_bounds) {
      ASSERT_FALSE(surface.inside(p));
      continue;
    }
    // On the surface, and where a hole leaves it open, either side is right.
    if (surface.closest(p).distance < near || std::abs(std::abs(exact) - 0.5) < kDipoleError) continue;
    ASSERT_EQ(surface.inside(p), std::abs(exact) > 0.5) << p.transpose();
    ASSERT_EQ(surface.inside(p, surface.closest(p)), surface.inside(p));
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

INSTANTIATE_TEST_SUITE_P(Real, MeshFiles,
                         ::testing::Values("bunny.off", "not_convex.obj", "halftunnel.off", "featuretype.STL",
                                           "multibody.stl", "cube.obj"));

TEST(MeshSurface, SliversAndFarCoordinatesStayExact) {
  TriangleMesh mesh;
  for (int i = 0; i < 60; ++i) {
    const Vector3d a = randomPoint(i, 1.0), along = randomPoint(i + 1000, 1.0);
    const double width = std::pow(10.0, -1.0 - 6.0 * randomUnit(i, 7));
    mesh.vertices.insert(mesh.vertices.end(),
                         {a, a + along, a + randomUnit(i, 8) * along + width * randomPoint(i + 2000, 1.0)});
    mesh.triangles.push_back({3u * i, 3u * i + 1, 3u * i + 2});
  }
  expectClosestPointsExact(MeshSurface(mesh), 300);
  // Rounding of the coordinates themselves: 1e-16 of 1000 m is well below kExact of the extent.
  expectClosestPointsExact(MeshSurface(moved(mesh, {1000.0, -2000.0, 500.0})), 50);
}

TEST(MeshSurface, DescentOnConvexMeshFindsNearestPoint) {
  const MeshSurface egg(tessellate(Ellipsoid{{0.04, 0.05, 0.12}}, 1e-4));
  const MeshSurface cube(box(0.1));
  int walks = 0;
  for (const MeshSurface* surface : {&egg, &cube}) {
    for (std::uint32_t i = 0; i < 500; ++i) {
      // From outside: inside, several ways out may be downhill.
      const Vector3d p = testing::randomPose(i).linear().col(0) * (0.2 + 0.3 * (i % 7));
      const std::uint32_t hint = i * 31 % static_cast<std::uint32_t>(surface->tree().size());
      // On the side that is turned away, the foot on a face has no way down.
      if (surface->tree().normal(hint).dot(p - surface->tree().closestOn(hint, p).point) < 0.0) continue;
      const SurfacePoint exact = surface->closest(p), walked = surface->nearby(p, hint);
      ASSERT_NEAR(walked.distance, exact.distance, kExact) << i;
      ASSERT_NEAR((p - walked.point).norm(), walked.distance, kExact);
      ASSERT_NEAR(surface->closest(walked.point, walked.hint).distance, 0.0, kExact);
      ++walks;
    }
  }
  EXPECT_GT(walks, 300);
}

TEST(MeshSurface, DescentNeverIncreasesDistance) {
  TriangleMesh open = box(0.1);
  open.triangles.pop_back();
  const MeshSurface pierced(open), twins(together(box(0.1), moved(box(0.1), {0.3, 0.0, 0.0})));
  for (std::uint32_t i = 0; i < 300; ++i) {
    const Vector3d p = randomPoint(i, 0.4);
    EXPECT_EQ(pierced.nearby(p, i % 11).distance, pierced.closest(p).distance);
    EXPECT_EQ(twins.nearby(p, kNoHint).distance, twins.closest(p).distance);
    const std::uint32_t hint = i % static_cast<std::uint32_t>(twins.tree().size());
    const double walked = twins.nearby(p, hint).distance;
    EXPECT_LE(walked, twins.tree().closestOn(hint, p).distance);
    EXPECT_GE(walked, twins.closest(p).distance - kExact);
  }
}

TEST(MeshSurface, TiesAreIndependentOfHint) {
  const MeshSurface surface(box(2.0));
  for (std::uint32_t hint = 0; hint < 12; ++hint) {
    const SurfacePoint nearest = surface.closest(Vector3d::Zero(), hint);
    EXPECT_EQ(nearest.distance, 1.0);
    EXPECT_EQ(nearest.hint, surface.closest(Vector3d::Zero()).hint);
  }
}

TEST(MeshSurface, ReportsWhereNormalsDecideSide) {
  const TriangleMesh sphere = tessellate(Sphere{1.0}, 0.01), small = tessellate(Sphere{0.3}, 0.01);
  struct Case {
    const char* what;
    TriangleMesh mesh;
    bool watertight, embedded;
    double at_origin;  // winding number
  };
  TriangleMesh open = sphere;
  open.triangles.pop_back();
  const std::vector<Case> cases{
      {"a sphere", sphere, true, true, 1.0},
      {"a sphere without a triangle", open, false, false, 1.0},
      {"two spheres apart", together(sphere, moved(small, {2, 0, 0})), true, true, 1.0},
      {"two spheres that overlap", together(sphere, moved(small, {0.9, 0, 0})), true, false, 1.0},
      {"a sphere inside a sphere", together(sphere, small), true, false, 2.0},
      {"a hollow sphere", together(sphere, moved(small, Vector3d::Zero(), true)), true, true, 0.0},
      {"the same box twice", together(box(1.0), box(1.0)), true, false, 2.0},
      {"two boxes that touch", together(box(1.0), moved(box(1.0), {1.0, 0, 0})), true, false, 1.0},
      {"inside out", moved(sphere, Vector3d::Zero(), true), false, false, -1.0},
  };
  for (const Case& c : cases) {
    const MeshSurface surface(c.mesh);
    EXPECT_EQ(surface.watertight(), c.watertight) << c.what;
    EXPECT_EQ(surface.embedded(), c.embedded) << c.what;
    EXPECT_NEAR(surface.windingNumber().at(Vector3d::Zero()), c.at_origin, kDipoleError) << c.what;
    EXPECT_EQ(surface.inside(Vector3d::Zero()), c.at_origin != 0.0) << c.what;
  }
}

TEST(MeshSurface, PointsBetweenOverlappingBodiesAreInside) {
  // Near the left sphere's surface, inside the right one: its normal says outside, the winding number does
  // not.
  const TriangleMesh sphere = tessellate(Sphere{1.0}, 0.001);
  const MeshSurface surface(together(sphere, moved(sphere, {1.0, 0, 0})));
  EXPECT_TRUE(surface.inside({1.05, 0.0, 0.0}));
  EXPECT_LT(surface.signedDistance({1.05, 0.0, 0.0}), 0.0);
  EXPECT_FALSE(surface.inside({0.5, 0.95, 0.0}));
}

TEST(MeshSurface, MeshOfShapeMatchesShape) {
  constexpr double kSagitta = 2e-4;
  for (const Shape& shape : testing::someShapes()) {
    const auto exact = makeSurface(shape);
    const auto mesh = makeSurface(tessellate(shape, kSagitta));
    EXPECT_TRUE(mesh->watertight());
    for (const Vector3d& p : probes(*exact, 100)) {
      ASSERT_NEAR(mesh->signedDistance(p), exact->signedDistance(p), kSagitta + 1e-9) << shapeName(shape);
      ASSERT_NEAR(exact->signedDistance(p), distanceTo(shape, p).distance, 0.0);
    }
  }
}

TEST(MeshSurface, RejectsInvalidSurfaces) {
  EXPECT_THROW(makeSurface(TriangleMesh{}), UsageError);
  TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  EXPECT_THROW(makeSurface(flat), UsageError);
  TriangleMesh not_finite{{{0, 0, 0}, {1, 0, 0}, {0, kNaN, 0}}, {{0, 1, 2}}};
  EXPECT_THROW(makeSurface(not_finite), UsageError);
  TriangleMesh beyond{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}};
  EXPECT_THROW(makeSurface(beyond), UsageError);
  EXPECT_THROW(makeSurface(Shape(Sphere{-1.0})), UsageError);
}

TEST(MeshSurface, QueriesHandleAnyInputWithoutAllocation) {
  const MeshSurface surface(tessellate(Sphere{1.0}, 0.001));
  const NoAlloc guard;
  for (const double v : {kNaN, kInfinity, -kInfinity, 1e300, 1e30, -1e18, 0.0}) {
    for (const std::uint32_t hint : {kNoHint, 0u, 123456789u}) {
      const SurfacePoint nearest = surface.closest({v, 0.5, v}, hint);
      surface.nearby({v, 0.5, v}, hint);
      surface.inside({v, 0.5, v});
      surface.inside({v, 0.5, v}, nearest);
    }
  }
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace surface_test
}  // namespace abstand::geometry
