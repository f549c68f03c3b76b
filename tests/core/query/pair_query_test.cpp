// Distances of pairs against closed forms; the certified bound; third law.
#include "core/query/pair_query.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/structures.hpp"

namespace abstand::testing {
namespace pair_query_test {

constexpr double kVoxel = 0.005;
// The contract: one voxel with layers, a quarter of one with the float fields.
double tolerance(structure::FieldKind field) {
  return field == structure::FieldKind::kLayered ? kVoxel : 0.25 * kVoxel;
}

query::PairResult query(const structure::HapticStructure& a, const Transform& X_WA,
                        const structure::HapticStructure& b, const Transform& X_WB,
                        const query::PairOptions& options = {}) {
  kernels::PairScratch scratch;
  query::PairResult result;
  query::queryPair({a, X_WA}, {b, X_WB}, options, scratch, result);
  return result;
}

Transform at(double x, double y, double z, double roll = 0, double pitch = 0, double yaw = 0) {
  return fromXyzRpy({x, y, z}, {roll, pitch, yaw});
}

struct Case {
  const char* name;
  geometry::Shape a;
  Transform X_WA;
  geometry::Shape b;
  Transform X_WB;
  double distance;
};

const double kHalf = std::sqrt(0.5), kDiagonal = std::sqrt(3.0);
const geometry::Shape kSphere = geometry::Sphere{0.05};
const geometry::Shape kSmallSphere = geometry::Sphere{0.03};
const geometry::Shape kBox = geometry::Cuboid{{0.1, 0.12, 0.14}};
const geometry::Shape kCube = geometry::Cuboid{{0.1, 0.1, 0.1}};
const geometry::Shape kWall = geometry::Cuboid{{0.1, 0.5, 0.5}};
const geometry::Shape kEgg = geometry::Ellipsoid{{0.04, 0.05, 0.09}};
const geometry::Shape kCapsule = geometry::Capsule{0.03, 0.15};
// Height of the tilted egg's lowest point below its centre: support function of an ellipsoid.
double eggSupport(double roll) { return std::hypot(0.05 * std::sin(roll), 0.09 * std::cos(roll)); }

const std::vector<Case> kCases{
    {"sphere sphere apart", kSphere, at(0, 0, 0), kSphere, at(0.13, 0, 0), 0.03},
    {"sphere sphere apart, diagonal", kSphere, at(0, 0, 0), kSmallSphere, at(0.1, 0.1, 0.1),
     0.1 * kDiagonal - 0.08},
    {"sphere sphere touching", kSphere, at(0, 0, 0), kSphere, at(0, 0.1, 0), 0.0},
    {"sphere sphere overlapping", kSphere, at(0, 0, 0), kSphere, at(0, 0.05, 0.078),
     std::hypot(0.05, 0.078) - 0.1},
    {"sphere sphere far", kSphere, at(0, 0, 0), kSphere, at(1.5, -0.4, 0.3),
     std::sqrt(2.25 + 0.16 + 0.09) - 0.1},
    {"sphere box face", kSphere, at(0.12, 0.01, 0), kBox, at(0, 0, 0), 0.02},
    {"sphere box face, pressed", kSphere, at(0.093, 0.01, 0), kBox, at(0, 0, 0), -0.007},
    {"sphere box edge", kSphere, at(0.05 + 0.06 * kHalf, 0.06 + 0.06 * kHalf, 0.02), kBox, at(0, 0, 0), 0.01},
    {"sphere box corner", kSphere, at(0.05 + 0.04, 0.06 + 0.04, 0.07 + 0.04), kBox, at(0, 0, 0),
     0.04 * kDiagonal - 0.05},
    {"box box face", kCube, at(0, 0, 0), kBox, at(0.13, 0.02, 0.01), 0.03},
    {"box box face, pressed", kCube, at(0, 0, 0), kWall, at(0.094, 0.02, 0.01), -0.006},
    {"box box edge over face", kCube, at(0.05 + 0.1 * kHalf + 0.02, 0, 0, 0, 0, kPi / 4), kWall, at(0, 0, 0),
     0.02},
    {"box box edge in face", kCube, at(0.05 + 0.1 * kHalf - 0.01, 0, 0, 0, 0, kPi / 4), kWall, at(0, 0, 0),
     -0.01},
    {"box box edges crossing", kCube, at(0, 0, 0, 0, kPi / 4, 0), kCube,
     at(0, 0, 0.2 * kHalf + 0.015, kPi / 4, 0, 0), 0.015},
    {"egg plane, upright", kEgg, at(0, 0, 0.09 + 0.012), kWall, at(0, 0, -0.05, 0, kPi / 2, 0), 0.012},
    {"egg plane, tilted", kEgg, at(0, 0, eggSupport(0.6) + 0.02, 0.6, 0, 0), kWall,
     at(0, 0, -0.05, 0, kPi / 2, 0), 0.02},
    {"egg plane, tilted and pressed", kEgg, at(0, 0, eggSupport(0.6) - 0.008, 0.6, 0, 0), kWall,
     at(0, 0, -0.05, 0, kPi / 2, 0), -0.008},
    {"capsule capsule, side by side", kCapsule, at(0, 0, 0), kCapsule, at(0.1, 0, 0.05), 0.04},
    {"capsule capsule, crossing", kCapsule, at(0, 0, 0), kCapsule, at(0.075, 0, 0, kPi / 2, 0, 0), 0.015},
    {"capsule capsule, crossing and pressed", kCapsule, at(0, 0, 0), kCapsule, at(0.053, 0, 0, kPi / 2, 0, 0),
     -0.007},
    {"capsule capsule, end to end", kCapsule, at(0, 0, 0), kCapsule, at(0, 0.02, 0.25),
     std::hypot(0.02, 0.1) - 0.06},
};

class PairQueryClosedForm : public ::testing::TestWithParam<structure::FieldKind> {};

TEST_P(PairQueryClosedForm, DistanceIsWithinToleranceAndBound) {
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const auto& a = structureOf(c.a, GetParam());
    const auto& b = structureOf(c.b, GetParam());
    for (const bool swapped : {false, true}) {
      const query::PairResult r = swapped ? query(b, c.X_WB, a, c.X_WA) : query(a, c.X_WA, b, c.X_WB);
      EXPECT_NEAR(r.distance, c.distance, tolerance(GetParam()));
      EXPECT_LE(std::abs(r.distance - c.distance), r.bound);
      EXPECT_GE(c.distance, r.distance - r.bound);
      EXPECT_NEAR((r.witness_a - r.witness_b).norm(), std::abs(r.distance), 1e-9);
    }
  }
}

TEST_P(PairQueryClosedForm, WitnessesLieOnSurfaces) {
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const auto& a = structureOf(c.a, GetParam());
    const auto& b = structureOf(c.b, GetParam());
    const query::PairResult r = query(a, c.X_WA, b, c.X_WB);
    constexpr double kOnSurface = 1e-7;  // shell points are kept in float
    EXPECT_NEAR(a.surface->closest(c.X_WA.inverse() * r.witness_a).distance, 0.0, kOnSurface);
    EXPECT_NEAR(b.surface->closest(c.X_WB.inverse() * r.witness_b).distance, 0.0, kOnSurface);
  }
}

