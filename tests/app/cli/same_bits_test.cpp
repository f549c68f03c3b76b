// Outputs depend on inputs alone: not on the machine's vector units, not on the number of threads, not on the
// time.
#include <algorithm>

#include "tests/app/program.hpp"

namespace abstand::testing {
namespace same_bits_test {

struct ShippedScene {
  const char* name;
  const char* range;
};
constexpr ShippedScene kScenes[] = {
    {"arm6", "--end 0.05"},          {"hug_alone", "--end 0.03"}, {"hug_avoid", "--end 0.1"},
    {"hug_boxing", "--end 0.05"},    {"hug_reach", "--end 0.05"}, {"humanoid", "--end 0.01"},
    {"humanoid_self", "--end 0.01"}, {"rail7", "--end 0.05"},     {"rods", "--end 1"},
    {"spheres", "--end 0.5"},        {"two_people", "--end 0.03"}};

/// Each number of threads, and each way of searching, so each must agree with each. Structures are built once
/// with and once without vector units, as building uses them too; one test, so that scenes share them.
TEST_F(Cli, RunIsBitIdenticalForAnySimdAndThreadCount) {
  struct Setting {
    const char* simd;
    int threads;
  };
  for (const ShippedScene& scene : kScenes) {
    std::string first[4];
    for (const auto& [simd, threads] :
         {Setting{"on", 1}, Setting{"off", 2}, Setting{"on", 3}, Setting{"off", 7}, Setting{"on", 16}}) {
      SCOPED_TRACE(std::string(scene.name) + ", ABSTAND_SIMD=" + simd + ", threads " +
                   std::to_string(threads));
      ::setenv("ABSTAND_SIMD", simd, 1);
      ::setenv("ABSTAND_CACHE", (folder_.path() / simd).c_str(), 1);
      const auto file = [&](const char* name) { return (folder_.path() / name).string(); };
      const Answer answer =
          run(std::string("run data/scenes/") + scene.name + ".yaml " + scene.range + " --threads " +
              std::to_string(threads) + " --pairs-out " + file("p.csv") + " --objects-out " + file("o.csv") +
              " --joints-out " + file("j.csv") + " --session " + file("s.h5"));
      ::unsetenv("ABSTAND_SIMD");
      ASSERT_EQ(answer.code, 0) << answer.err;
      const char* names[] = {"p.csv", "o.csv", "j.csv", "s.h5"};
      for (int i = 0; i < 4; ++i) {
        const std::string text = readFile(file(names[i]), 1 << 28, true);
        if (first[i].empty()) first[i] = text;
        const auto at = std::mismatch(text.begin(), text.end(), first[i].begin(), first[i].end()).first;
        EXPECT_TRUE(text == first[i]) << names[i] << " differs from byte " << at - text.begin() << " on";
      }
    }
    EXPECT_GT(std::count(first[0].begin(), first[0].end(), '\n'), 2) << scene.name;
  }
}

TEST_F(Cli, TrackIsBitIdenticalForAnySimd) {
  const std::string clip = (folder_.path() / "clip").string();
  runJson("render-depth --recording " + projectFile("data/scenes/hug_reach.bvh").string() + " --out " + clip +
          " --width 320 --end 0.5");
  std::string first;
  for (const char* simd : {"on", "off"}) {
    ::setenv("ABSTAND_SIMD", simd, 1);
    const std::string out = (folder_.path() / simd).string() + ".csv";
    const Answer answer = run("track " + clip + " --out " + out);
    ::unsetenv("ABSTAND_SIMD");
    ASSERT_EQ(answer.code, 0) << answer.err;
    const std::string text = readFile(out, 1 << 28, true);
    if (first.empty()) first = text;
    EXPECT_TRUE(text == first);
  }
  EXPECT_GT(std::count(first.begin(), first.end(), '\n'), 10);
}

}  // namespace same_bits_test
}  // namespace abstand::testing
