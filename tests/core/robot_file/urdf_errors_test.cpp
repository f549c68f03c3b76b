// Every mistake in a URDF is told with its place and with what was expected.
#include "core/robot_file/srdf_file.hpp"
#include "core/robot_file/urdf_file.hpp"
#include "tests/core/robot_file/bad_case.hpp"

namespace abstand::robot_file {
namespace urdf_errors_test {

class BadUrdf : public ::testing::TestWithParam<BadCase> {};
TEST_P(BadUrdf, IsRejectedWithPosition) { expectRefused(GetParam(), "bad.urdf", parseUrdf); }

#define LINKS "<robot name='r'><link name='a'/><link name='b'/>\n"

INSTANTIATE_TEST_SUITE_P(
    Xml, BadUrdf,
    ::testing::Values(
        BadCase{"empty", "", 1, 0, "expected a tag"}, BadCase{"text", "hello", 1, 0, "expected a tag"},
        BadCase{"cut", "<robot name='r'>\n<link", 2, 0, "expected"},
        BadCase{"crossed", "<robot>\n<link></robot></link>", 2, 0, "expected </link>"},
        BadCase{"other root", "\n<sdf/>", 2, 1, "expected <robot>"},
        BadCase{"entity", "<robot name='r'>\n<link name='&x;'/></robot>", 2, 1, "&x;"},
        BadCase{"not UTF-8", "<robot name='r'>\n<link name='\xc3('/></robot>", 2, 1, "UTF-8"},
        BadCase{"xacro element",
                "<robot name='r' xmlns:xacro='http://x'>\n <xacro:include filename='a'/></robot>", 2, 2,
                "xacro"},
        BadCase{"xacro expression", "<robot name='r'>\n<link name='${prefix}base'/></robot>", 2, 1, "xacro"},
        BadCase{"xacro argument", "<robot name='r'>\n<link name='$(arg p)base'/></robot>", 2, 1, "xacro"}));

INSTANTIATE_TEST_SUITE_P(
    Tree, BadUrdf,
    ::testing::Values(
        BadCase{"no link", "<robot name='r'/>", 1, 1, "without a link"},
        BadCase{"no name", "<robot name='r'>\n<link/></robot>", 2, 1, "without name"},
        BadCase{"same name", "<robot name='r'><link name='a'/>\n<link name='a'/></robot>", 2, 1,
                "second time"},
        BadCase{"two roots", "<robot name='r'><link name='a'/>\n<link name='b'/></robot>", 2, 1, "one root"},
        BadCase{"no parent", LINKS "<joint name='j' type='fixed'><child link='b'/></joint></robot>", 2, 1,
                "<parent>"},
        BadCase{"no child", LINKS "<joint name='j' type='fixed'><parent link='a'/></joint></robot>", 2, 1,
                "<child>"},
        BadCase{"unknown link",
                LINKS "<joint name='j' type='fixed'><parent link='a'/><child link='bb'/></joint></robot>", 2,
                1, "not there"},
        BadCase{"two parents",
                LINKS "<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint>\n"
                      "<joint name='k' type='fixed'><parent link='a'/><child link='b'/></joint></robot>",
                3, 1, "second joint"},
        BadCase{"ring",
                LINKS "<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint>\n"
                      "<joint name='k' type='fixed'><parent link='b'/><child link='a'/></joint></robot>",
                1, 17, "own descendants"},
        BadCase{"itself",
                LINKS "<joint name='j' type='fixed'><parent link='b'/><child link='b'/></joint></robot>", 1,
                33, "own descendants"}));

#define JOINT(type, inside) \
  LINKS "<joint name='j' type='" type "'><parent link='a'/><child link='b'/>\n" inside "</joint></robot>"

INSTANTIATE_TEST_SUITE_P(
    Joints, BadUrdf,
    ::testing::Values(
        BadCase{"no type", LINKS "<joint name='j'><parent link='a'/><child link='b'/></joint></robot>", 2, 1,
                "without type"},
        BadCase{"unknown type", JOINT("revolut", ""), 2, 1, "did you mean revolute?"},
        BadCase{"no limit", JOINT("revolute", ""), 2, 1, "without <limit>"},
        BadCase{"no effort", JOINT("revolute", "<limit lower='0' upper='1' velocity='1'/>"), 3, 1,
                "without effort"},
        BadCase{"no velocity", JOINT("prismatic", "<limit lower='0' upper='1' effort='1'/>"), 3, 1,
                "without velocity"},
        BadCase{"no number", JOINT("prismatic", "<limit lower='0' upper='1x' effort='1' velocity='1'/>"), 3,
                1, "upper"},
        BadCase{"nan", JOINT("prismatic", "<limit lower='nan' upper='1' effort='1' velocity='1'/>"), 3, 1,
                "finite"},
        BadCase{"infinite", JOINT("fixed", "<origin xyz='0 0 1e999'/>"), 3, 1, "finite"},
        BadCase{"far", JOINT("fixed", "<origin xyz='0 0 1e7'/>"), 3, 1, "1e+06"},
        BadCase{"two numbers", JOINT("fixed", "<origin xyz='0 0'/>"), 3, 1, "expected three"},
        BadCase{"four numbers", JOINT("fixed", "<origin rpy='0 0 0 0'/>"), 3, 1, "expected three"},
        BadCase{"no axis", JOINT("continuous", "<axis xyz='0 0 0'/>"), 3, 1, "expected a direction"},
        BadCase{"mimic nothing", JOINT("continuous", "<mimic joint='k'/>"), 2, 1, "mimics"},
        BadCase{"mimic itself", JOINT("continuous", "<mimic joint='j'/>"), 2, 1, "mimics itself"},
        BadCase{"same joint",
                LINKS "<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint>\n"
                      "<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint></robot>",
                3, 1, "second time"}));

#define LINK(inside) "<robot name='r'><link name='a'>\n" inside "</link></robot>"

INSTANTIATE_TEST_SUITE_P(
    Links, BadUrdf,
    ::testing::Values(
        BadCase{"mass", LINK("<inertial><mass value='x'/><inertia/></inertial>"), 2, 11, "finite number"},
        BadCase{"collision without geometry", LINK("<collision/>"), 2, 1, "without a geometry"},
        BadCase{"collision of no kind", LINK("<collision><geometry/></collision>"), 2, 1,
                "without a geometry"},
        BadCase{"capsule",
                LINK("<collision><geometry><capsule radius='1' length='1'/></geometry></collision>"), 2, 1,
                "expected mesh, box, sphere or cylinder"},
        BadCase{"flat box", LINK("<collision><geometry><box size='1 1 0'/></geometry></collision>"), 2, 1,
                "positive edges"},
        BadCase{"no radius", LINK("<collision><geometry><sphere/></geometry></collision>"), 2, 22,
                "without radius"},
        BadCase{"negative radius", LINK("<collision><geometry><sphere radius='-1'/></geometry></collision>"),
                2, 1, "radius -1"},
        BadCase{"no file", LINK("<collision><geometry><mesh/></geometry></collision>"), 2, 22,
                "without filename"},
        BadCase{"scale 0",
                LINK("<collision><geometry><mesh filename='a' scale='1 0 1'/></geometry></collision>"), 2, 1,
                "scale of 0"}));

class BadSrdf : public ::testing::TestWithParam<BadCase> {};
TEST_P(BadSrdf, IsRejectedWithPosition) { expectRefused(GetParam(), "bad.urdf", parseSrdf); }

INSTANTIATE_TEST_SUITE_P(
    Srdf, BadSrdf,
    ::testing::Values(BadCase{"other root", "<sdf/>", 1, 1, "expected <robot>"},
                      BadCase{"URDF", "<robot name='r'>\n<link name='a'/></robot>", 2, 1, "URDF"},
                      BadCase{"one link", "<robot name='r'>\n<disable_collisions link1='a'/></robot>", 2, 1,
                              "without link2"},
                      BadCase{"itself", "<robot>\n<disable_collisions link1='a' link2='a'/></robot>", 2, 1,
                              "itself"}));

TEST(Srdf, RoundTripsWithReasons) {
  Srdf srdf;
  srdf.robot = "arm <1>";
  srdf.disabled = {{"a", "b", "Adjacent", {}}, {"a & \"b\"", "c", "never: 10000 samples", {}}};
  const Srdf again = parseSrdf(srdfText(srdf), "test.srdf");
  EXPECT_EQ(again.robot, srdf.robot);
  ASSERT_EQ(again.disabled.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again.disabled[i].link1, srdf.disabled[i].link1);
    EXPECT_EQ(again.disabled[i].link2, srdf.disabled[i].link2);
    EXPECT_EQ(again.disabled[i].reason, srdf.disabled[i].reason);
  }
  const Srdf moveit = parseSrdf(
      "<robot name='r'><group name='arm'><joint name='j'/></group>"
      "<disable_collisions link1='a' link2='b'/></robot>",
      "test.srdf");
  EXPECT_EQ(moveit.disabled.size(), 1u);
}

}  // namespace urdf_errors_test
}  // namespace abstand::robot_file