TEST_P(PairQueryClosedForm, BoundHoldsForRandomSpherePoses) {
  // A sphere's distance to any body is exact: distance of its centre less its radius.
  const auto& sphere = structureOf(kSmallSphere, GetParam());
  int breaches = 0;
  double worst = 0.0;
  for (const geometry::Shape& shape :
       {kBox, kEgg, kCapsule, kWall, geometry::Shape{geometry::Cylinder{0.05, 0.2}}}) {
    const auto& body = structureOf(shape, GetParam());
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      const double reach = seed % 4 == 0 ? 1.5 : 0.25;
      const Transform X_WS = randomPose(seed, reach), X_WB = randomPose(seed + 1000, 0.05);
      const double truth = geometry::distanceTo(shape, X_WB.inverse() * X_WS.translation()).distance - 0.03;
      if (truth < -0.02) continue;
      const query::PairResult r = query(sphere, X_WS, body, X_WB);
      if (truth >= 0.0) {
        if (truth < r.distance - r.bound) ++breaches;
        worst = std::max(worst, std::abs(r.distance - truth));
      } else {
        // The depth of the sphere's surface in the body: at a corner as little as 1/sqrt(3) of how far the
        // sphere's centre would have to move.
        EXPECT_GE(r.distance, truth - tolerance(GetParam())) << seed;
        EXPECT_LE(r.distance, truth / kDiagonal + tolerance(GetParam())) << seed;
      }
    }
  }
  EXPECT_EQ(breaches, 0);
  EXPECT_LT(worst, tolerance(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Fields, PairQueryClosedForm,
                         ::testing::Values(structure::FieldKind::kLayered, structure::FieldKind::kFloat,
                                           structure::FieldKind::kMixed),
                         [](const auto& test) { return std::string(structure::fieldName(test.param)); });

TEST(PairQuery, ForcesAndTorquesCancel) {
  const auto& a = structureOf(kBox, structure::FieldKind::kMixed);
  const auto& b = structureOf(kEgg, structure::FieldKind::kMixed);
  int touching = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const Transform X_WA = randomPose(seed, 0.08), X_WB = randomPose(seed + 500, 0.08);
    const query::PairResult r = query(a, X_WA, b, X_WB, {.margin = 0.02});
    if (r.contacts == 0) continue;
    ++touching;
    // Sum of the moments about the world's origin; the force on B is the opposite of the force on A.
    const Vector3d p_A = X_WA * a.com, p_B = X_WB * b.com;
    const Vector3d sum = r.torque_a + p_A.cross(r.force_a) + r.torque_b - p_B.cross(r.force_a);
    const double scale = r.torque_a.norm() + r.torque_b.norm() + r.force_a.norm() * (p_A.norm() + p_B.norm());
    EXPECT_LE(sum.norm(), 1e-12 * scale);
  }
  EXPECT_GT(touching, 100);
}

