// Parts of bodies that are not convex, and what they prove.
#include <gtest/gtest.h>

#include "core/geometry/mass_properties.hpp"
#include "core/geometry/triangle_pair.hpp"
#include "core/kernels/search_kernels.hpp"
#include "core/query/pair_set.hpp"
#include "core/query/parts_apart.hpp"
#include "core/query/separation.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::testing {
namespace parts_apart_test {

/// m; float rounding of coordinates below a metre.
constexpr double kFloat = 1e-6;
/// A hundredth, and what a field of voxels of 10 mm does not tell apart (pair_query.hpp).
constexpr double kFarPart = 0.015;

geometry::TriangleMesh cuboid(const Vector3d& size, const Vector3d& at) {
  geometry::TriangleMesh mesh = geometry::tessellate(geometry::Cuboid{size}, 1e-3);
  for (Vector3d& v : mesh.vertices) v += at;
  return mesh;
}

void add(geometry::TriangleMesh& mesh, const geometry::TriangleMesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const auto& t : more.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// A beam along x and one along y, 0.4 m each, that leave a corner.
geometry::TriangleMesh bracket() {
  geometry::TriangleMesh mesh = cuboid({0.4, 0.04, 0.04}, {0.2, 0.0, 0.0});
  add(mesh, cuboid({0.04, 0.4, 0.04}, {0.0, 0.2, 0.0}));
  return mesh;
}

/// A square bar bent along most of a circle in the plane z = 0, closed at its ends: one piece.
geometry::TriangleMesh bend(double radius, double half, double angle) {
  constexpr std::uint32_t kRings = 13;
  geometry::TriangleMesh mesh;
  for (std::uint32_t i = 0; i < kRings; ++i) {
    const double a = angle * i / (kRings - 1);
    const Vector3d out(std::cos(a), std::sin(a), 0.0), up(0.0, 0.0, half);
    for (const auto& [r, z] : {std::pair(-half, -1.0), {half, -1.0}, {half, 1.0}, {-half, 1.0}})
      mesh.vertices.push_back((radius + r) * out + z * up);
  }
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (std::uint32_t i = 0; i + 1 < kRings; ++i)
    for (std::uint32_t k = 0; k < 4; ++k)
      quad(4 * i + k, 4 * i + (k + 1) % 4, 4 * i + 4 + (k + 1) % 4, 4 * i + 4 + k);
  quad(0, 3, 2, 1);
  quad(4 * kRings - 4, 4 * kRings - 3, 4 * kRings - 2, 4 * kRings - 1);
  // Outwards, whichever way that came out.
  if (geometry::massProperties(mesh).volume < 0.0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// A ring of eight dice.
geometry::TriangleMesh dice() {
  geometry::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const double angle = 0.25 * kPi * i;
    const geometry::TriangleMesh die =
        cuboid({0.06, 0.06, 0.06}, {0.2 * std::cos(angle), 0.2 * std::sin(angle), 0.0});
    add(mesh, die);
  }
  return mesh;
}

std::shared_ptr<const structure::HapticStructure> made(geometry::TriangleMesh mesh) {
  return structure::buildHapticStructure("body", geometry::makeSurface(std::move(mesh)),
                                         {.voxel_size = 0.01, .point_spacing = 0.01, .outer_layers = 4});
}

/// The distance of two meshes, triangle by triangle; 0 where they cross.
double distance(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b, const Transform& X_BA) {
  double least = kInfinity;
  for (std::size_t s = 0; s < a.triangles.size(); ++s) {
    const geometry::TriangleCorners p{X_BA * a.corner(s, 0), X_BA * a.corner(s, 1), X_BA * a.corner(s, 2)};
    for (std::size_t t = 0; t < b.triangles.size(); ++t)
      least = std::min(least,
                       geometry::nearestPoints(p, {b.corner(t, 0), b.corner(t, 1), b.corner(t, 2)}).distance);
  }
  return least;
}

double farthest(const geometry::TriangleMesh& mesh, const Vector3d& g) {
  double reach = -kInfinity;
  for (const Vector3d& p : mesh.vertices) reach = std::max(reach, g.dot(p));
  return reach;
}

TEST(SurfaceParts, ConvexBodyIsOnePart) {
  for (const geometry::Shape& shape :
       {geometry::Shape(geometry::Sphere{0.05}), geometry::Shape(geometry::Cuboid{{0.1, 0.2, 0.3}}),
        geometry::Shape(geometry::Capsule{0.04, 0.2})}) {
    const geometry::TriangleMesh mesh = geometry::tessellate(shape, 1e-4);
    EXPECT_EQ(structure::SurfaceParts(mesh, *geometry::makeSurface(geometry::TriangleMesh(mesh))).size(), 1u)
        << geometry::shapeName(shape);
  }
}

TEST(SurfaceParts, HullsAndSpheresEncloseTriangles) {
  for (const geometry::TriangleMesh& mesh : {bracket(), dice()}) {
    const structure::SurfaceParts parts(mesh, *geometry::makeSurface(geometry::TriangleMesh(mesh)));
    ASSERT_GT(parts.size(), 1u);
    for (std::uint64_t i = 0; i < 500; ++i) {
      const Vector3d g = randomPose(i).linear().col(0);
      double reach = -kInfinity, in_spheres = -kInfinity;
      for (std::size_t k = 0; k < parts.size(); ++k) {
        const kernels::SphereGroup& s = parts.spheres();
        const double to_sphere = g.dot(Vector3d(s.x[k], s.y[k], s.z[k])) + double(s.radius[k]);
        EXPECT_LE(parts.hull(k).support(g), to_sphere + kFloat);
        EXPECT_NEAR(parts.hull(k).support(g), g.dot(parts.hull(k).extreme(g).point), kFloat);
        reach = std::max(reach, parts.hull(k).support(g));
        in_spheres = std::max(in_spheres, to_sphere);
      }
      EXPECT_GE(reach, farthest(mesh, g));
      EXPECT_LE(reach, farthest(mesh, g) + kFloat);
      EXPECT_GE(in_spheres, farthest(mesh, g));
    }
  }
}

TEST(SurfaceParts, NonConvexBodyHasSmallParts) {
  const geometry::EnclosingSphere whole = geometry::minimalSphere(dice().vertices);
  const structure::SurfaceParts parts(dice(), *geometry::makeSurface(dice()));
  for (std::size_t k = 0; k < parts.size(); ++k)
    EXPECT_LT(double(parts.spheres().radius[k]), 0.5 * whole.radius);
}

/// What is proven is true, and between hulls that overlap much is proven.
TEST(FacingParts, NeverOverestimateSeparation) {
  const geometry::TriangleMesh meshes[] = {
      bend(0.2, 0.02, 4.5), bend(0.15, 0.03, 2.0),
      geometry::tessellate(geometry::Ellipsoid{{0.03, 0.04, 0.1}}, 8e-3)};
  std::shared_ptr<const structure::HapticStructure> bodies[3];
  for (std::size_t k = 0; k < 3; ++k) bodies[k] = made(meshes[k]);
  int proven = 0, beyond_hulls = 0;
  for (std::uint64_t i = 0; i < 240; ++i) {
    const std::size_t a = i % 3, b = i / 3 % 2;
    const Transform X_BA = randomPose(i, 0.3);
    const double truth = distance(meshes[a], meshes[b], X_BA);
    const Vector3d n =
        (X_BA * bodies[a]->bounding_sphere.centre - bodies[b]->bounding_sphere.centre).normalized();
    query::PartAxes lines;
    for (const double by : {0.0, 0.5 * truth, 0.9 * truth, 1.01 * truth, truth + 0.01}) {
      for (const bool closely : {true, false}) {
        query::FacingParts::Parts between{};
        const NoAlloc guard;
        const bool apart =
            query::FacingParts(*bodies[a], *bodies[b], X_BA, by, closely, lines).apart(n, between);
        EXPECT_EQ(guard.count(), 0);
        if (apart) {
          ASSERT_GE(truth, by - kFloat) << i;
          ++proven;
          beyond_hulls +=
              by > 0.01 &&
              query::separationAlong(n, {*bodies[a], X_BA}, {*bodies[b], Transform::Identity()}, false) < 0.0;
        } else {
          ASSERT_LT(between.of_points, bodies[a]->parts.size());
          ASSERT_LT(between.of_field, bodies[b]->parts.size());
        }
      }
    }
  }
  EXPECT_GT(proven, 400);
  EXPECT_GT(beyond_hulls, 30);
}

/// Six tips, and eight hollow faces between them, each a part whose hull is far from the middle.
geometry::TriangleMesh star(double tip, double hollow) {
  geometry::TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) mesh.vertices.push_back(side * tip * Vector3d::Unit(axis));
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    const std::uint32_t x = octant & 1, y = octant >> 1 & 1, z = octant >> 2;
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(hollow * (2.0 * Vector3d(x, y, z) - Vector3d::Ones()));
    std::uint32_t tips[3] = {x, 2 + y, 4 + z};
    if ((x + y + z) % 2 == 0) std::swap(tips[0], tips[1]);
    for (int i = 0; i < 3; ++i) mesh.triangles.push_back({tips[i], tips[(i + 1) % 3], middle});
  }
  return mesh;
}

TEST(FacingParts, DoNotSeparateContainedBody) {
  const auto lumpy = made(star(0.2, 0.05)), ball = made(geometry::tessellate(geometry::Sphere{0.02}, 1e-3));
  ASSERT_EQ(lumpy->parts.size(), 8u);
  ASSERT_TRUE(lumpy->pieces.empty() && ball->pieces.empty());
  const Transform inside(Eigen::Translation3d(0.01, 0.0, 0.0)), outside(Eigen::Translation3d(0.0, 0.0, 0.4));
  query::PartAxes lines;
  query::FacingParts::Parts between{};
  constexpr double kBy = 0.01;
  for (const Vector3d& n : {Vector3d(1, 0, 0), Vector3d(0, 0, 1)}) {
    EXPECT_FALSE(query::FacingParts(*ball, *lumpy, inside, kBy, false, lines).apart(n, between));
    EXPECT_FALSE(query::FacingParts(*lumpy, *ball, inside.inverse(), kBy, false, lines).apart(n, between));
  }
  EXPECT_TRUE(query::FacingParts(*ball, *lumpy, outside, kBy, false, lines).apart({0, 0, 1}, between));
  // A pair that remembers being apart sees it too, and so do pairs asked together.
  query::PairMemory memory;
  kernels::PairScratch scratch;
  query::PairResult result;
  query::PairSet set({lumpy.get(), ball.get()}, {{0, 1}});
  for (const Transform& X : {outside, outside, inside}) {
    query::queryPair({*lumpy, Transform::Identity()}, {*ball, X}, {}, {memory, scratch}, result);
    const Transform poses[] = {Transform::Identity(), X};
    EXPECT_EQ(set.contacts(poses, {}).empty(), X.translation() != inside.translation());
    EXPECT_EQ(set.nearest(poses, {}).result.distance < 0.0, X.translation() == inside.translation());
  }
  EXPECT_LT(result.distance, 0.0);
}

TEST(SearchKernels, MeetingReportsNearSpheres) {
  kernels::SphereGroup P{}, F{};
  for (std::size_t k = 0; k < structure::SurfaceParts::kMax; ++k) {
    const Vector3f p = randomPose(k, 0.5).translation().cast<float>(),
                   f = randomPose(k + 50, 0.5).translation().cast<float>();
    P.x[k] = p.x(), P.y[k] = p.y(), P.z[k] = p.z(), P.radius[k] = 0.05f + 0.01f * static_cast<float>(k);
    F.x[k] = f.x(), F.y[k] = f.y(), F.z[k] = f.z(), F.radius[k] = 0.1f;
  }
  P.radius[7] = -std::numeric_limits<float>::infinity();
  constexpr float kBy = 0.2f;
  constexpr std::size_t kCount = 6;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Transform X_FP = randomPose(seed + 1000, 0.3);
    float m[12];
    for (int i = 0; i < 12; ++i) m[i] = static_cast<float>(X_FP.matrix()(i / 4, i % 4));
    for (const kernels::SearchKernels* kernels : {&kernels::searchKernels(), &kernels::kPortableKernels}) {
      const std::uint64_t found = kernels->meeting(m, P, F, kCount, kBy);
      for (std::size_t j = 0; j < structure::SurfaceParts::kMax; ++j) {
        for (std::size_t i = 0; i < structure::SurfaceParts::kMax; ++i) {
          const double gap =
              (X_FP * Vector3d(P.x[i], P.y[i], P.z[i]) - Vector3d(F.x[j], F.y[j], F.z[j])).norm() -
              double(P.radius[i]) - double(F.radius[j]) - double(kBy);
          if (std::abs(gap) <= kFloat && j < kCount) continue;
          EXPECT_EQ((found >> (8 * j + i) & 1) != 0, j < kCount && gap < 0.0) << kernels->name << i << j;
        }
      }
    }
  }
}

