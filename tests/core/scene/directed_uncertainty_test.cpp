// Pose uncertainty along the direction of the nearest points: closed forms, and displaced bodies by brute
// force.
#include "core/scene/directed_uncertainty.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/math/random.hpp"
#include "tests/core/scene/crowd.hpp"
#include "tests/support/brute_force.hpp"

namespace abstand::scene {
namespace directed_uncertainty_test {

constexpr double kExact = 1e-5;  // m; hull vertices are stored in float

Matrix3d diagonal(double x, double y, double z) { return Vector3d(x, y, z).cwiseAbs2().asDiagonal(); }

/// Cubes of `edge` on grid cells, without the faces between neighbours.
geometry::TriangleMesh cubes(const std::vector<std::array<int, 3>>& cells, double edge) {
  geometry::TriangleMesh mesh;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const Vector3d p = edge * Vector3d(at[0], at[1], at[2]);
    const auto it = std::find(mesh.vertices.begin(), mesh.vertices.end(), p);
    if (it != mesh.vertices.end()) return static_cast<std::uint32_t>(it - mesh.vertices.begin());
    mesh.vertices.push_back(p);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  };
  for (const auto& cell : cells)
    for (std::size_t k = 0; k < 3; ++k)
      for (const int side : {0, 1}) {
        std::array<int, 3> next = cell;
        next[k] += side == 0 ? -1 : 1;
        if (std::find(cells.begin(), cells.end(), next) != cells.end()) continue;
        std::array<std::uint32_t, 4> quad{};
        const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
        for (std::size_t i = 0; i < 4; ++i) {
          std::array<int, 3> corner = cell;
          corner[k] += side;
          corner[u] += i == 1 || i == 2 ? 1 : 0;
          corner[v] += i >= 2 ? 1 : 0;
          quad[i] = vertex(corner);
        }
        if (side == 0) std::swap(quad[1], quad[3]);
        mesh.triangles.push_back({quad[0], quad[1], quad[2]});
        mesh.triangles.push_back({quad[0], quad[2], quad[3]});
      }
  return mesh;
}

/// Two uprights on a base: the hull closes the gap between them.
geometry::TriangleMesh fork() {
  return cubes({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 0, 1}, {1, 0, 1}, {-1, 0, 2}, {1, 0, 2}}, 0.1);
}

TEST(DirectedUncertainty, OfTwoBallsIsTheReachAlongTheirLine) {
  Scene scene = testing::crowd(2);
  scene.setPose(ObjectId(0), testing::at(0.0, 0.0, 0.0), 0.0);
  scene.setPose(ObjectId(1), testing::at(0.0, 1.0, 0.0), 0.0);
  scene.step();
  const PairId pair(0);
  const auto directed = [&] { return directedUncertainty(scene, pair, scene.result(pair)); };
  // Along the line the supports of balls are exact, so the certified distance is that of the balls less the
  // reach; `bound` is a part of it then.
  const double exact = 1.0 - 0.20 - 0.21;
  const auto certified = [&] { return scene.result(pair).distance - scene.result(pair).bound - directed(); };
  scene.setPoseUncertainty(ObjectId(0), 0.3, 0.0);
  EXPECT_EQ(directed(), 0.3) << "only the radius is known";
  scene.setPoseUncertainty(ObjectId(0), 0.3, 0.0, diagonal(0.3, 0.1, 0.2));
  EXPECT_NEAR(certified(), exact - 0.1, kExact);
  scene.setPoseUncertainty(ObjectId(1), 0.4, 0.1, diagonal(0.3, 0.05, 0.2));
  EXPECT_NEAR(certified(), exact - 0.1 - 0.15, kExact) << "the age counts in all directions";
  scene.setPoseUncertainty(ObjectId(1), 0.12, 0.1, diagonal(0.3, 0.05, 0.2));
  EXPECT_NEAR(certified(), exact - 0.1 - 0.12, kExact) << "never above the radius";
  scene.setPoseUncertainty(ObjectId(1), kInfinity);
  EXPECT_EQ(directed(), kInfinity);
  scene.setPoseUncertainty(ObjectId(1), 0.0);
  scene.setPoseUncertainty(ObjectId(0), 0.3, 0.0, Vector3d(kNaN, 0.0, 0.0).asDiagonal());
  EXPECT_EQ(directed(), 0.3);
  scene.setPoseUncertainty(ObjectId(0), 0.3, 0.0, diagonal(0.3, 0.1, 0.2));
  scene.setPaused(pair, true, 1.0);
  EXPECT_EQ(directed(), kInfinity);
}

/// A ball beside, above and between the uprights of a fork, displaced to random points of its ellipsoid: the
/// certified distance is never above the true one.
TEST(DirectedUncertainty, CertifiedDistanceHoldsForDisplacedBodiesOfAnyShape) {
  constexpr int kPlaces = 150, kDisplacements = 60;
  const geometry::TriangleMesh mesh = fork();
  const structure::HapticOptions options{.voxel_size = 0.02, .point_spacing = 0.02};
  Scene scene;
  scene.addObject(
      {"fork", "objects", structure::buildHapticStructure("fork", geometry::makeSurface(mesh), options)});
  scene.addObject(
      {"ball", "objects",
       structure::buildHapticStructure("ball", geometry::makeSurface(geometry::Sphere{0.03}), options)});
  const PairId pair = scene.addPair(ObjectId(0), ObjectId(1));
  int smaller = 0, places = 0;
  for (std::uint64_t i = 0; i < kPlaces; ++i) {
    Random random(1, i);
    const Vector3d p = Vector3d(0.05, 0.05, 0.15) + random.inCube(0.5);
    const Matrix3d R = random.rotation();
    const Vector3d half(random.between(0.001, 0.2), random.between(0.001, 0.2), random.between(0.001, 0.2));
    scene.setPose(ObjectId(1), testing::at(p.x(), p.y(), p.z()), 0.01 * static_cast<double>(i));
    scene.setPoseUncertainty(ObjectId(1), half.maxCoeff(), 0.0,
                             R * half.cwiseAbs2().asDiagonal() * R.transpose());
    scene.step();
    const query::PairResult& result = scene.result(pair);
    if (!(result.distance > 0.0)) continue;
    ++places;
    const double directed = directedUncertainty(scene, pair, result);
    ASSERT_LE(directed, scene.pairUncertainty(pair));
    smaller += directed < 0.9 * scene.pairUncertainty(pair);
    const double certified = result.distance - result.bound - directed;
    for (int k = 0; k < kDisplacements; ++k) {
      const Vector3d displaced = p + R * half.cwiseProduct(random.direction());
      ASSERT_LE(certified, testing::unsignedDistance(mesh, displaced) - 0.03 + kExact) << i;
    }
  }
  EXPECT_GT(smaller, places / 3) << "it is of use";
}

}  // namespace directed_uncertainty_test
}  // namespace abstand::scene
