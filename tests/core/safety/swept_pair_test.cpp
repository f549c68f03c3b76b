// Two moving bodies: nothing is missed between samples.
#include "core/safety/swept_pair.hpp"

#include <gtest/gtest.h>

#include <map>

#include "core/math/random.hpp"
#include "core/robot_file/mech_file.hpp"
#include "core/safety/link_motion.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::safety {
namespace swept_pair_test {

using testing::projectFile;
using testing::randomPose;

// The nearest points lie on the exact surfaces of shapes within this.
constexpr double kOnSurface = 1e-6;
constexpr double kRounding = 1e-9;
// What a search proves where no slab parts the bodies: the field's error at voxels of 1 cm, and how far
// points of 1 cm are from what lies between them.
constexpr double kSearch = 0.02;

const structure::HapticStructure& structure(const char* name, const geometry::Shape& shape) {
  static std::map<std::string, std::shared_ptr<const structure::HapticStructure>> built;
  auto& s = built[name];
  if (!s)
    s = structure::buildHapticStructure(name, geometry::makeSurface(shape),
                                        {.voxel_size = 0.01, .point_spacing = 0.01}, 2);
  return *s;
}
const structure::HapticStructure& ball() { return structure("ball", geometry::Sphere{0.05}); }
const structure::HapticStructure& rod() { return structure("rod", geometry::Capsule{0.03, 0.3}); }
const structure::HapticStructure& plate() { return structure("plate", geometry::Cuboid{{0.4, 0.4, 0.02}}); }

Transform at(const Vector3d& p) { return Transform(Eigen::Translation3d(p)); }

double distanceAt(const structure::HapticStructure& a, BodyMotion& x, const structure::HapticStructure& b,
                  BodyMotion& y, double t, query::PairMemory& memory) {
  static kernels::PairScratch scratch;
  query::PairResult result;
  query::queryPair({a, x.pose(t)}, {b, y.pose(t)}, {}, {memory, scratch}, result);
  return result.distance;
}

TEST(SweptPair, TwoBallsMatchClosedForm) {
  int apart = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(21, seed);
    const Vector3d a0 = random.inCube(0.5), a1 = random.inCube(0.5), b0 = random.inCube(0.5),
                   b1 = random.inCube(0.5);
    const double duration = random.between(0.001, 1.0);
    PoseSegment x(ball().bounding_sphere, at(a0), at(a1), duration);
    PoseSegment y(ball().bounding_sphere, at(b0), at(b1), duration);
    SweptScratch scratch;
    const SweptResult r = sweptPair({ball(), x}, {ball(), y}, duration, {.max_samples = 200}, scratch);
    // Nearest point to the origin of the line of the differences.
    const Vector3d from = a0 - b0, way = (a1 - b1) - from;
    const double s = std::clamp(-from.dot(way) / way.squaredNorm(), 0.0, 1.0);
    const double least = (from + s * way).norm() - 0.1;
    ASSERT_LE(r.lower, std::max(least, 0.0) + kOnSurface);
    if (least > 0.005) {
      ++apart;
      ASSERT_TRUE(r.done);
      ASSERT_NEAR(r.upper, least, 1e-3 + 0.01 * least);
      ASSERT_GE(r.lower, 0.99 * least - 1e-3 - kSearch);
    }
  }
  EXPECT_GT(apart, 50);
}

TEST(SweptPair, DetectsJumpThroughPlate) {
  // 1 m within a millisecond, through a plate of 2 cm: far apart before and after.
  PoseSegment flying(ball().bounding_sphere, at({0.01, 0.02, 0.5}), at({0.0, 0.0, -0.5}), 1e-3);
  PoseSegment still(plate().bounding_sphere, Transform::Identity(), Transform::Identity(), 1e-3);
  SweptScratch scratch;
  const SweptResult r = sweptPair({ball(), flying}, {plate(), still}, 1e-3, {.hit = 0.0}, scratch);
  EXPECT_LT(r.upper, 0.0);
  EXPECT_LT(r.lower, 0.0);
  EXPECT_TRUE(r.done);
  EXPECT_LT(r.samples, 20);
  // Beside the plate, it is shown to pass.
  PoseSegment beside(ball().bounding_sphere, at({0.3, 0.0, 0.5}), at({0.3, 0.0, -0.5}), 1e-3);
  const SweptResult past = sweptPair({ball(), beside}, {plate(), still}, 1e-3, {}, scratch);
  EXPECT_TRUE(past.done);
  EXPECT_NEAR(past.upper, 0.05, 1e-3);
  EXPECT_GT(past.lower, 0.048);
}

