// Bodies at the upper end: many triangles, many points, fine grids. Distances against exact ones of the
// meshes.
#include <gtest/gtest.h>

#include "core/math/turn_between.hpp"
#include "core/query/pair_query.hpp"
#include "core/store/structure_cache.hpp"
#include "core/verify/brute_force.hpp"
#include "core/verify/meshes.hpp"
#include "tests/support/bumpy_meshes.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::testing {
namespace scale_test {

// Shell points are kept and moved in float, 6e-8 of their coordinates a step, and a witness starts at one. Of
// the bodies' size.
constexpr double kFloatPart = 1e-6;
// m; of the brute force in double, of bodies of a metre.
constexpr double kRounding = 1e-12;

std::shared_ptr<const structure::HapticStructure> structureFrom(const geometry::TriangleMesh& mesh,
                                                                const structure::HapticOptions& options) {
  const std::shared_ptr<const geometry::Surface> surface = geometry::makeSurface(mesh);
  return structure::buildHapticStructure("body", surface, options);
}

/// A body beside its exact triangles.
struct Exact {
  std::shared_ptr<const structure::HapticStructure> structure;
  verify::TriangleSoup soup;
  Exact(const geometry::TriangleMesh& mesh, const structure::HapticOptions& options)
      : structure(structureFrom(mesh, options)), soup(mesh) {}
};

struct Seen {
  int apart{0}, overlapping{0};
};

/// A is moved to each pose, B stays; `distance` of a pose is the true one, 0 where they overlap. Apart: it
/// lies between distance - bound and distance, but for rounding. Overlapping: distance - bound says so.
template <class Distance>
Seen expectCertified(const structure::HapticStructure& a, const structure::HapticStructure& b,
                     const std::vector<Transform>& poses, Distance distance) {
  Seen seen;
  kernels::PairScratch scratch;
  query::PairResult r;
  const double size = a.bounding_sphere.radius + b.bounding_sphere.radius;
  for (const Transform& X_BA : poses) {
    const double exact = distance(X_BA);
    query::queryPair({a, X_BA}, {b, Transform::Identity()}, {}, scratch, r);
    SCOPED_TRACE(::testing::Message() << "pose\n" << X_BA.matrix() << "\nexact " << exact);
    EXPECT_LE(r.distance - r.bound, exact + kRounding);
    if (exact > 0.0) {
      ++seen.apart;
      EXPECT_GE(r.distance, exact - kFloatPart * size);
    } else {
      ++seen.overlapping;
    }
  }
  return seen;
}

/// By brute force over all triangles of both.
Seen expectCertified(const Exact& a, const Exact& b, const std::vector<Transform>& poses) {
  return expectCertified(*a.structure, *b.structure, poses, [&](const Transform& X_BA) {
    const verify::TriangleSoup moved = a.soup.moved(X_BA);
    const double distance = moved.distanceTo(b.soup);
    // No surface cuts the other: then A is inside of B, or apart.
    return distance > 0.0 && b.soup.inside(moved.probes().front()) ? 0.0 : distance;
  });
}

std::vector<Transform> randomPoses(int count, double reach) {
  std::vector<Transform> poses;
  for (int i = 0; i < count; ++i) poses.push_back(randomPose(static_cast<std::uint64_t>(i), reach));
  return poses;
}

TEST(Scale, MeshOf300000Triangles) {
  constexpr structure::HapticOptions kCoarse{.voxel_size = 0.015, .point_spacing = 0.015, .outer_layers = 6};
  const geometry::TriangleMesh mesh = bumpyTorus(0.3, 0.1, 500, 300);
  const Exact ring(mesh, kCoarse);
  ASSERT_EQ(ring.structure->triangles, 300000u);
  EXPECT_TRUE(ring.structure->surface->watertight());

  // The ring as the field.
  const Exact star(verify::starMesh(0.02, 0.06), {.voxel_size = 0.01, .point_spacing = 0.01});
  ASSERT_TRUE(query::pointsFromA(*star.structure, *ring.structure));
  const Seen with_star = expectCertified(star, ring, randomPoses(16, 0.35));
  EXPECT_GE(with_star.apart, 3);
  EXPECT_GE(with_star.overlapping, 2);

  // The ring as the points, over a plate that reaches beyond it: its lowest corner is the nearest.
  const auto plate =
      structure::buildHapticStructure("plate", geometry::makeSurface(geometry::Cuboid{{2.0, 2.0, 0.2}}),
                                      {.voxel_size = 0.05, .point_spacing = 0.05});
  ASSERT_TRUE(query::pointsFromA(*ring.structure, *plate));
  std::vector<Transform> above = randomPoses(40, 0.2);
  for (Transform& X : above) X.translation().z() += 0.5;
  const Seen with_plate = expectCertified(*ring.structure, *plate, above, [&](const Transform& X) {
    double lowest = kInfinity;
    for (const Vector3d& v : mesh.vertices) lowest = std::min(lowest, (X * v).z());
    return std::max(0.0, lowest - 0.1);
  });
  EXPECT_GE(with_plate.apart, 10);
  EXPECT_GE(with_plate.overlapping, 5);
}

/// A regular shell of a cube: 6 n^2 points in the middles of equal squares.
shell::Pointshell regularShell(double edge, int n) {
  shell::Pointshell shell;
  const double step = edge / n;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      for (int i = 0; i < n * n; ++i) {
        Vector3d p, normal = Vector3d::Zero();
        p[axis] = 0.5 * side * edge;
        p[(axis + 1) % 3] = (i % n + 0.5) * step - 0.5 * edge;
        p[(axis + 2) % 3] = (i / n + 0.5) * step - 0.5 * edge;
        normal[axis] = -side;
        for (int k = 0; k < 3; ++k) {
          (k == 0 ? shell.x : k == 1 ? shell.y : shell.z).push_back(static_cast<float>(p[k]));
          (k == 0 ? shell.nx : k == 1 ? shell.ny : shell.nz).push_back(static_cast<float>(normal[k]));
        }
        shell.area.push_back(static_cast<float>(step * step));
      }
    }
  }
  shell.spacing = step;
  // Half the diagonal of a square, and the rounding of the points.
  shell.covering_radius = std::sqrt(0.5) * step + kFloatPart * edge;
  return shell;
}

