// A held object on surfaces: planes in closed form, bodies by queries.
#include "core/control/god_object.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/error.hpp"
#include "core/math/random.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::control {
namespace god_object_test {

const geometry::EnclosingSphere kBall{Vector3d::Zero(), 0.05};
constexpr double kExact = 1e-9;
// m; the two nearest points are walked to within this of the smallest distance, near contact.
constexpr double kWitness = 1e-4;

Transform at(const Vector3d& p) { return Transform(Eigen::Translation3d(p)); }

/// A ball of 5 cm over planes n . p = 0.
std::vector<ContactConstraint> planes(const std::vector<Vector3d>& normals, const Transform& X_WO) {
  std::vector<ContactConstraint> all;
  for (const Vector3d& n : normals)
    all.push_back({X_WO.translation() - 0.05 * n, n, n.dot(X_WO.translation()) - 0.05});
  return all;
}

void settle(GodObject& object, const Transform& X_WH, const std::vector<Vector3d>& normals) {
  for (int i = 0; i < 500; ++i) {
    object.update(X_WH, planes(normals, object.pose()));
    if (object.still()) return;
  }
}

TEST(GodObject, FollowsHandInFreeSpace) {
  GodObject object({.gap = 0.0}, kBall);
  object.reset(Transform::Identity());
  Transform hand = fromXyzRpy({0.3, -0.2, 0.1}, {0.4, -0.3, 1.0});
  settle(object, hand, {});
  EXPECT_TRUE(object.pose().isApprox(hand, 1e-6));
  EXPECT_NEAR(object.wrench().force.norm(), 0.0, 1e-3);
}

TEST(GodObject, StaysOnPlaneAndPushesBack) {
  GodObject object({.stiffness = 1000.0, .force = 50.0, .gap = 0.0}, kBall);
  object.reset(at({0, 0, 0.1}));
  // The hand 3 cm into the plane z = 0, and 20 cm aside: there is no friction.
  settle(object, at({0.2, 0.0, 0.02}), {Vector3d::UnitZ()});
  EXPECT_NEAR(object.pose().translation().z(), 0.05, kExact);
  EXPECT_NEAR(object.pose().translation().x(), 0.2, 1e-5);
  EXPECT_NEAR(object.wrench().force.z(), 30.0, 1e-2);
  EXPECT_NEAR(object.wrench().force.head<2>().norm(), 0.0, 1e-2);
  // The force is cut, the object stays.
  settle(object, at({0.2, 0.0, -5.0}), {Vector3d::UnitZ()});
  EXPECT_NEAR(object.pose().translation().z(), 0.05, kExact);
  EXPECT_NEAR(object.wrench().force.norm(), 50.0, kExact);
}

TEST(GodObject, IsLiftedOutOfPenetration) {
  GodObject object({.gap = 0.0, .step = 0.01}, kBall);
  object.reset(at({0, 0, 0.02}));
  object.update(at({0, 0, 0.02}), planes({Vector3d::UnitZ()}, object.pose()));
  EXPECT_NEAR(object.pose().translation().z(), 0.03, kExact) << "by a step at most";
  settle(object, at({0, 0, 0.02}), {Vector3d::UnitZ()});
  EXPECT_NEAR(object.pose().translation().z(), 0.05, kExact);
}

TEST(GodObject, IsNearestAllowedPose) {
  // Projection on the cone of random planes through the origin: optimality by its conditions. The way from
  // the object to the hand is a sum of inward normals of the planes that it touches.
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(12, seed);
    std::vector<Vector3d> normals;
    for (int i = 0; i < 4; ++i) normals.push_back((random.direction() + Vector3d(0, 0, 1.5)).normalized());
    GodObject object({.gap = 0.0, .step = 0.05}, kBall);
    object.reset(at({0, 0, 0.5}));
    const Vector3d hand = random.inCube(0.3);
    settle(object, at(hand), normals);
    const Vector3d p = object.pose().translation();
    // Balls touch planes without levers, so the orientation stays.
    ASSERT_NEAR((object.pose().linear() - Matrix3d::Identity()).norm(), 0.0, kExact);
    for (const Vector3d& n : normals) ASSERT_GE(n.dot(p), 0.05 - 1e-6);
    // No admissible point is nearer: tried at random about it.
    for (int k = 0; k < 200; ++k) {
      Vector3d other = p + random.inCube(0.02);
      bool allowed = true;
      for (const Vector3d& n : normals) allowed = allowed && n.dot(other) >= 0.05;
      if (allowed) {
        ASSERT_GE((other - hand).norm(), (p - hand).norm() - 2e-5);
      }
    }
  }
}

TEST(GodObject, TurnsAboutOffCentreContact) {
  // A rod along x held level, pressed down at one end only: it yields by turning as well as by rising.
  const geometry::EnclosingSphere rod{Vector3d::Zero(), 0.2};
  GodObject object({.gap = 0.0}, rod);
  object.reset(Transform::Identity());
  for (int i = 0; i < 300; ++i) {
    const Vector3d tip = object.pose() * Vector3d(0.2, 0, 0);
    const ContactConstraint ground{tip, Vector3d::UnitZ(), tip.z() + 0.0};
    object.update(at({0, 0, -0.02}), {&ground, 1});
  }
  const Vector3d tip = object.pose() * Vector3d(0.2, 0, 0);
  EXPECT_NEAR(tip.z(), 0.0, 1e-4);
  EXPECT_LT(object.pose().translation().z(), -1e-3) << "the centre sinks";
  EXPECT_GT(object.pose().translation().z(), -0.02);
  EXPECT_LT(object.wrench().torque.y(), 0.0) << "the hand is turned the same way, tip up";
}