TEST(SweptPair, IsNeverAboveFineSampling) {
  long samples = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const double duration = 0.5;
    PoseSegment x(rod().bounding_sphere, randomPose(seed, 0.4), randomPose(seed + 1000, 0.4), duration);
    PoseSegment y(plate().bounding_sphere, randomPose(seed + 2000, 0.2), randomPose(seed + 3000, 0.2),
                  duration);
    SweptScratch scratch;
    const SweptResult r = sweptPair({rod(), x}, {plate(), y}, duration,
                                    {.tolerance = 2e-3, .hit = 0.0, .max_samples = 400}, scratch);
    samples += r.samples;
    query::PairMemory memory;
    double least = kInfinity;
    for (int i = 0; i <= 500; ++i)
      least = std::min(least, distanceAt(rod(), x, plate(), y, duration * i / 500, memory));
    ASSERT_LE(r.lower, least + kOnSurface);
    ASSERT_TRUE(r.done);
    if (least > 0.0) {
      // Of remembered queries one may be off by a hundredth.
      ASSERT_GE(r.lower, 0.99 * least - 4e-3 - kSearch);
    }
  }
  EXPECT_LT(samples, 60 * 200);
}

TEST(PoseSegment, SpeedBoundsEveryPoint) {
  const geometry::EnclosingSphere sphere{{0.1, -0.2, 0.05}, 0.3};
  double fullest = 0.0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(31, seed);
    PoseSegment motion(sphere, randomPose(seed), randomPose(seed + 999), 0.7);
    const double t = random.between(0.0, 0.69), dt = 1e-3;
    const Vector3d p = sphere.centre + sphere.radius * random.direction();
    const double speed = (motion.pose(t + dt) * p - motion.pose(t) * p).norm() / dt;
    ASSERT_LE(speed, motion.speed(t, t + dt) + kRounding) << seed;
    fullest = std::max(fullest, speed / motion.speed(t, t + dt));
    ASSERT_TRUE(motion.pose(0.7).isApprox(randomPose(seed + 999), 1e-9));
  }
  EXPECT_GT(fullest, 0.9);
}

/// An arm that brakes from a random motion.
struct Braking {
  mechanism::Mechanism mechanism = robot_file::loadMechanism(projectFile("data/robots/lwr/lwr4.mech"));
  BrakingPath path;
  explicit Braking(Random& random)
      : path({.deceleration = {12.0, 12.0, 15.0, 15.0, 20.0, 20.0, 20.0}, .reaction_time = 0.02}, 7) {
    std::vector<double> q(7), qd(7);
    for (auto& x : q) x = random.between(-2.0, 2.0);
    for (auto& x : qd) x = random.between(-2.0, 2.0);
    EXPECT_TRUE(path.start(q, qd));
  }
};

TEST(LinkMotion, SpeedBoundsEveryPoint) {
  const geometry::EnclosingSphere sphere{{0.0, 0.02, 0.05}, 0.1};
  double fullest = 0.0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Random random(41, seed);
    const Braking arm(random);
    const int frame = static_cast<int>(random.below(7));
    LinkMotion motion(arm.mechanism, arm.path, frame, randomPose(seed), randomPose(seed + 1, 0.05), sphere);
    const double t0 = random.between(0.0, arm.path.stopTime()), t1 = t0 + 1e-4 + 0.05 * random.unit();
    const double dt = 1e-5, t = random.between(t0, t1 - dt);
    for (int k = 0; k < 5; ++k) {
      const Vector3d p = sphere.centre + sphere.radius * random.direction();
      const double speed = (motion.pose(t + dt) * p - motion.pose(t) * p).norm() / dt;
      // Coordinates of some metres, rounded, over a step of 1e-5 s.
      ASSERT_LE(speed, motion.speed(t0, t1) + 1e-9 / dt * 1e-4);
      fullest = std::max(fullest, speed / motion.speed(t0, t1));
    }
  }
  EXPECT_GT(fullest, 0.5) << "the bound is not merely large";
}

