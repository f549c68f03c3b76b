// Free bodies in a physics world: closed forms, contacts of our own engine, and rubbish from outside.
#include <gtest/gtest.h>

#include <thread>

#include "core/base/error.hpp"
#include "core/physics/physics_world.hpp"
#include "core/query/pair_query.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/robots.hpp"

namespace abstand::physics {
namespace free_body_test {

using namespace testing;

constexpr double kStep = 0.001;  // s

Transform at(double x, double y, double z) { return Transform(Eigen::Translation3d(x, y, z)); }

TEST(FreeBody, FallsAndRotatesAboutCentreOfMass) {
  // v = g t exactly, and half a step's velocity more than g t^2 / 2 in position.
  PhysicsWorld world;
  const mechanism::LinkInertia body = boxMass(2.0, {0.2, 0.3, 0.4}, {0.5, 0, 0});
  const Transform X_WF = randomPose(1);
  world.addFreeBody(body, X_WF, {Vector3d(1, 2, 3), Vector3d::Zero()});
  for (int i = 0; i < 1000; ++i) world.step(kStep);
  const Vector3d com_W = world.pose({-1, 0}) * body.com_F;
  EXPECT_TRUE(
      (com_W - X_WF * body.com_F).isApprox(Vector3d(1, 2, 3) + 0.5 * mechanism::kGravity * 1.001, 1e-10));
  EXPECT_TRUE(
      world.velocityAt({-1, 0}, com_W).linear.isApprox(Vector3d(1, 2, 3) + mechanism::kGravity, 1e-10));
  EXPECT_TRUE(world.pose({-1, 0}).linear().isApprox(X_WF.linear(), 1e-12));
  EXPECT_NEAR(world.time(), 1.0, 1e-12);
}

TEST(FreeBody, AcceptsWrenchesAboutAnyPoint) {
  PhysicsWorld world({.gravity_W = Vector3d::Zero()});
  const mechanism::LinkInertia body = boxMass(2.0, {0.2, 0.3, 0.4}, {0, 0, 0});
  world.addFreeBody(body, at(1, 2, 3));
  world.applyWrench({-1, 0}, {Vector3d(4, 0, 0), Vector3d(0, 0, 0.1)}, Vector3d(1, 2.5, 3));
  world.step(kStep);
  const Twist twist = world.velocityAt({-1, 0}, Vector3d(1, 2, 3));
  EXPECT_NEAR(twist.linear.x(), 4.0 / 2.0 * kStep, 1e-12);
  EXPECT_NEAR(twist.angular.z(), (0.1 - 4.0 * 0.5) / body.inertia_F(2, 2) * kStep, 1e-6);
  // And only in that step.
  world.step(kStep);
  EXPECT_NEAR(world.velocityAt({-1, 0}, Vector3d(1, 2, 3)).linear.x(), 4.0 / 2.0 * kStep, 1e-5);
}

TEST(FreeBody, TumblesWithoutGainingEnergy) {
  // About the middle axis, where it flips over and over. ODE's gyroscopic step only takes energy.
  PhysicsWorld world({.gravity_W = Vector3d::Zero()});
  world.addFreeBody(boxMass(1.0, {0.1, 0.2, 0.4}, {0, 0, 0}), Transform::Identity(),
                    {Vector3d::Zero(), Vector3d(0.01, 20.0, 0.01)});
  const double begin = world.energy().total();
  for (int i = 0; i < 10000; ++i) {
    world.step(kStep);
    ASSERT_LT(world.energy().total(), begin * 1.001) << i;
  }
  EXPECT_TRUE(isPose(world.pose({-1, 0})));
}

/// A box and a table with haptic structures.
struct Dropped {
  std::shared_ptr<const structure::HapticStructure> box, table;
  kernels::PairScratch scratch;
  query::PairResult pair;

  Dropped() {
    static const auto small = structure::buildHapticStructure(
        "box", geometry::makeSurface(geometry::Cuboid{{0.12, 0.1, 0.08}}), kCoarse);
    static const auto large = structure::buildHapticStructure(
        "table", geometry::makeSurface(geometry::Cuboid{{0.6, 0.6, 0.1}}), kCoarse);
    box = small;
    table = large;
  }
  Contact contact(const Transform& X_WBox, const Transform& X_WTable, double stiffness) {
    query::queryPair({*box, X_WBox}, {*table, X_WTable}, {.margin = 0.0, .stiffness = stiffness}, scratch,
                     pair);
    return {pair.force_a, pair.torque_a, X_WBox * box->mass_properties.com,
            0.5 * (pair.witness_a + pair.witness_b)};
  }

