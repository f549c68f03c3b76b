// Reach sets hold every admissible motion, and no less would.
#include "core/safety/reach_set.hpp"

#include <gtest/gtest.h>

#include "core/math/random.hpp"

namespace abstand::safety {
namespace reach_set_test {

// Rounding of positions of some metres, summed over some hundred steps.
constexpr double kRounding = 1e-12;
constexpr double kExact = 1e-12;

/// A motion of piecewise constant acceleration that keeps its bounds: pieces are exact parabolas, and a piece
/// after which it would be too fast is replaced by the part of it that is not, or by none.
class AdmissibleMotion {
 public:
  AdmissibleMotion(const Vector3d& p0, const Vector3d& v0, const MotionBounds& bounds, Random& random)
      : bounds_(bounds), random_(random) {
    p_ = p0 + bounds.position_error * random.direction();
    v_ = v0 + bounds.velocity_error * random.direction();
    const double v = v_.norm();
    ok_ = v <= bounds.speed;
    bias_ = random.direction();
  }
  bool admissible() const { return ok_; }
  void step(double dt) {
    // Mostly the same way, so that it gets far; as hard as allowed as a rule.
    Vector3d a = (random_.chance(0.8) ? bias_ : random_.direction()) * bounds_.acceleration;
    if (random_.chance(0.2)) a *= random_.unit();
    // The speed along a straight line in velocity space is largest at an end.
    if ((v_ + dt * a).norm() > bounds_.speed) {
      // Slide along the sphere of velocities: take the way to the nearest allowed velocity.
      const Vector3d to = (v_ + dt * a).normalized() * bounds_.speed * (1.0 - 1e-12);
      a = (to - v_) / dt;
      if (a.norm() > bounds_.acceleration) a.setZero();
    }
    p_ += dt * v_ + 0.5 * dt * dt * a;
    v_ += dt * a;
  }
  const Vector3d& p() const { return p_; }

 private:
  MotionBounds bounds_;
  Random& random_;
  Vector3d p_, v_, bias_;
  bool ok_{false};
};

TEST(ReachSet, ContainsEveryAdmissibleMotion) {
  int tried = 0;
  double fullest = 0.0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(7, seed);
    MotionBounds bounds{random.between(0.2, 3.0), random.between(0.5, 50.0)};
    if (random.chance(0.5)) bounds.position_error = random.between(0.0, 0.05);
    if (random.chance(0.5)) bounds.velocity_error = random.between(0.0, 0.3);
    const Vector3d p0 = random.inCube(2.0);
    const Vector3d v0 = random.direction() * bounds.speed * random.unit();
    AdmissibleMotion motion(p0, v0, bounds, random);
    if (!motion.admissible()) continue;
    ++tried;
    const double horizon = random.between(0.01, 0.6);
    const geometry::EnclosingSphere all = reachWithin(p0, v0, bounds, horizon);
    const int steps = 40;
    for (int i = 1; i <= steps; ++i) {
      motion.step(horizon / steps);
      const double t = horizon * i / steps;
      const geometry::EnclosingSphere at = reachAt(p0, v0, bounds, t);
      ASSERT_LE((motion.p() - at.centre).norm(), at.radius + kRounding) << t;
      ASSERT_LE((motion.p() - all.centre).norm(), all.radius + kRounding) << t;
      fullest = std::max(fullest, (motion.p() - at.centre).norm() / at.radius);
    }
  }
  EXPECT_GT(tried, 2000);
  EXPECT_GT(fullest, 0.95) << "some motion comes near the edge, so the sets are not merely large";
}

TEST(ReachSet, RestingPointMatchesClosedForm) {
  const Vector3d p(1, 2, 3);
  // Slow to gather speed: a t^2 / 2 = 0.125 m below 0.5 m; then bounded by the speed.
  const geometry::EnclosingSphere early = reachAt(p, Vector3d::Zero(), {1.0, 1.0}, 0.5);
  EXPECT_NEAR(early.radius, 0.125, kExact);
  EXPECT_EQ(early.centre, p);
  EXPECT_NEAR(reachAt(p, Vector3d::Zero(), {1.0, 1.0}, 4.0).radius, 4.0, kExact);
  EXPECT_NEAR(reachAt(p, Vector3d::Zero(), {1.0, 1.0, 0.01, 0.1}, 0.5).radius, 0.125 + 0.01 + 0.05, kExact);
  EXPECT_EQ(reachAt(p, Vector3d::Zero(), {}, 0.5).radius, kInfinity) << "nothing is known";
  EXPECT_EQ(reachAt(p, Vector3d::Zero(), {.speed = 2.0}, 0.5).radius, 1.0 + 1e-14 * (p.norm() + 1.0));
}

TEST(ReachSet, IntersectsBothBounds) {
  // At the highest speed along x: the ball about x = 1 with radius 0.5 and the one about 0 with radius 1 cut
  // in the plane x = (1 + 1 - 0.25) / 2 = 0.875, in a circle of radius sqrt(1 - 0.875^2) = 0.4841.
  const geometry::EnclosingSphere s = reachAt(Vector3d::Zero(), Vector3d::UnitX(), {1.0, 1.0}, 1.0);
  EXPECT_NEAR(s.centre.x(), 0.875, kExact);
  // Widened by the square root of a double's rounding.
  EXPECT_NEAR(s.radius, std::sqrt(1.0 - 0.875 * 0.875), 1e-6);
  // A measured speed that breaks the bound: both balls, and what lies between.
  const geometry::EnclosingSphere both = reachAt(Vector3d::Zero(), 10.0 * Vector3d::UnitX(), {1.0, 1.0}, 1.0);
  EXPECT_NEAR(both.centre.x() - both.radius, -1.0, kExact);
  EXPECT_NEAR(both.centre.x() + both.radius, 10.5, kExact);
}

TEST(TravelWithin, MatchesClosedForm) {
  const MotionBounds b{2.0, 4.0};
  EXPECT_NEAR(travelWithin(0.0, b, 0.25), 0.125, kExact);
  // Half a second to reach 2 m/s over 0.5 m, then 2 m/s.
  EXPECT_NEAR(travelWithin(0.0, b, 1.0), 1.5, kExact);
  EXPECT_NEAR(travelWithin(1.0, b, 0.25), 0.375, kExact);
  EXPECT_NEAR(travelWithin(9.0, b, 1.0), 2.0, kExact);
  EXPECT_EQ(travelWithin(-1.0, b, 0.25), 0.0) << "it goes away first";
  EXPECT_NEAR(travelWithin(-1.0, b, 1.0), -0.25 / 2 + 0.5 + 0.25 * 2.0, kExact);
  EXPECT_NEAR(travelWithin(0.5, {2.0, 0.0}, 2.0), 1.0, kExact);
  EXPECT_EQ(travelWithin(0.5, {2.0, kInfinity}, 2.0), 4.0);
  EXPECT_EQ(travelWithin(0.5, b, 0.0), 0.0);
}

}  // namespace reach_set_test
}  // namespace abstand::safety