/// A bent bar that slides and jumps about another: what is remembered changes nothing beyond what is allowed.
TEST(PairMemory, NonConvexBodiesKeepBounds) {
  const geometry::TriangleMesh mesh_a = bend(0.2, 0.02, 4.5), mesh_b = bend(0.15, 0.03, 2.0);
  const auto a = made(mesh_a), b = made(mesh_b);
  query::PairMemory memory;
  kernels::PairScratch scratch;
  query::PairResult warm, cold;
  for (int frame = 0; frame < 1500; ++frame) {
    const double t = 0.004 * frame;
    Transform X_WB = fromXyzRpy({0.3 * std::cos(t), 0.3 * std::sin(1.3 * t), 0.15 + 0.12 * std::sin(0.7 * t)},
                                {t, 0.5 * t, frame % 7 == 0 ? kPi : 0.0});
    query::queryPair({*a, Transform::Identity()}, {*b, X_WB}, {}, {memory, scratch}, warm);
    query::queryPair({*a, Transform::Identity()}, {*b, X_WB}, {}, scratch, cold);
    ASSERT_LE(warm.distance - warm.bound, cold.distance + kFloat) << frame;
    ASSERT_LE(cold.distance - cold.bound, warm.distance + kFloat) << frame;
    if (frame % 10 == 0 && cold.distance > 0.0) {
      const double truth = distance(mesh_a, mesh_b, X_WB.inverse());
      ASSERT_GE(truth, warm.distance - warm.bound - kFloat) << frame;
      ASSERT_LE(warm.distance, truth > 0.1 ? (1.0 + kFarPart) * truth : truth + 1e-3) << frame;
    }
  }
}

}  // namespace parts_apart_test
}  // namespace abstand::testing
