// A point brought to a target: closed forms of a planar arm, and the arms of HUG and of a URDF file.
#include "core/mechanism/inverse_kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.hpp"
#include "core/robot_file/robot.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::mechanism {
namespace inverse_kinematics_test {

using testing::randomUnit;

constexpr double kReached = 1e-6;  // m, PointReach::Options::tolerance
// rad: the tolerance over the least lever of these arms.
constexpr double kAngle = 1e-5;
// rad: where a limit or a stretched arm ends the search, the distance grows with the square of the angle
// only.
constexpr double kFlat = 1e-3;
constexpr double kFlatDistance = 1e-6;             // m, likewise
constexpr double kUpperArm = 0.4, kForearm = 0.3;  // m

/// Two links that turn about z, stretched out along x at 0; the point is the end of the second.
Mechanism planarArm(JointLimits shoulder = {}, JointLimits elbow = {}) {
  Mechanism m;
  for (int i = 0; i < 2; ++i) {
    MechanismFrame frame;
    frame.id = i + 1;
    frame.parent = i - 1;
    frame.type = JointType::kRevolute;
    frame.dof = i;
    frame.has_dh = false;
    frame.X_PJ = Transform::Identity();
    if (i == 1) frame.X_PJ.translation() = Vector3d(kUpperArm, 0, 0);
    frame.limits = i == 0 ? shoulder : elbow;
    m.frames.push_back(frame);
  }
  m.dof = 2;
  m.prepare();
  return m;
}

const Vector3d kEnd(kForearm, 0, 0);

/// Cosine rule; the sign is that of the elbow.
std::array<double, 2> closedForm(double x, double y, double sign) {
  const double c = (x * x + y * y - kUpperArm * kUpperArm - kForearm * kForearm) / (2 * kUpperArm * kForearm);
  const double elbow = sign * std::acos(c);
  return {std::atan2(y, x) - std::atan2(kForearm * std::sin(elbow), kUpperArm + kForearm * c), elbow};
}

double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

TEST(PointReach, PlanarArmMatchesCosineRule) {
  const Mechanism arm = planarArm();
  PointReach reach(arm, 1);
  for (int k = 0; k < 200; ++k) {
    const auto seed = static_cast<std::uint64_t>(k);
    const double radius = 0.15 + 0.5 * randomUnit(seed, 1), angle = 6.0 * randomUnit(seed, 2);
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    std::vector<double> q{angle, sign * 1.2};
    const PointReach::Result result = reach.solve(kEnd, Vector3d(x, y, 0), q);
    ASSERT_LE(result.distance, kReached) << k;
    // From either elbow the arm may come to either solution, but to no third one.
    const auto up = closedForm(x, y, 1.0), down = closedForm(x, y, -1.0);
    const auto apart = [&](const std::array<double, 2>& other) {
      return std::max(std::abs(wrapped(q[0] - other[0])), std::abs(wrapped(q[1] - other[1])));
    };
    EXPECT_LE(std::min(apart(up), apart(down)), kAngle) << k;
  }
}

TEST(PointReach, TargetOutOfReachStretchesArmTowardsIt) {
  const Mechanism arm = planarArm();
  PointReach reach(arm, 1);
  for (const double angle : {0.3, 1.9, -2.4}) {
    std::vector<double> q{angle + 0.4, 0.7};
    const Vector3d target(2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0);
    const PointReach::Result result = reach.solve(kEnd, target, q);
    EXPECT_NEAR(result.distance, 2.0 - kUpperArm - kForearm, kFlatDistance);
    EXPECT_NEAR(wrapped(q[0] - angle), 0.0, kFlat);
    EXPECT_NEAR(wrapped(q[1]), 0.0, kFlat);
  }
  // Off the plane: the error that no joint can reduce stays.
  std::vector<double> q{0.1, 1.0};
  const PointReach::Result above = reach.solve(kEnd, Vector3d(0.3, 0.3, 0.25), q);
  EXPECT_NEAR(above.distance, 0.25, kFlatDistance);
}

TEST(PointReach, LimitOfElbowBoundsReach) {
  JointLimits elbow;
  elbow.lower = 0.5;
  elbow.upper = 2.0;
  const Mechanism arm = planarArm({}, elbow);
  PointReach reach(arm, 1);
  const auto radius = [](double bend) {
    return std::sqrt(kUpperArm * kUpperArm + kForearm * kForearm + 2 * kUpperArm * kForearm * std::cos(bend));
  };
  std::vector<double> far{0.4, 1.2}, near{0.4, 1.2};
  EXPECT_NEAR(reach.solve(kEnd, Vector3d(0.0, 0.69, 0), far).distance, 0.69 - radius(0.5), kFlatDistance);
  EXPECT_EQ(far[1], 0.5) << "at the limit, not before it";
  EXPECT_NEAR(reach.solve(kEnd, Vector3d(0.0, 0.3, 0), near).distance, radius(2.0) - 0.3, kFlatDistance);
  EXPECT_EQ(near[1], 2.0);
}

TEST(PointReach, HeldJointLeavesItsPartToOthers) {
  JointLimits shoulder;
  shoulder.lower = 0.0;
  shoulder.upper = 0.2;
  const Mechanism arm = planarArm(shoulder);
  PointReach reach(arm, 1);
  // Reached with the shoulder at its limit and the elbow alone.
  const double bend = 1.1;
  const Vector3d target(kUpperArm * std::cos(0.2) + kForearm * std::cos(0.2 + bend),
                        kUpperArm * std::sin(0.2) + kForearm * std::sin(0.2 + bend), 0.0);
  std::vector<double> q{0.2, 0.3};
  EXPECT_LE(reach.solve(kEnd, target, q).distance, kReached);
  EXPECT_NEAR(q[0], 0.2, kAngle);
  EXPECT_NEAR(q[1], bend, kAngle);
}

TEST(PointReach, StartBeyondLimitIsClamped) {
  JointLimits elbow;
  elbow.lower = 0.5;
  elbow.upper = 2.0;
  const Mechanism arm = planarArm({}, elbow);
  PointReach reach(arm, 1);
  std::vector<double> q{0.0, -1.0};
  MechanismState state;
  const std::vector<double> clamped{0.0, 0.5};
  forward(arm, clamped, state);
  EXPECT_EQ(reach.solve(kEnd, state.X_BF[1] * kEnd, q).distance, 0.0);
  EXPECT_EQ(q, clamped);
}

TEST(PointReach, UnknownNumbersChangeNothing) {
  const Mechanism arm = planarArm();
  PointReach reach(arm, 1);
  std::vector<double> q{0.1, 0.2};
  EXPECT_TRUE(std::isnan(reach.solve(kEnd, Vector3d(kNaN, 0, 0), q).distance));
  EXPECT_EQ(q, (std::vector<double>{0.1, 0.2}));
  q[1] = kNaN;
  EXPECT_TRUE(std::isnan(reach.solve(kEnd, Vector3d(0.3, 0, 0), q).distance));
  EXPECT_EQ(q[0], 0.1);
  EXPECT_THROW(PointReach(arm, 2), UsageError);
  EXPECT_THROW(PointReach(arm, -1), UsageError);
}

/// The end of an arm is led along what it can reach, as a hand on the mouse does.
class ArmReach : public ::testing::TestWithParam<const char*> {
 protected:
  Mechanism arm{robot_file::loadRobot(testing::projectFile(GetParam())).mechanism};
  int last{static_cast<int>(arm.frames.size()) - 1};
  std::vector<DofLimits> limits{dofLimits(arm)};
  Vector3d p{0.02, -0.03, 0.05};  // m, in the last frame