TEST(PairQuery, IsInvariantUnderRigidMotion) {
  const auto& a = structureOf(kBox, structure::FieldKind::kMixed);
  const auto& b = structureOf(kSphere, structure::FieldKind::kMixed);
  const Transform X_WA = at(0, 0, 0, 0.2, 0.1, 0.4), X_WB = at(0.09, 0.02, 0.03);
  const query::PairResult r = query(a, X_WA, b, X_WB, {.margin = 0.01});
  ASSERT_GT(r.contacts, 0);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Transform X = randomPose(seed, 2.0);
    const query::PairResult moved = query(a, X * X_WA, b, X * X_WB, {.margin = 0.01});
    // Float rounding of points metres away from the origin.
    EXPECT_NEAR(moved.distance, r.distance, 1e-6);
    EXPECT_LE((moved.force_a - X.linear() * r.force_a).norm(), 1e-3 * r.force_a.norm());
  }
}

TEST(PairQuery, MarginsAddContactsAndKeepDistance) {
  const auto& a = structureOf(kSphere, structure::FieldKind::kMixed);
  const auto& b = structureOf(kBox, structure::FieldKind::kMixed);
  const Transform X_WA = at(0.05 + 0.05 + 0.03, 0, 0), X_WB = Transform::Identity();
  const query::PairResult apart = query(a, X_WA, b, X_WB, {.margin = 0.02});
  EXPECT_EQ(apart.contacts, 0);
  EXPECT_EQ(apart.force_a.norm(), 0.0);
  const query::PairResult within = query(a, X_WA, b, X_WB, {.margin = 0.05});
  EXPECT_GT(within.contacts, 0);
  EXPECT_NEAR(within.depth, 0.02, 0.25 * kVoxel);
  EXPECT_EQ(within.distance, apart.distance);
  EXPECT_GT(within.force_a.x(), 0.0);  // pushed away from the box
}

TEST(PairQuery, AllocatesNothing) {
  const auto& a = structureOf(kBox, structure::FieldKind::kMixed);
  const auto& b = structureOf(kEgg, structure::FieldKind::kMixed);
  kernels::PairScratch scratch;
  query::PairResult result;
  const NoAlloc guard;
  for (std::uint64_t seed = 0; seed < 50; ++seed)
    query::queryPair({a, randomPose(seed, 0.1)}, {b, randomPose(seed + 100, 0.1)}, {.margin = 0.05}, scratch,
                     result);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace pair_query_test
}  // namespace abstand::testing
