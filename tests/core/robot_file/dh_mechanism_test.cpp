// Rows of Denavit-Hartenberg tables, and robots that are turned into one.
#include <gtest/gtest.h>

#include <cmath>

#include "core/math/random.hpp"
#include "core/robot_file/dh_mechanism.hpp"
#include "core/robot_file/mech_file.hpp"
#include "core/robot_file/robot_writer.hpp"
#include "core/robot_file/urdf_file.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/robots.hpp"

namespace abstand::robot_file {
namespace dh_mechanism_test {

// What `abstand convert` calls exact, m and rad.
constexpr double kExact = 1e-9;
// Products of rotations over some metres.
constexpr double kRounding = 1e-12;

Transform product(const std::vector<DhRow>& rows) {
  Transform X = Transform::Identity();
  for (const auto& row : rows) X = X * transformOf(row);
  return X;
}

Transform randomTransform(Random& random) {
  Transform X = Transform::Identity();
  X.linear() = random.rotation();
  X.translation() = random.inCube(1.0);
  return X;
}

TEST(DhRows, TwoRowsReachAnyPose) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(5, seed);
    const Transform X = randomTransform(random);
    const auto rows = dhRows(X, {});
    EXPECT_LE(rows.size(), 2u);
    EXPECT_LT((product(rows).matrix() - X.matrix()).cwiseAbs().maxCoeff(), kRounding);
  }
}

TEST(DhRows, RecoverSingleRow) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(6, seed);
    // All kinds of axes: any, parallel, and intersecting.
    DhRow row{random.between(-1, 1), random.between(-3, 3), random.between(-1, 1), random.between(-3, 3)};
    if (seed % 3 == 1) row.alpha = 0.0;
    if (seed % 3 == 2) row.a = 0.0;
    const auto rows = dhRows(transformOf(row), {});
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_NEAR(rows[0].a, row.a, kRounding);
    EXPECT_NEAR(rows[0].alpha, row.alpha, kRounding);
    EXPECT_NEAR(rows[0].d, row.d, kRounding);
    EXPECT_NEAR(rows[0].theta, row.theta, kRounding);
  }
}

TEST(DhRows, NearlyParallelAxesStayExact) {
  for (double tilt = 1e-13; tilt < 0.1; tilt *= 3.0) {
    SCOPED_TRACE(tilt);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      Random random(7, seed);
      Transform X = randomTransform(random);
      X.linear() = (Eigen::AngleAxisd(random.between(-3, 3), Vector3d::UnitZ()) *
                    Eigen::AngleAxisd(tilt, Vector3d::UnitX()) *
                    Eigen::AngleAxisd(random.between(-3, 3), Vector3d::UnitZ()))
                       .toRotationMatrix();
      const auto rows = dhRows(X, {});
      EXPECT_LE(rows.size(), 3u);
      EXPECT_LT((product(rows).matrix() - X.matrix()).cwiseAbs().maxCoeff(), 1e-10);
    }
  }
}

Robot robotOf(mechanism::Mechanism mechanism) {
  Robot robot;
  robot.mechanism = std::move(mechanism);
  robot.mechanism.prepare();
  for (auto& f : robot.mechanism.frames) f.name = "link" + std::to_string(f.id);
  return robot;
}

TEST(DhMechanism, AnyRobotRoundTripsThroughDhTable) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Robot robot = robotOf(testing::randomRobot(seed, 12, seed % 2 == 1));
    const Robot table = toDh(robot);
    EXPECT_TRUE(table.mechanism.frames.front().has_dh);
    const auto residual = postureResidual(robot.mechanism, table.mechanism, 50);
    EXPECT_LT(residual.position, kExact);
    EXPECT_LT(residual.angle, kExact);

    const Robot read = parseMech(mechText(table), "test.mech");
    const auto read_residual = postureResidual(robot.mechanism, read.mechanism, 50);
    EXPECT_LT(read_residual.position, kExact);
    EXPECT_LT(read_residual.angle, kExact);
  }
}

TEST(DhMechanism, AnyRobotRoundTripsThroughUrdf) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Robot robot = robotOf(testing::randomRobot(seed, 12, seed % 2 == 1));
    const UrdfWritten written = urdfText(robot);
    const Robot read = parseUrdf(written.text, "test.urdf");
    ASSERT_EQ(read.mechanism.dof, robot.mechanism.dof);
    const auto residual = postureResidual(robot.mechanism, read.mechanism, 50, written.scale);
    EXPECT_LT(residual.position, kExact);
    EXPECT_LT(residual.angle, kExact);
  }
}