  std::vector<double> random(std::uint64_t seed) const {
    std::vector<double> q;
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const double lower = std::max(limits[i].lower, -2.5), upper = std::min(limits[i].upper, 2.5);
      q.push_back(lower + (upper - lower) * randomUnit(seed, 10 + i));
    }
    return q;
  }
  Vector3d pointAt(const std::vector<double>& q) const {
    MechanismState state;
    forward(arm, q, state);
    return state.X_BF[static_cast<std::size_t>(last)] * p;
  }
  bool isWithinLimits(const std::vector<double>& q) const {
    for (std::size_t i = 0; i < q.size(); ++i)
      if (!(q[i] >= limits[i].lower && q[i] <= limits[i].upper)) return false;
    return true;
  }
};

TEST_P(ArmReach, FollowsPathWithinLimits) {
  constexpr int kPaths = 40, kSteps = 25;
  PointReach reach(arm, last);
  int missed = 0, most = 0;
  for (int path = 0; path < kPaths; ++path) {
    const std::vector<double> from = random(static_cast<std::uint64_t>(100 + path)),
                              to = random(static_cast<std::uint64_t>(900 + path));
    std::vector<double> q = from;
    for (int k = 1; k <= kSteps; ++k) {
      std::vector<double> on_path = from;
      const double share = static_cast<double>(k) / kSteps;
      for (std::size_t i = 0; i < q.size(); ++i) on_path[i] += share * (to[i] - from[i]);
      const Vector3d target = pointAt(on_path);
      const double before = (target - pointAt(q)).norm();
      const PointReach::Result result = reach.solve(p, target, q);
      EXPECT_TRUE(isWithinLimits(q));
      EXPECT_LE(result.distance, before);
      EXPECT_NEAR(result.distance, (target - pointAt(q)).norm(), 1e-12);
      missed += result.distance > kReached;
      most = std::max(most, result.iterations);
    }
  }
  // A limit may stand in the way of a straight approach although there is a way round.
  std::printf("%s: %d of %d targets missed, at most %d iterations\n", GetParam(), missed, kPaths * kSteps,
              most);
  EXPECT_LE(missed, kPaths * kSteps / 50);
}

TEST_P(ArmReach, TargetFarAwayStaysWithinLimits) {
  PointReach reach(arm, last);
  for (int k = 0; k < 100; ++k) {
    const auto seed = static_cast<std::uint64_t>(k);
    std::vector<double> q = random(seed);
    const Vector3d target =
        5.0 * Vector3d(2 * randomUnit(seed, 1) - 1, 2 * randomUnit(seed, 2) - 1, 2 * randomUnit(seed, 3) - 1);
    const double before = (target - pointAt(q)).norm();
    const PointReach::Result result = reach.solve(p, target, q);
    EXPECT_TRUE(isWithinLimits(q)) << k;
    EXPECT_LE(result.distance, before);
  }
}

TEST_P(ArmReach, AllocatesNothing) {
  PointReach reach(arm, last);
  std::vector<double> q = random(1);
  const Vector3d target = pointAt(random(2));
  testing::NoAlloc guard;
  reach.solve(p, target, q);
  EXPECT_EQ(guard.count(), 0);
}

INSTANTIATE_TEST_SUITE_P(Arms, ArmReach,
                         ::testing::Values("data/robots/lwr/lwr4.mech", "data/robots/arm6/arm6.urdf",
                                           "data/robots/rail7/rail7.urdf", "data/robots/scara/scara.mech"),
                         [](const auto& one) {
                           const std::string file = one.param;
                           const std::size_t from = file.rfind('/') + 1;
                           return file.substr(from, file.rfind('.') - from);
                         });

}  // namespace inverse_kinematics_test
}  // namespace abstand::mechanism
