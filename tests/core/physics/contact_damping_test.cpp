// What is added to a penalty force: never energy, never adhesion, and friction by Coulomb.
#include "core/physics/contact_damping.hpp"

#include <gtest/gtest.h>

#include "tests/support/robots.hpp"

namespace abstand::physics {
namespace contact_damping_test {

using testing::randomValues;

constexpr double kStep = 0.001;  // s
constexpr double kExact = 1e-12;

Vector3d vector(std::uint64_t seed, std::uint64_t stream, double size) {
  const auto v = randomValues(3, seed, stream, size);
  return {v[0], v[1], v[2]};
}

TEST(ContactDamping, NeverAddsEnergyOrPulls) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const Contact contact{vector(seed, 0, 100.0), vector(seed, 10, 5.0), vector(seed, 20, 1.0),
                          vector(seed, 30, 1.0)};
    const ContactMotion motion{{vector(seed, 40, 2.0), vector(seed, 50, 9.0)},
                               seed % 3 == 0 ? 0.0 : 1.0,
                               seed % 3 == 1 ? 0.0 : 2.0,
                               30.0};
    const Wrench w = contactDamping(contact, motion, {}, kStep);
    EXPECT_LE(w.force.dot(motion.relative.linear) + w.torque.dot(motion.relative.angular), 0.0);
    const Vector3d normal = contact.force_a.normalized();
    const double pressed = normal.dot(contact.force_a + w.force);
    EXPECT_GE(pressed, -kExact * 100);
    EXPECT_LE((w.force - normal * normal.dot(w.force)).norm(), 0.3 * pressed + 1e-9);
  }
}

TEST(ContactDamping, MatchesClosedForm) {
  const Contact contact{Vector3d(0, 0, 50), Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  ContactMotion motion;
  const ContactOptions options{.dissipation = 2.0, .friction = 0.4, .creep = 0.001, .patch = 0.1};
  // Coming nearer at 0.1 m/s: 50 N times 2 s/m times 0.1 m/s more. Leaving at 1 m/s: nothing is left.
  motion.relative.linear = Vector3d(0, 0, -0.1);
  EXPECT_TRUE(contactDamping(contact, motion, options, kStep).force.isApprox(Vector3d(0, 0, 10), kExact));
  motion.relative.linear = Vector3d(0, 0, 1.0);
  EXPECT_TRUE(contactDamping(contact, motion, options, kStep).force.isApprox(Vector3d(0, 0, -50), kExact));
  // Slipping faster than creep: Coulomb. Slower: in proportion.
  motion.relative.linear = Vector3d(0.3, 0, 0);
  EXPECT_TRUE(contactDamping(contact, motion, options, kStep).force.isApprox(Vector3d(-20, 0, 0), kExact));
  motion.relative.linear = Vector3d(0, 0.0005, 0);
  EXPECT_TRUE(contactDamping(contact, motion, options, kStep).force.isApprox(Vector3d(0, -10, 0), kExact));
  // A light body is stopped by half in a step, not thrown back.
  motion.relative.linear = Vector3d(0.3, 0, -0.1);
  motion.normal_mobility = 1e3;
  motion.slip_mobility = 1e5;
  EXPECT_TRUE(
      contactDamping(contact, motion, options, kStep)
          .force.isApprox(Vector3d(-0.5 * 0.3 / (1e5 * kStep), 0, 0.5 * 0.1 / (1e3 * kStep)), kExact));
  // Turning: 50 N x 2 s/m x (0.1 m)^2 at 3 rad/s, and 50 N x 0.1 m at most.
  motion.relative = {Vector3d::Zero(), Vector3d(0, 3, 0)};
  EXPECT_TRUE(contactDamping(contact, motion, options, kStep).torque.isApprox(Vector3d(0, -3, 0), kExact));
  motion.relative.angular = Vector3d(0, 0, 30);
  EXPECT_TRUE(contactDamping(contact, motion, options, kStep).torque.isApprox(Vector3d(0, 0, -5), kExact));
}

TEST(ContactPoint, IsOnForceLineNearBodies) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Vector3d force = vector(seed, 0, 10.0), at = vector(seed, 10, 1.0), center = vector(seed, 20, 1.0);
    const Contact contact{force, (at - center).cross(force), center, vector(seed, 30, 1.0)};
    const Vector3d c = contactPoint(contact);
    EXPECT_LT((c - at).cross(force).norm(), 1e-9);
    EXPECT_NEAR((c - contact.near).dot(force), 0.0, 1e-9);
  }
}

}  // namespace contact_damping_test
}  // namespace abstand::physics
