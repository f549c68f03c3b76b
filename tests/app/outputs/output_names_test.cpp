// Outputs that are inputs as well, or two of one name; what a file keeps that is written again.
#include "tests/app/outputs/outputs.hpp"

namespace abstand::testing {
namespace output_names_test {

TEST_F(Outputs, RejectsFileReadByScene) {
  const std::string before = readFile(in("slide.csv"));
  for (const char* option : {"--pairs-out", "--session"}) {
    const Answer a = run(std::string("run scene.yaml ") + option + " slide.csv");
    EXPECT_EQ(a.code, 2) << a.err;
  }
  EXPECT_EQ(run("check scene.yaml --min-distance 0.01 --junit slide.csv").code, 2);
  EXPECT_EQ(readFile(in("slide.csv")), before);
}

TEST_F(Outputs, RejectsTwoOutputsOfOneName) {
  makePeerScene();
  makeClip();
  const auto before = names();
  for (const char* both :
       {"run scene.yaml --pairs-out a --objects-out a", "run scene.yaml --pairs-out a --session ./a",
        "check scene.yaml --min-distance 0.01 --junit a --report a", "skeleton person.csv --out a --write a",
        "pairs pair.urdf --out a --srdf a", "bench --scenario peer --variant h50p50 --out a --dump ./a",
        "track clip --out a --pictures a", "track clip --out a --pictures ./a/",
        "build sphere:0.1 sphere:0.1 --voxel 0.05 --point 0.05 --out a"}) {
    const Answer a = run(both);
    EXPECT_EQ(a.code, 2) << both << a.err;
    EXPECT_EQ(names(), before) << both;
  }
}

TEST_F(Outputs, FullDiskLeavesNoPartialSessionLog) {
  // Limits within the header, within the data, and shortly before the end.
  ASSERT_EQ(run("run scene.yaml --session whole.h5").code, 0);
  const auto blocks_in_all = fs::file_size(in("whole.h5")) / 512;
  for (const std::uintmax_t blocks :
       {std::uintmax_t{1}, blocks_in_all / 4, blocks_in_all / 2, 3 * blocks_in_all / 4, blocks_in_all - 1}) {
    const Answer a = shell(
        "text=$(ulimit -f " + std::to_string(blocks) +
        "; \"$ABSTAND\" run scene.yaml --quiet --session x.h5 2>&1); code=$?; echo \"$text\"; exit $code");
    EXPECT_EQ(a.code, 4) << blocks << a.out;
    EXPECT_TRUE(isOneLine(a.out)) << a.out;
    EXPECT_FALSE(fs::exists(in("x.h5")));
  }
}

TEST_F(Outputs, SrdfKeepsForeignContent) {
  const std::string hand_made = R"(<?xml version="1.0"?>
<!-- made by hand -->
<robot name="pair">
  <group name="arm"><chain base_link="a" tip_link="c"/></group>
  <group_state name="home" group="arm"><joint name="ab" value="0.5"/></group_state>
  <disable_collisions link1="a" link2="b" reason="Default"/>
  <disable_collisions link1="c" link2="a" reason="User"/>
</robot>
)";
  write("pair.srdf", hand_made);
  const Answer a = run("pairs pair.urdf --voxel 0.05 --samples 20 --searches 0 --srdf pair.srdf");
  ASSERT_EQ(a.code, 0) << a.err;
  const std::string text = readFile(in("pair.srdf"));
  for (const char* kept :
       {"<!-- made by hand -->", "<group name=\"arm\"><chain base_link=\"a\" tip_link=\"c\"/></group>",
        "<group_state name=\"home\"", "<disable_collisions link1=\"c\" link2=\"a\" reason=\"User\"/>"})
    EXPECT_NE(text.find(kept), std::string::npos) << text;
  EXPECT_EQ(text.find("Default"), std::string::npos) << text;
  EXPECT_NE(text.find("link1=\"a\" link2=\"b\" reason=\"Adjacent\""), std::string::npos) << text;
  // Once more changes nothing.
  ASSERT_EQ(run("pairs pair.urdf --voxel 0.05 --samples 20 --searches 0 --srdf pair.srdf").code, 0);
  EXPECT_EQ(readFile(in("pair.srdf")), text);
  write("other.srdf", "<robot name=\"other\">\n</robot>\n");
  EXPECT_EQ(run("pairs pair.urdf --voxel 0.05 --samples 20 --searches 0 --srdf other.srdf").code, 3);
  write("none.srdf", "my notes\n");
  EXPECT_EQ(run("pairs pair.urdf --voxel 0.05 --samples 20 --searches 0 --srdf none.srdf").code, 3);
  EXPECT_EQ(readFile(in("none.srdf")), "my notes\n");
}

}  // namespace output_names_test
}  // namespace abstand::testing