TEST(DhMechanism, ResidualDetectsDifference) {
  const Robot robot = robotOf(testing::sevenAxisArm());
  Robot other = robot;
  other.mechanism.frames[3].X_PJ.translation().x() += 0.001;
  other.mechanism.frames[3].d += 0.001;
  other.mechanism.frames[3].a += 0.001;
  other.mechanism.prepare();
  EXPECT_GT(postureResidual(robot.mechanism, other.mechanism, 50).position, 0.9e-3);
}

TEST(DhMechanism, ChainNeedsOneRowPerJoint) {
  // The shipped arm, written as a URDF and turned into a table again: its own seven rows.
  const Robot arm = loadRobot(testing::projectFile("data/robots/lwr/lwr4.mech"));
  const Robot urdf = parseUrdf(urdfText(arm).text, "lwr4.urdf");
  const Robot table = toDh(urdf);
  ASSERT_EQ(arm.mechanism.frames.size(), 7u);
  ASSERT_GE(table.mechanism.frames.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i) {
    SCOPED_TRACE(i);
    const auto &f = arm.mechanism.frames[i], &g = table.mechanism.frames[i];
    EXPECT_NEAR(g.a, f.a, kRounding);
    EXPECT_NEAR(g.alpha, f.alpha, kRounding);
    EXPECT_NEAR(g.d, f.d, kRounding);
    EXPECT_NEAR(g.offset, 0.0, kRounding);
  }
}

TEST(DhMechanism, KeepsLimitsMassAndGeometry) {
  const char* const text =
      "<robot name='r'><link name='a'/><link name='b'><inertial><origin xyz='0.1 0.2 0.3'/><mass value='2'/>"
      "<inertia ixx='1' iyy='1.5' izz='2'/></inertial><collision><origin xyz='0 0 0.5'/><geometry><mesh "
      "filename='a b#.stl' "
      "scale='0.001 0.001 0.002'/></geometry></collision><visual><geometry><cylinder radius='1' "
      "length='2'/></geometry></visual>"
      "</link><joint name='turn' type='revolute'><origin xyz='0 0 1' rpy='0 0 0.3'/><parent link='a'/><child "
      "link='b'/>"
      "<axis xyz='0 1 0'/><limit lower='-1' upper='0.5' velocity='2' effort='30'/></joint></robot>";
  const Robot robot = parseUrdf(text, "r.urdf");
  const Robot read = parseMech(mechText(toDh(robot)), "r.mech");
  const Robot back = parseUrdf(urdfText(read).text, "r.urdf");
  for (const Robot* r : {&read, &back}) {
    const int at = r->mechanism.indexOf("b");
    ASSERT_GE(at, 0);
    const auto& i = r->mechanism.frames[static_cast<std::size_t>(at)].inertia;
    EXPECT_EQ(i.mass, 2.0);
    EXPECT_TRUE(i.com_F.isApprox(Vector3d(0.1, 0.2, 0.3), kRounding));
    EXPECT_TRUE(i.inertia_F.isApprox(Vector3d(1, 1.5, 2).asDiagonal().toDenseMatrix(), kRounding));
    ASSERT_EQ(r->geometry.size(), 2u);
    EXPECT_EQ(r->geometry[0].mesh, "a b#.stl");
    EXPECT_EQ(r->geometry[0].scale, Vector3d(0.001, 0.001, 0.002));
    EXPECT_EQ(r->geometry[0].frame, at);
    EXPECT_TRUE(r->geometry[0].X_FG.isApprox(Transform(Eigen::Translation3d(0, 0, 0.5)), kRounding));
    EXPECT_EQ(std::get<geometry::Cylinder>(*r->geometry[1].shape).length, 2.0);
    EXPECT_EQ(r->geometry[1].use, GeometryUse::kVisual);
    for (const auto& f : r->mechanism.frames) {
      if (f.dof < 0) continue;
      EXPECT_EQ(f.joint, "turn");
      EXPECT_NEAR(f.limits.lower - f.offset, -1.0, kRounding);
      EXPECT_NEAR(f.limits.upper - f.offset, 0.5, kRounding);
      EXPECT_NEAR(f.limits.velocity, 2.0, kRounding);
      EXPECT_EQ(f.limits.effort, 30.0);
    }
  }
}

}  // namespace dh_mechanism_test
}  // namespace abstand::robot_file