 private:
  static inline const structure::HapticOptions kCoarse = [] {
    structure::HapticOptions options;
    options.voxel_size = options.point_spacing = 0.01;
    return options;
  }();
};

struct DropCase {
  const char* name;
  double stiffness;  ///< N/m^3
  double height;     ///< m, of the centre above the table's top
  Vector3d rpy;
};
void PrintTo(const DropCase& c, std::ostream* out) { *out << c.name; }

class DroppedBox : public ::testing::TestWithParam<DropCase> {};
INSTANTIATE_TEST_SUITE_P(Onto, DroppedBox,
                         ::testing::Values(DropCase{"flat", 1e6, 0.1, {0, 0, 0}},
                                           DropCase{"tilted", 1e6, 0.2, {0.4, 0.3, 0.2}},
                                           DropCase{"on a corner", 1e6, 0.5, {0.9, 0.6, 0}},
                                           DropCase{"stiff", 2e7, 0.2, {0.1, -0.2, 0}}),
                         [](const auto& drop) {
                           std::string name = drop.param.name;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

TEST_P(DroppedBox, ComesToRestOnTable) {
  Dropped bodies;
  PhysicsWorld world;
  const mechanism::LinkInertia mass = boxMass(1.0, {0.12, 0.1, 0.08}, {0, 0, 0});
  const Transform X_WTable = at(0, 0, -0.05);
  world.addFreeBody(mass, fromXyzRpy({0, 0, GetParam().height}, GetParam().rpy));
  const PhysicsObject box{-1, 0};
  for (int i = 0; i < 2500; ++i) {
    world.applyContact(box, {}, bodies.contact(world.pose(box), X_WTable, GetParam().stiffness), {}, kStep);
    world.step(kStep);
  }
  const Vector3d p_W = world.pose(box).translation();
  const Twist twist = world.velocityAt(box, p_W);
  EXPECT_LT(twist.linear.norm(), 0.002);  // the speed of creep
  EXPECT_LT(twist.angular.norm(), 0.02);
  // Weight = stiffness x area x depth, within the area's sampling.
  bodies.contact(world.pose(box), X_WTable, GetParam().stiffness);
  EXPECT_NEAR(bodies.pair.force_a.z(), 9.80665, 0.2);
}

TEST(DroppedBox, NeverRisesAboveStartWithoutDissipation) {
  // A penalty force alone is elastic: no energy is lost, and none comes from nowhere.
  Dropped bodies;
  PhysicsWorld world;
  world.addFreeBody(boxMass(1.0, {0.12, 0.1, 0.08}, {0, 0, 0}), at(0, 0, 0.1));
  const Transform X_WTable = at(0, 0, -0.05);
  const PhysicsObject box{-1, 0};
  double highest = 0.0;
  bool touched = false;
  for (int i = 0; i < 3000; ++i) {
    const Contact contact = bodies.contact(world.pose(box), X_WTable, 1e6);
    touched = touched || bodies.pair.contacts > 0;
    world.applyWrench(box, {contact.force_a, contact.torque_a}, contact.p_a);
    world.step(kStep);
    if (touched) highest = std::max(highest, world.pose(box).translation().z());
  }
  // m: the box falls at 1 m/s, so where it turns round is known to a step's way.
  EXPECT_LT(highest, 0.1 + 0.002);
  EXPECT_GT(highest, 0.08);
}

TEST(PhysicsWorld, ArmAndBoxExchangeOppositeForces) {
  // Newton's third law through both kinds of bodies: a push between the hand and the box changes the momentum
  // of the box by as much as it takes from the hand.
  PhysicsWorld world({.gravity_W = Vector3d::Zero()});
  world.addMechanism(sevenAxisArm(), Transform::Identity());
  world.mechanism(0).setState(randomValues(7, 1, 0, 1.0), std::vector(7, 0.0));
  const PhysicsObject hand{0, 6}, box{-1, 0};
  const Vector3d p_W = world.pose(hand).translation();
  world.addFreeBody(boxMass(1.0, {0.1, 0.1, 0.1}, {0, 0, 0}), at(p_W.x(), p_W.y(), p_W.z()));
  const Contact contact{Vector3d(5, 3, -2), Vector3d::Zero(), p_W, p_W};
  world.applyContact(hand, box, contact, {}, kStep);
  world.step(kStep);
  EXPECT_TRUE(world.velocityAt(box, p_W).linear.isApprox(-kStep * contact.force_a, 1e-9));
  const Vector3d n = contact.force_a.normalized();
  const double mobility = world.mechanism(0).mobilityOf(6, p_W, {n, Vector3d::Zero()});
  EXPECT_NEAR(n.dot(world.velocityAt(hand, p_W).linear), kStep * contact.force_a.norm() * mobility, 1e-4);
}

TEST(PhysicsWorld, DropsNonFiniteForcesAndHandlesAny) {
  PhysicsWorld world;
  for (const auto solver : {MechanismSolver::kJointed, MechanismSolver::kReduced})
    world.addMechanism(sevenAxisArm(), Transform::Identity(), {.solver = solver});
  world.addFreeBody(boxMass(1.0, {0.1, 0.1, 0.1}, {0, 0, 0}), Transform::Identity());
  const Vector3d zero = Vector3d::Zero(), bad(kNaN, 0, 0), vast(0, 2e9, 0);
  world.applyWrench({-1, 0}, {bad, zero}, zero);
  world.applyWrench({0, 3}, {zero, vast}, zero);
  world.applyWrench({1, 3}, {zero, zero}, Vector3d(kInfinity, 0, 0));
  world.setJointEffort(0, 0, kNaN);
  world.setMotor(1, 0, 1.0, -1.0);
  world.applyContact({0, 3}, {-1, 0}, {bad, zero, zero, zero}, {}, kStep);
  EXPECT_EQ(world.dropped(), 6);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d force = 1e9 * (randomPose(static_cast<std::uint64_t>(i)).linear().col(0));
    for (const PhysicsObject object : {PhysicsObject{0, 6}, {1, 6}, {-1, 0}})
      world.applyWrench(object, {force, force}, Vector3d(1, 2, 3));
    world.applyContact({0, 3}, {1, 3}, {force, force, zero, zero}, {}, kStep);
    world.step(kStep);
  }
  for (int m = 0; m < 2; ++m)
    for (const double q : world.q(m)) EXPECT_TRUE(std::isfinite(q));
  EXPECT_TRUE(isPose(world.pose({-1, 0})));
}

TEST(PhysicsWorld, RejectsInvalidBodies) {
  PhysicsWorld world;
  EXPECT_THROW(world.addFreeBody({}, Transform::Identity()), UsageError);
  EXPECT_THROW(world.addFreeBody(pointMass(1.0, {0, 0, 0}), Transform::Identity()), UsageError);
  Transform bad = Transform::Identity();
  bad.linear() *= 2.0;
  EXPECT_THROW(world.addFreeBody(boxMass(1, {1, 1, 1}, {0, 0, 0}), bad), UsageError);
}

TEST(PhysicsWorld, IsBitIdenticalOnAnyThread) {
  const auto run = [] {
    PhysicsWorld world;
    world.addMechanism(sevenAxisArm(), Transform::Identity());
    world.addFreeBody(boxMass(1.0, {0.1, 0.2, 0.3}, {0, 0, 0}), Transform::Identity(),
                      {Vector3d(1, 0, 0), Vector3d(1, 2, 3)});
    for (int i = 0; i < 500; ++i) world.step(kStep);
    std::vector<double> out(world.q(0).begin(), world.q(0).end());
    const Transform X = world.pose({-1, 0});
    out.insert(out.end(), X.matrix().data(), X.matrix().data() + 16);
    return out;
  };
  const auto expected = run();
  std::vector<double> a, b;
  std::jthread first([&] { a = run(); }), second([&] { b = run(); });
  first.join();
  second.join();
  EXPECT_EQ(a, expected);
  EXPECT_EQ(b, expected);
}

}  // namespace free_body_test
}  // namespace abstand::physics