TEST(LinkMotion, PrismaticJointSpeedIsItsVelocity) {
  const mechanism::Mechanism rail = robot_file::loadMechanism(projectFile("data/scenes/rail.mech"));
  BrakingPath path({.deceleration = {2.0}, .reaction_time = 0.0}, rail.dof);
  const std::vector<double> q(static_cast<std::size_t>(rail.dof), 0.1),
      qd(static_cast<std::size_t>(rail.dof), 0.5);
  ASSERT_TRUE(path.start(q, qd));
  int prismatic = 0;
  for (std::size_t i = 0; i < rail.frames.size(); ++i) {
    if (rail.frames[i].type != mechanism::JointType::kPrismatic || rail.frames[i].parent >= 0) continue;
    ++prismatic;
    LinkMotion motion(rail, path, static_cast<int>(i), Transform::Identity(), Transform::Identity(),
                      {Vector3d::Zero(), 1.0});
    EXPECT_NEAR(motion.speed(0.0, 0.1), 0.5, kRounding);
    EXPECT_NEAR(motion.speed(0.125, 0.2), 0.25, kRounding);
    EXPECT_NEAR((motion.pose(1.0).translation() - motion.pose(0.0).translation()).norm(), 0.0625, kRounding);
  }
  EXPECT_GT(prismatic, 0);
}

TEST(SweptPair, BrakingArmBoundHoldsForEveryPersonMotion) {
  int safe = 0, within = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(51, seed);
    const Braking arm(random);
    const MotionBounds bounds{2.0, 20.0, 0.005, 0.1};
    LinkMotion link(arm.mechanism, arm.path, 6, Transform::Identity(), Transform::Identity(),
                    rod().bounding_sphere);
    const double duration = arm.path.stopTime();
    const Vector3d p0 = link.pose(duration).translation() + random.between(0.3, 0.9) * random.direction();
    const Vector3d v0 = random.direction() * random.unit();
    UnknownMotion hand(at(p0), v0, bounds, duration);
    SweptScratch scratch;
    const SweptResult r =
        sweptPair({rod(), link}, {ball(), hand}, duration, {.tolerance = 5e-3, .max_samples = 200}, scratch);
    ASSERT_TRUE(r.done);
    safe += r.lower > 0.0;
    for (int k = 0; k < 10; ++k) {
      // As hard as it may, towards the link, within the bounds.
      Vector3d p = p0 + bounds.position_error * random.direction();
      Vector3d v = v0 + bounds.velocity_error * random.direction();
      query::PairMemory memory;
      const int steps = 40;
      const double dt = duration / steps;
      for (int i = 0; i <= steps; ++i) {
        PoseSegment here(ball().bounding_sphere, at(p), at(p), 0.0);
        const double d = distanceAt(rod(), link, ball(), here, i * dt, memory);
        ASSERT_LE(r.lower, std::max(d, 0.0) + kOnSurface) << k << " " << i;
        within += r.lower > 0.0 && d - r.lower < 0.1;
        const Vector3d aim = (link.pose(i * dt).translation() - p).normalized() * 20.0;
        const Vector3d to = v + dt * aim;
        const Vector3d a = to.norm() > 2.0 ? Vector3d::Zero() : aim;
        p += dt * v + 0.5 * dt * dt * a;
        v += dt * a;
      }
    }
  }
  EXPECT_GT(within, 10) << "some motion comes near what was foreseen";
  EXPECT_GT(safe, 5);
  EXPECT_LT(safe, 40);
}

TEST(SweptPair, AllocatesNothing) {
  Random random(61, 0);
  const Braking arm(random);
  LinkMotion link(arm.mechanism, arm.path, 6, Transform::Identity(), Transform::Identity(),
                  rod().bounding_sphere);
  UnknownMotion hand(at({1.0, 0.0, 0.5}), Vector3d::UnitX(), {2.0, 20.0}, 0.5);
  SweptScratch scratch;
  const structure::HapticStructure &of_arm = rod(), &of_hand = ball();  // built when they are asked for first
  const testing::NoAlloc guard;
  const SweptResult r = sweptPair({of_arm, link}, {of_hand, hand}, 0.5, {}, scratch);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_GT(r.samples, 1);
}

}  // namespace swept_pair_test
}  // namespace abstand::safety
