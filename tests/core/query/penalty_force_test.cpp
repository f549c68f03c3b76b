// The volume law: pressing any body into a flat wall gives k times the overlapping volume.
#include <gtest/gtest.h>

#include "core/mesh_file/mesh_file.hpp"
#include "core/query/pair_query.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/structures.hpp"

namespace abstand::testing {
namespace penalty_force_test {

constexpr double kStiffness = 1e6;   // N/m^3
constexpr double kTolerance = 0.02;  // of the force: what the sampling at 5 mm may cost

/// A wall whose upper face is the plane z = 0.
const structure::HapticStructure& wall() {
  return structureOf(geometry::Cuboid{{0.6, 0.6, 0.1}}, structure::FieldKind::kMixed);
}
const Transform kWallPose = fromXyzRpy({0, 0, -0.05}, {0, 0, 0});

query::PairResult press(const structure::HapticStructure& body, const Transform& X_WB,
                        query::ForceLaw law = query::ForceLaw::kVolume) {
  kernels::PairScratch scratch;
  query::PairResult r;
  query::queryPair({body, X_WB}, {wall(), kWallPose}, {.margin = 0.0, .stiffness = kStiffness, .law = law},
                   scratch, r);
  return r;
}

/// Volume of the part of a closed mesh that lies below z = 0, by the divergence theorem over the clipped
/// triangles: V = - integral over the submerged surface of z n_z dA.
double volumeBelow(const geometry::TriangleMesh& mesh, const Transform& X_WB) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    std::vector<Vector3d> polygon, below;
    for (auto v : t) polygon.push_back(X_WB * mesh.vertices[v]);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector3d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      if (p.z() <= 0) below.push_back(p);
      if ((p.z() < 0) != (q.z() < 0)) below.push_back(p + (q - p) * (p.z() / (p.z() - q.z())));
    }
    for (std::size_t i = 1; i + 1 < below.size(); ++i) {
      const Vector3d n = 0.5 * (below[i] - below[0]).cross(below[i + 1] - below[0]);
      volume += n.z() * (below[0].z() + below[i].z() + below[i + 1].z()) / 3.0;
    }
  }
  return volume;
}

TEST(VolumeLaw, SphereInWallMatchesClosedForm) {
  constexpr double r = 0.05;
  const auto& sphere = structureOf(geometry::Sphere{r}, structure::FieldKind::kMixed);
  for (const double depth : {0.005, 0.01, 0.02}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      SCOPED_TRACE(depth);
      Transform X = randomPose(seed, 0.1);
      X.translation().z() = r - depth;
      const double volume = kPi * depth * depth * (3 * r - depth) / 3;  // spherical cap
      const query::PairResult result = press(sphere, X);
      EXPECT_NEAR(result.force_a.z(), kStiffness * volume, kTolerance * kStiffness * volume);
      EXPECT_LT(result.force_a.head<2>().norm(), kTolerance * kStiffness * volume);
    }
  }
}

TEST(VolumeLaw, BoxInWallMatchesClosedForm) {
  const auto& box = structureOf(geometry::Cuboid{{0.1, 0.12, 0.14}}, structure::FieldKind::kMixed);
  const geometry::TriangleMesh mesh = geometry::tessellate(geometry::Cuboid{{0.1, 0.12, 0.14}}, 1e-3);
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Transform X = seed == 0 ? Transform::Identity() : randomPose(seed, 0.1);
    double lowest = 0.0;
    for (const auto& v : mesh.vertices) lowest = std::min(lowest, (X.linear() * v).z());
    for (const double depth : {0.005, 0.0075, 0.01, 0.02}) {
      SCOPED_TRACE(depth);
      X.translation().z() = -lowest - depth;
      const double expected = kStiffness * volumeBelow(mesh, X);
      EXPECT_NEAR(press(box, X).force_a.z(), expected, kTolerance * expected);
    }
  }
}

TEST(VolumeLaw, BunnyInWallMatchesSubmergedVolume) {
  const auto file = sharedData("meshes/bunny.off");
  if (!exists(file)) GTEST_SKIP() << file;
  mesh_file::LoadedMesh bunny = mesh_file::loadMesh(file, 0.2 / 0.1558);
  const geometry::TriangleMesh mesh = bunny.mesh;
  const auto body =
      structure::buildHapticStructure("bunny", geometry::makeSurface(std::move(bunny.mesh)), {});
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    Transform X = randomPose(seed, 0.05);
    double lowest = kInfinity;
    for (const auto& v : mesh.vertices) lowest = std::min(lowest, (X.linear() * v).z());
    for (const double depth : {0.005, 0.0075, 0.01, 0.02}) {
      SCOPED_TRACE(depth);
      X.translation().z() = -lowest - depth;
      const double expected = kStiffness * volumeBelow(mesh, X);
      EXPECT_NEAR(press(*body, X).force_a.z(), expected, kTolerance * expected);
    }
  }
}

TEST(VolumeLaw, IsIndependentOfSamplingUnlikeThesisLaw) {
  const Transform X = fromXyzRpy({0.01, 0.02, 0.04}, {0.1, 0.2, 0.3});
  const auto& coarse = structureOf(geometry::Sphere{0.05}, structure::FieldKind::kMixed, 0.005);
  const auto& fine = structureOf(geometry::Sphere{0.05}, structure::FieldKind::kMixed, 0.0025);
  const double by_volume = press(fine, X).force_a.z() / press(coarse, X).force_a.z();
  const double by_count = press(fine, X, query::ForceLaw::kThesis).force_a.z() /
                          press(coarse, X, query::ForceLaw::kThesis).force_a.z();
  EXPECT_NEAR(by_volume, 1.0, kTolerance);
  EXPECT_NEAR(by_count, 4.0, 0.4);  // half the pitch, four times the points
}

TEST(VolumeLaw, TorqueMatchesPressureAboutCentre) {
  // A box pressed flat into the edge region of the wall: the submerged part lies off its centre.
  const auto& box = structureOf(geometry::Cuboid{{0.1, 0.1, 0.1}}, structure::FieldKind::kMixed);
  const query::PairResult r = press(box, fromXyzRpy({0.3, 0, 0.04}, {0, 0, 0}));
  // Half of the base, 0.1 x 0.05, is over the wall. A point u from the wall's edge is min(u, 0.01) deep: its
  // nearest face is the wall's side for u < 0.01. So F = k 0.1 (0.01^2 / 2 + 0.01 * 0.04), and u is its
  // lever.
  const double force = kStiffness * 0.1 * (0.5e-4 + 4e-4);
  const double torque = kStiffness * 0.1 * (1e-6 / 3 + 0.01 * (0.05 * 0.05 - 0.01 * 0.01) / 2);
  // The box's side towards the wall's middle is pressed too, s deep at the height -(0.04 + s); the opposite
  // side hangs free.
  const double side = kStiffness * 0.1 * (0.04 * 0.5e-4 + 1e-6 / 3);
  EXPECT_NEAR(r.force_a.z(), force, kTolerance * force);
  EXPECT_NEAR(r.torque_a.y(), torque - side, kTolerance * torque);
}

}  // namespace penalty_force_test
}  // namespace abstand::testing
