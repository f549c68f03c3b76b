// URDF: what is understood, against closed forms.
#include "core/math/turn_between.hpp"
#include "core/robot_file/urdf_file.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mechanism/joint_range.hpp"

namespace abstand::robot_file {
namespace urdf_test {

// A few roundings over some frames of 1 m.
constexpr double kRounding = 1e-13;

Transform about(const Vector3d& axis, double angle) {
  return Transform(Eigen::AngleAxisd(angle, axis.normalized()));
}
Transform along(const Vector3d& way) { return Transform(Eigen::Translation3d(way)); }

Transform poseOf(const Robot& robot, const std::vector<double>& q, const std::string& link) {
  mechanism::MechanismState state;
  mechanism::forward(robot.mechanism, q, state);
  return state.X_BF[static_cast<std::size_t>(robot.mechanism.indexOf(link))];
}

std::string jointText(const std::string& name, const std::string& type, const std::string& parent,
                      const std::string& child, const std::string& inside) {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" +
         child + "'/>" + inside + "</joint>\n";
}

std::string robotText(const std::string& links, const std::string& rest) {
  std::string text = "<?xml version='1.0'?>\n<!-- made for this test -->\n<robot name='test'>\n";
  for (const char link : links) text += std::string("<link name='") + link + "'/>\n";
  return text + rest + "</robot>\n";
}

const std::string kLimit = "<limit lower='-1' upper='2' velocity='3' effort='4'/>";
const Vector3d kAxis(1, -2, 0.5);

TEST(Urdf, EveryJointTypeMovesItsLink) {
  const std::string origin = "<origin xyz='0.1 0.2 0.3' rpy='0.4 -0.5 0.6'/><axis xyz='1 -2 0.5'/>";
  const Transform X = fromXyzRpy({0.1, 0.2, 0.3}, {0.4, -0.5, 0.6});
  const Matrix3d toAxis = turnBetween(Vector3d::UnitZ(), kAxis).toRotationMatrix();
  const struct {
    std::string type, limit;
    std::vector<double> q;
    Transform moved;
  } cases[] = {
      {"fixed", "", {}, Transform::Identity()},
      {"revolute", kLimit, {0.7}, about(kAxis, 0.7)},
      {"continuous", "", {4.0}, about(kAxis, 4.0)},
      {"prismatic", kLimit, {0.7}, along(0.7 * kAxis.normalized())},
      {"planar", "", {0.3, -0.2, 0.9}, along(toAxis * Vector3d(0.3, -0.2, 0)) * about(kAxis, 0.9)},
      {"floating", "", {1, 2, 3, 0.3, 0.2, 0.1}, fromXyzRpy({1, 2, 3}, {0.1, 0.2, 0.3})},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.type);
    const Robot robot =
        parseUrdf(robotText("ab", jointText("j", c.type, "a", "b", origin + c.limit)), "test.urdf");
    ASSERT_EQ(robot.mechanism.dof, static_cast<int>(c.q.size()));
    EXPECT_TRUE(poseOf(robot, c.q, "b").isApprox(X * c.moved, kRounding));
    EXPECT_TRUE(poseOf(robot, c.q, "a").isApprox(Transform::Identity(), 0.0));
  }
}

TEST(Urdf, DofsAreInFileOrderAndFramesParentsFirst) {
  const std::string axis = "<axis xyz='0 0 1'/>";
  const Robot robot =
      parseUrdf(robotText("dcba", jointText("third", "continuous", "c", "d", axis) +
                                      jointText("lift", "prismatic", "b", "c", axis + kLimit) +
                                      jointText("first", "continuous", "a", "b", axis)),
                "test.urdf");
  const mechanism::Mechanism& m = robot.mechanism;
  EXPECT_EQ(m.name, "test");
  ASSERT_EQ(m.frames.size(), 4u);
  EXPECT_EQ(m.frames[0].name, "a");
  EXPECT_EQ(m.frames[0].parent, -1);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(m.frames[i].parent, static_cast<int>(i) - 1);
  EXPECT_EQ(m.frames[1].dof, 2);
  EXPECT_EQ(m.frames[2].dof, 1);
  EXPECT_EQ(m.frames[3].dof, 0);
  EXPECT_EQ(m.frames[3].joint, "third");
  EXPECT_EQ(m.frames[2].limits.lower, -1.0);
  EXPECT_EQ(m.frames[2].limits.upper, 2.0);
  EXPECT_EQ(m.frames[2].limits.velocity, 3.0);
  EXPECT_EQ(m.frames[2].limits.effort, 4.0);
  EXPECT_EQ(m.frames[1].limits.upper, kInfinity);
}

TEST(Urdf, MimicJointsShareDof) {
  // c follows b, which follows a: value_c = 0.1 + 2 (0.3 - 0.5 q).
  const std::string axis = "<axis xyz='0 0 1'/>";
  const Robot robot = parseUrdf(
      robotText("oabc", jointText("c", "revolute", "b", "c",
                                  axis + kLimit + "<mimic joint='b' multiplier='2' offset='0.1'/>") +
                            jointText("b", "prismatic", "a", "b",
                                      axis + kLimit + "<mimic joint='a' multiplier='-0.5' offset='0.3'/>") +
                            jointText("a", "revolute", "o", "a", axis + kLimit)),
      "test.urdf");
  ASSERT_EQ(robot.mechanism.dof, 1);
  const double q = 0.8;
  const Transform X =
      about({0, 0, 1}, q) * along({0, 0, 0.3 - 0.5 * q}) * about({0, 0, 1}, 0.1 + 2 * (0.3 - 0.5 * q));
  EXPECT_TRUE(poseOf(robot, {q}, "c").isApprox(X, kRounding));
  EXPECT_FALSE(robot.mechanism.frames[1].mimic);
  EXPECT_TRUE(robot.mechanism.frames[2].mimic);
  const auto ranges =
      mechanism::jointRanges(robot.mechanism);  // of the joint that leads, not of the followers
  EXPECT_EQ(ranges[0].lower, -1.0);
  EXPECT_EQ(ranges[0].upper, 2.0);
}

TEST(Urdf, MimicOfFixedJointStaysAtOffset) {
  const Robot robot =
      parseUrdf(robotText("abc", jointText("f", "fixed", "a", "b", "") +
                                     jointText("m", "continuous", "b", "c",
                                               "<axis xyz='0 0 1'/><mimic joint='f' offset='0.5'/>")),
                "test.urdf");
  EXPECT_EQ(robot.mechanism.dof, 0);
  EXPECT_TRUE(poseOf(robot, {}, "c").isApprox(about({0, 0, 1}, 0.5), kRounding));
}

TEST(Urdf, InertiaIsRotatedToLinkAxes) {
  const Robot robot = parseUrdf(
      "<robot name='r'><link name='a'><inertial><origin xyz='1 2 3' rpy='0 0 1.5707963267948966'/><mass "
      "value='4'/>"
      "<inertia ixx='1' iyy='2' izz='2.5' ixy='0.1' ixz='0.2' iyz='0.3'/></inertial></link></robot>",
      "test.urdf");
  const mechanism::LinkInertia& i = robot.mechanism.frames[0].inertia;
  EXPECT_EQ(i.mass, 4.0);
  EXPECT_EQ(i.com_F, Vector3d(1, 2, 3));
  Matrix3d expected;  // a quarter turn about z takes x to y and y to -x
  expected << 2, -0.1, -0.3, -0.1, 1, 0.2, -0.3, 0.2, 2.5;
  EXPECT_TRUE(i.inertia_F.isApprox(expected, kRounding));
  EXPECT_TRUE(robot.warnings.empty());
}

TEST(Urdf, GeometryKeepsOrderUseScaleAndPose) {
  const Robot robot = parseUrdf(
      "<robot name='r'>\n<link name='a'>\n"
      "<visual><origin xyz='1 0 0'/><geometry><mesh filename='package://p/a &amp; b.dae' scale='0.1 0.2 "
      "-0.3'/></geometry>"
      "<material name='red'><color rgba='1 0 0 1'/></material></visual>\n"
      "<collision><geometry><box size='1 2 3'/></geometry></collision>\n"
      "<collision><origin rpy='0 0 0.5'/><geometry><cylinder radius='0.1' "
      "length='0.4'/></geometry></collision>\n"
      "<collision><geometry><sphere radius='0.2'/></geometry></collision>\n"
      "</link>\n<gazebo reference='a'><mu1>0.2</mu1></gazebo><transmission name='t'><joint "
      "name='x'/></transmission>\n</robot>",
      "test.urdf");
  ASSERT_EQ(robot.geometry.size(), 4u);
  const auto& g = robot.geometry;
  EXPECT_EQ(g[0].use, GeometryUse::kVisual);
  EXPECT_EQ(g[0].mesh, "package://p/a & b.dae");
  EXPECT_EQ(g[0].scale, Vector3d(0.1, 0.2, -0.3));
  EXPECT_EQ(g[0].X_FG.translation(), Vector3d(1, 0, 0));
  EXPECT_EQ(g[0].pos.line, 3);
  EXPECT_EQ(g[0].pos.column, 1);
  EXPECT_EQ(std::get<geometry::Cuboid>(*g[1].shape).size, Vector3d(1, 2, 3));
  EXPECT_EQ(std::get<geometry::Cylinder>(*g[2].shape).length, 0.4);
  EXPECT_TRUE(g[2].X_FG.isApprox(about({0, 0, 1}, 0.5), kRounding));
  EXPECT_EQ(std::get<geometry::Sphere>(*g[3].shape).radius, 0.2);
  for (const auto& body : g) EXPECT_EQ(body.frame, 0);
}

TEST(Urdf, WarnsOfQuestionableContent) {
  const struct {
    const char *text, *says;
    int line;
  } cases[] = {
      {"<link name='a'>\n<inertial><mass value='0'/><inertia ixx='1' iyy='1' izz='1'/></inertial></link>",
       "the mass 0", 2},
      {"<link name='a'>\n<inertial><mass value='-2'/><inertia ixx='1' iyy='1' izz='1'/></inertial></link>",
       "the mass -2", 2},
      {"<link name='a'>\n<inertial><mass value='2'/></inertial></link>", "without <inertia>", 2},
      {"<link name='a'><inertial><mass value='2'/>\n<inertia ixx='1' iyy='1' izz='3'/></inertial></link>",
       "no body has", 2},
      {"<link name='a'>\n\n<visual><geometry><capsule radius='1' length='1'/></geometry></visual></link>",
       "ignored", 3},
      {"<link name='a'>\n<visual/></link>", "without a geometry", 2},
      {"<link name='a'>\n<collision><geometry><sphere radius='0'/></geometry></collision></link>",
       "radius 0 in <collision>, expected a positive one: ignored", 2},
      {"<link name='a'/><link name='b'/><joint name='j' type='prismatic'><parent link='a'/><child "
       "link='b'/>\n"
       "<axis xyz='0 0 2'/><limit lower='0' upper='1' effort='1' velocity='1'/></joint>",
       "axis of length 2", 2},
      {"<link name='a'/><link name='b'/><joint name='j' type='prismatic'><parent link='a'/><child "
       "link='b'/>\n"
       "<limit lower='1' upper='0' effort='1' velocity='1'/></joint>",
       "no limit", 2},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.text);
    const Robot robot = parseUrdf(std::string("<robot name='r'>") + c.text + "</robot>", "test.urdf");
    ASSERT_EQ(robot.warnings.size(), 1u);
    EXPECT_EQ(robot.warnings[0].find("test.urdf:" + std::to_string(c.line) + ":"), 0u) << robot.warnings[0];
    EXPECT_NE(robot.warnings[0].find(c.says), std::string::npos) << robot.warnings[0];
    EXPECT_TRUE(robot.geometry.empty());
  }
}

TEST(Urdf, UnlimitedJointIsSampledOverTurnOrMetre) {
  const Robot robot =
      parseUrdf(robotText("abc", jointText("t", "continuous", "a", "b", "") +
                                     jointText("s", "prismatic", "b", "c",
                                               "<limit lower='1' upper='0' effort='1' velocity='1'/>")),
                "test.urdf");
  const auto ranges = mechanism::jointRanges(robot.mechanism);
  ASSERT_EQ(ranges.size(), 2u);
  EXPECT_TRUE(ranges[0].unlimited && ranges[1].unlimited);
  EXPECT_EQ(ranges[0].lower, -kPi);
  EXPECT_EQ(ranges[0].upper, kPi);
  EXPECT_EQ(ranges[1].lower, -1.0);
  EXPECT_EQ(ranges[1].upper, 1.0);
}

TEST(Urdf, PrintsNothing) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  parseUrdf(
      "<robot name='r' version='7.3'><link name='a'><visual><geometry><box size='1 1 1'/></geometry>"
      "<material name='nowhere'/></visual></link></robot>",
      "test.urdf");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace urdf_test
}  // namespace abstand::robot_file
