// Frames that start from the last answer: blocks, tolerance, and the way back to cold starts.
#include <cmath>
#include <sstream>

#include "app/run/run_scene.hpp"
#include "tests/app/ball_and_wall.hpp"
#include "tests/app/program.hpp"

namespace abstand::testing {
namespace warm_start_test {

const std::string kScene = "data/scenes/hug_boxing.yaml --rate 10";  // 307 frames: blocks 0, 128 and 256

class WarmStart : public Cli {
 protected:
  WarmStart() { ::setenv("ABSTAND_CACHE", out("cache").c_str(), 1); }
  std::string out(const std::string& name) { return (folder_.path() / name).string(); }
  /// The rows of the CSV that a run writes, without the header.
  std::vector<std::string> rows(const std::string& arguments, const std::string& option = "--pairs-out") {
    const Answer a = run("run " + kScene + " " + arguments + " " + option + " " + out("rows.csv"));
    EXPECT_EQ(a.code, 0) << a.err;
    std::istringstream text(readFile(out("rows.csv"), 1 << 28));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    lines.erase(lines.begin());
    return lines;
  }
  static double column(const std::string& row, int index) {
    std::istringstream cells(row);
    std::string cell;
    for (int i = 0; i <= index; ++i) std::getline(cells, cell, ',');
    return std::stod(cell);
  }
};

TEST_F(WarmStart, RunFromBlockStartIsBitIdenticalToFullRun) {
  for (const char* option : {"--pairs-out", "--objects-out"}) {
    const std::vector<std::string> whole = rows("--threads 1", option);
    std::vector<double> times;
    for (const auto& row : whole)
      if (times.empty() || column(row, 0) != times.back()) times.push_back(column(row, 0));
    ASSERT_GT(times.size(), 2 * run::kColdStart);
    for (const std::size_t block : {std::size_t{1}, std::size_t{2}}) {
      const double start = times[block * run::kColdStart];
      const std::vector<std::string> part =
          rows("--threads 3 --start " + std::to_string(start - 0.001), option);
      ASSERT_GT(whole.size(), part.size());
      EXPECT_TRUE(
          std::equal(part.begin(), part.end(), whole.end() - static_cast<std::ptrdiff_t>(part.size())))
          << option << " from " << start;
      EXPECT_EQ(column(part.front(), 0), start);
    }
  }
}

TEST_F(WarmStart, ColdResultsDependOnPosesAlone) {
  const std::vector<std::string> whole = rows("--cold"), part = rows("--cold --start 7.7");
  ASSERT_GT(whole.size(), part.size());
  EXPECT_TRUE(std::equal(part.begin(), part.end(), whole.end() - static_cast<std::ptrdiff_t>(part.size())));
}

/// Either may miss the nearest points of bodies far apart, as the far field is coarse; the bound covers it.
TEST_F(WarmStart, DistancesMatchColdStartsWithinTolerance) {
  constexpr double kTolerance = 0.002, kBetweenPoints = 1e-3;  // m, at corners of bodies that are near
  constexpr double kMissed = 1e-3;                             // share of the rows
  const std::vector<std::string> cold = rows("--cold"), warm = rows("");
  ASSERT_EQ(cold.size(), warm.size());
  std::size_t far = 0, beyond = 0, different = 0;
  for (std::size_t i = 0; i < cold.size(); ++i) {
    const double c = column(cold[i], 3), c_bound = column(cold[i], 4), w = column(warm[i], 3),
                 w_bound = column(warm[i], 4);
    ASSERT_LE(w - w_bound, c + 1e-9) << warm[i];
    ASSERT_LE(c - c_bound, w + 1e-9) << cold[i];
    different += c != w;
    if (c <= query::kRelativeFrom) {
      ASSERT_LE(w, c + kBetweenPoints) << warm[i];
      continue;
    }
    ++far;
    beyond += w > (1.0 + kTolerance) * c;
  }
  EXPECT_GT(far, 50'000u);
  EXPECT_GT(different, 1000u);
  EXPECT_LE(static_cast<double>(beyond), kMissed * static_cast<double>(far));
}

TEST_F(WarmStart, IsReportedAndCanBeSwitchedOff) {
  const std::string part = " --end 0.5";
  const json warm = runJson("run " + kScene + part)["warm_start"];
  EXPECT_EQ(warm["block_frames"], run::kColdStart);
  EXPECT_EQ(warm["far_tolerance"], 0.002);
  EXPECT_EQ(warm["far_from_m"], query::kRelativeFrom);
  EXPECT_EQ(runJson("run " + kScene + part + " --tolerance 0.01")["warm_start"]["far_tolerance"], 0.01);
  EXPECT_TRUE(runJson("run " + kScene + part + " --cold")["warm_start"].is_null());
  EXPECT_NE(run("run " + kScene + part).out.find("distances beyond 0.1 m are at most 0.2 % above"),
            std::string::npos);
  EXPECT_EQ(run("run " + kScene + part + " --cold").out.find("warm start"), std::string::npos);
  EXPECT_EQ(run("run " + kScene + part + " --cold --remember").code, 2);
  EXPECT_EQ(run("run " + kScene + part + " --tolerance 0.2").code, 2);
}

/// Limits between two frames' smallest distances, and just about them.
TEST_F(WarmStart, CheckDecidesAsWithColdStarts) {
  const std::string scene = write("s.yaml", kBallAndWall), poses = write("m.csv", ballPoses(0.12));
  const double least = runJson("run " + scene + " --poses " + poses + " --cold")["min_distance"]["value"];
  for (const double share : {0.99, 0.999, 0.9999, 1.0001, 1.001, 1.01}) {
    std::ostringstream limit;
    limit.precision(17);
    limit << share * least;
    const std::string command = "check " + scene + " --poses " + poses + " --min-distance " + limit.str();
    const json warm = json::parse(run(command + " --json --tolerance 0.1").out),
               cold = json::parse(run(command + " --json --cold").out);
    EXPECT_EQ(warm["passed"], cold["passed"]) << share;
    EXPECT_EQ(warm["violations"].size(), cold["violations"].size()) << share;
    EXPECT_EQ(warm["unproven"].size(), cold["unproven"].size()) << share;
    EXPECT_TRUE(cold["warm_start"].is_null());
    EXPECT_FALSE(warm["warm_start"].is_null());
  }
}

}  // namespace warm_start_test
}  // namespace abstand::testing