TEST(GodObject, SlidesOverBoxWithoutPenetration) {
  const structure::HapticOptions options{.voxel_size = 0.01, .point_spacing = 0.01};
  const auto ball =
      structure::buildHapticStructure("ball", geometry::makeSurface(geometry::Sphere{0.05}), options, 2);
  const auto box = structure::buildHapticStructure(
      "box", geometry::makeSurface(geometry::Cuboid{{0.4, 0.4, 0.2}}), options, 2);
  GodObject object({.gap = 5e-4, .step = 0.005}, ball->bounding_sphere);
  object.reset(at({-0.3, 0.02, 0.17}));
  // With a memory the nearest points of the last cycle are walked on: near contact that gives the sharper
  // normal.
  query::PairMemory memory;
  kernels::PairScratch scratch;
  query::PairResult result;
  double deepest = 0.0, most = 0.0;
  int pressed = 0;
  for (int i = 0; i <= 1000; ++i) {
    // The hand goes straight through the upper part of the box, 3 cm below where the ball can be, and on.
    const Transform hand = at({-0.3 + 0.6e-3 * i, 0.02, 0.12});
    for (int k = 0; k < 4; ++k) {
      query::queryPair({*ball, object.pose()}, {*box, Transform::Identity()}, {}, {memory, scratch}, result);
      const auto constraint = constraintOf(result, true);
      object.update(hand, constraint ? std::span(&*constraint, 1) : std::span<const ContactConstraint>());
    }
    query::queryPair({*ball, object.pose()}, {*box, Transform::Identity()}, {}, scratch, result);
    deepest = std::max(deepest, -result.distance);
    if (std::abs(hand.translation().x()) < 0.15) {
      ++pressed;
      // On the face: the object is 3 cm and the gap above the hand, and the force is that of the spring.
      EXPECT_NEAR(object.pose().translation().z(), 0.1505, kWitness);
      EXPECT_NEAR(object.wrench().force.z(), 30.5, 1000.0 * kWitness);
      most = std::max(most, std::abs(object.wrench().force.x()));
    }
  }
  EXPECT_GT(pressed, 400);
  // Over the edge the normal turns within a step of 5 mm, but the surfaces curve away.
  EXPECT_LE(deepest, 0.0);
  EXPECT_LT(most, 1.0) << "no friction; the hand is 0.6 mm ahead at most";
  EXPECT_NEAR(object.pose().translation().z(), 0.12, 1e-3) << "beyond the box the hand has it back";
}

TEST(GodObject, ConstraintsComeFromEitherBody) {
  query::PairResult r;
  EXPECT_FALSE(constraintOf(r, true)) << "never filled";
  r.distance = 0.02;
  r.bound = 0.001;
  r.witness_a = {0, 0, 0.02};
  r.witness_b = {0, 0, 0};
  const auto a = constraintOf(r, true), b = constraintOf(r, false, true);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->normal_W, Vector3d(0, 0, 1));
  EXPECT_EQ(b->normal_W, Vector3d(0, 0, -1));
  EXPECT_EQ(a->p_W, r.witness_a);
  EXPECT_EQ(b->p_W, r.witness_b);
  EXPECT_EQ(a->gap, 0.02);
  EXPECT_NEAR(b->gap, 0.019, 1e-15);
}

TEST(GodObject, KeepsNearestConstraintsWithoutAllocation) {
  GodObject object({.gap = 0.0, .step = 0.02}, kBall);
  object.reset(at({0, 0, 0.051}));
  std::vector<ContactConstraint> many(GodObject::kMaxConstraints,
                                      {Vector3d(0, 0, -1), Vector3d(1, 0, 0), 0.03});
  many.push_back({Vector3d(0, 0, 0.001), Vector3d::UnitZ(), 0.001});
  const testing::NoAlloc guard;
  object.update(at({0, 0, 0.0}), many);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_NEAR(object.pose().translation().z(), 0.05, kExact);
}

TEST(GodObject, IgnoresInvalidPosesAndContacts) {
  GodObject object({}, kBall);
  object.reset(at({0, 0, 0.2}));
  Transform broken = Transform::Identity();
  broken.translation().x() = kNaN;
  object.update(broken, {});
  EXPECT_EQ(object.pose().translation(), Vector3d(0, 0, 0.2));
  EXPECT_EQ(object.wrench().force, Vector3d::Zero());
  const ContactConstraint bad[] = {{Vector3d::Zero(), Vector3d::Zero(), 0.0},
                                   {Vector3d::Zero(), Vector3d::UnitZ(), kNaN},
                                   {Vector3d::Constant(kNaN), Vector3d::UnitZ(), 0.0}};
  object.update(at({0, 0, 0.195}), bad);
  EXPECT_NEAR(object.pose().translation().z(), 0.195, kExact);
}

TEST(GodObject, RejectsBadOptions) {
  EXPECT_THROW(GodObject({.stiffness = -1.0}, kBall), UsageError);
  EXPECT_THROW(GodObject({.step = 0.0}, kBall), UsageError);
}

}  // namespace god_object_test
}  // namespace abstand::control