TEST(Scale, PointshellOfAMillionPoints) {
  // Farthest-point sampling of so many takes longer than a test may (tests/bench, shellOfAMillionPoints), so
  // the shell is laid out by hand, with a covering radius in closed form. Out of a file it comes as any
  // other.
  constexpr double kEdge = 0.5;
  constexpr int kAlong = 409;
  const geometry::TriangleMesh mesh = verify::boxMesh({kEdge, kEdge, kEdge});
  const Exact coarse(mesh, {.voxel_size = 0.02, .point_spacing = 0.02});
  structure::HapticStructure fine = *coarse.structure;
  fine.shell = regularShell(kEdge, kAlong);
  fine.tree = shell::makeTree(fine.shell);
  ASSERT_GE(fine.shell.size(), 1'000'000u);
  const ScratchFolder folder;
  store::StructureCache cache(folder.path());
  cache.store({}, fine);
  Exact cube = coarse;
  cube.structure = cache.findStructure({}, "cube", coarse.structure->surface);
  ASSERT_TRUE(cube.structure);
  ASSERT_EQ(cube.structure->shell.size(), fine.shell.size());

  // A ring round the cube, so that the cube gives the points. It floats about, and through, its tube.
  const Exact ring(verify::torusMesh(0.8, 0.1, 24, 12), {.voxel_size = 0.04, .point_spacing = 0.04});
  ASSERT_TRUE(query::pointsFromA(*cube.structure, *ring.structure));
  const Seen seen = expectCertified(cube, ring, randomPoses(200, 0.8));
  EXPECT_GE(seen.apart, 20);
  EXPECT_GE(seen.overlapping, 20);

  // A corner 20 mm deep in a wall: the force is that of the submerged pyramid, once the points are that
  // dense. Its height d along the diagonal gives the volume d^3 sqrt(3)/2.
  constexpr double kDeep = 0.02, kStiffness = 1e6;
  const auto wall =
      structure::buildHapticStructure("wall", geometry::makeSurface(geometry::Cuboid{{2.0, 2.0, 1.0}}),
                                      {.voxel_size = 0.05, .point_spacing = 0.05});
  Transform X = Transform::Identity();
  X.linear() = turnBetween(Vector3d::Ones(), -Vector3d::UnitZ()).toRotationMatrix();
  X.translation() = Vector3d(0.0, 0.0, 0.5 + std::sqrt(0.75) * kEdge - kDeep);
  kernels::PairScratch scratch;
  query::PairResult r;
  query::queryPair({*cube.structure, X}, {*wall, Transform::Identity()}, {.stiffness = kStiffness}, scratch,
                   r);
  // Of some 1,200 wet squares those on the waterline count as a whole or not at all, and are hardly deep.
  const double volume = std::sqrt(0.75) * kDeep * kDeep * kDeep;
  EXPECT_NEAR(r.force_a.z(), kStiffness * volume, 0.01 * kStiffness * volume);
  EXPECT_NEAR(r.distance, -kDeep, 1e-4);
}

TEST(Scale, GridOf1024CellsTakesLessThan200Megabytes) {
  // A thin ring of 1 m: 1,024 x 1,024 x 30 voxels of 1 mm about it, of which only those near it are kept.
  constexpr structure::HapticOptions kFine{.voxel_size = 0.001, .point_spacing = 0.006, .outer_layers = 7};
  const Exact ring(verify::torusMesh(0.4975, 0.0075, 120, 12), kFine);
  EXPECT_GE(ring.structure->grid.size.x(), 1024);
  EXPECT_GE(ring.structure->grid.size.y(), 1024);
  EXPECT_LT(ring.structure->memoryBytes(), 200'000'000u);
  const Exact star(verify::starMesh(0.02, 0.06), {.voxel_size = 0.005, .point_spacing = 0.005});
  std::vector<Transform> poses = randomPoses(60, 0.5);
  for (Transform& X : poses) X.translation().z() *= 0.1;
  const Seen seen = expectCertified(star, ring, poses);
  EXPECT_GE(seen.apart, 20);
  EXPECT_GE(seen.overlapping, 1);
}

}  // namespace scale_test
}  // namespace abstand::testing
