// The contract of the command line: exit codes, one line of error, JSON keys.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "tests/app/ball_and_wall.hpp"
#include "tests/app/program.hpp"

namespace abstand::testing {
namespace cli_test {

TEST_F(Cli, WrongUsageExitsWith2) {
  for (const char* bad :
       {"", "nothing", "fk", "human --height 0", "human --height nan", "human", "human --percentile 0",
        "human --percentile 100", "human --percentile 95 --preset thesis",
        "human --percentile 95 --height 0.4", "build sphere:0.05 --voxel -1", "build sphere:-1",
        "run --mode sideways x.yaml", "bench nosuch", "run --rest some x.yaml"}) {
    const Answer a = run(bad);
    EXPECT_EQ(a.code, 2) << bad << ": " << a.err;
    EXPECT_FALSE(a.err.empty()) << bad;
  }
}

TEST_F(Cli, HumanAcceptsPercentile) {
  const json large = runJson("human --percentile 95 --sex m");
  EXPECT_EQ(large["percentile"], 95.0);
  EXPECT_NEAR(large["height"].get<double>(), 1.870, 1e-9);
  EXPECT_NEAR(large["mass"].get<double>(), 110.7, 1e-9);
  for (const json& part : large["parts"]) {
    EXPECT_GE(part["enclosed_share"].get<double>(), 0.95 - 1e-6) << part["name"];
    EXPECT_GE(part["enclosed_share_all_statures"].get<double>(), 0.95) << part["name"];
  }
  EXPECT_EQ(runJson("human --percentile 95 --height 1.8")["height"], 1.8);
  // The body mass index of the percentile, 31.7 kg/m^2, at the given stature.
  EXPECT_NEAR(runJson("human --percentile 95 --height 1.6 --sex m")["mass"].get<double>(),
              110.7 * std::pow(1.6 / 1.87, 2), 1e-6);
  const json usual = runJson("human --height 1.6285 --sex f");  // the mean woman
  EXPECT_TRUE(usual["percentile"].is_null());
  for (const json& part : usual["parts"])
    EXPECT_NEAR(part["enclosed_share"].get<double>(), 0.5, 1e-6) << part["name"];
}

TEST_F(Cli, HelpShowsAnExample) {
  for (const char* command : {"fk", "build", "human", "skeleton", "run", "serve", "check", "bench"}) {
    const Answer a = run(std::string(command) + " --help");
    EXPECT_EQ(a.code, 0);
    EXPECT_NE(a.out.find("Example:"), std::string::npos) << command;
  }
}

TEST_F(Cli, BadFilesExitWith3AndWriteNothing) {
  const std::string out = (folder_.path() / "out.csv").string();
  for (const auto& arguments :
       {"run " + write("a.yaml", "abstand: 1\nobjekts: []\n") + " --pairs-out " + out,
        "run " + write("b.yaml", "{{{{"), "run " + folder_.path().string(),
        "run " + write("c.yaml", "abstand: 1\nobjects: [{name: a, mesh: missing.stl}]\n"),
        "build " + write("d.stl", "solid nothing"), "fk " + write("e.mech", "chain\n"),
        "skeleton " + write("f.bvh", "HIERARCHY\nROOT a\n{\n"),
        "run " + write("g.yaml", kBallAndWall) + " --poses " + write("g.csv", "t,ball.r00\n0,1\n")}) {
    const Answer a = run(arguments);
    EXPECT_EQ(a.code, 3) << arguments << ": " << a.err;
    EXPECT_NE(a.err.find("error: "), std::string::npos) << a.err;
    EXPECT_LE(std::count(a.err.begin(), a.err.end(), '\n'), 2) << a.err;
  }
  EXPECT_FALSE(exists(std::filesystem::path(out)));
}

TEST_F(Cli, RecordingWithoutPersonExitsWith3AndReport) {
  const std::string file =
      write("stick.bvh",
            "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n"
            "End Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.01\n0 0 0\n");
  const std::string map = (folder_.path() / "own.map").string();
  const Answer a = run("skeleton " + file + " --json --write-map " + map);
  EXPECT_EQ(a.code, 3);
  EXPECT_NE(a.err.find("stick.bvh: error: found no body part with both end joints"), std::string::npos)
      << a.err;
  EXPECT_NE(a.err.find("--write-map own.map"), std::string::npos) << a.err;
  const auto json = nlohmann::json::parse(a.out);
  EXPECT_EQ(json["missing_parts"].size(), 14u);
  EXPECT_TRUE(json["subject"].is_null());
  EXPECT_TRUE(exists(std::filesystem::path(map)));
  EXPECT_EQ(run("skeleton " + file + " --joint-map " + map).code, 3) << "the map is still to be filled in";
  EXPECT_EQ(
      run("run " + write("stick.yaml", "abstand: 1\nhumans: [{name: p, recording: {file: stick.bvh}}]\n"))
          .code,
      3);
}

TEST_F(Cli, SkeletonOptionsWithoutEffectExitWith2) {
  const std::string file = write("p.csv",
                                 "t,pelvis.x,pelvis.y,pelvis.z,neck.x,neck.y,neck.z\n"
                                 "0,0,0,1,0,0,1.5\n0.01,0,0,1,0,0,1.5\n0.02,0,0,1,0,0,1.5\n");
  const std::string out = (folder_.path() / "out.csv").string(), map = write("own.map", "name: own\n");
  for (const auto& [options, said] : std::initializer_list<std::pair<std::string, std::string>>{
           {" --filter one-euro", "filter: found neither --out nor --write"},
           {" --person-speed 3", "--person-speed requires --predict"},
           {" --person-acceleration 3", "--person-acceleration requires --predict"},
           {" --skeleton none.asf", "skeleton: found a recording of the format csv"},
           {" --joint-map " + map + " --marker-set " + map, "joint-map: found a marker set too"}}) {
    const Answer a = run("skeleton " + file + options);
    EXPECT_EQ(a.code, 2) << options;
    EXPECT_NE(a.err.find(said), std::string::npos) << a.err;
  }
  EXPECT_EQ(run("skeleton " + file + " --filter one-euro --out " + out).code, 0);
  EXPECT_EQ(run("skeleton " + file + " --predict --person-speed 3").code, 0);
}

TEST_F(Cli, SceneTypoSuggestsNearestKey) {
  const Answer a = run("run " + write("a.yaml", "abstand: 1\nobjekts: []\n"));
  EXPECT_NE(a.err.find("a.yaml:2:1: error:"), std::string::npos) << a.err;
  EXPECT_NE(a.err.find("objects"), std::string::npos) << a.err;
}

TEST_F(Cli, BuildReproducesThesisSphere) {
  const json s = runJson("build sphere:0.05 --voxel 0.005 --point 0.005 --outer-layers 20")["structures"][0];
  EXPECT_EQ(s["voxels"], json({61, 61, 61}));
  EXPECT_NEAR(s["points"].get<double>(), 1066, 120);
  for (const char* key : {"name", "triangles", "watertight", "surface_voxels", "solid_voxels", "levels",
                          "memory_bytes", "build_ms", "error_bound"})
    EXPECT_TRUE(s.contains(key)) << key;
}

TEST_F(Cli, BuildReportsLeaksAndThinWalls) {
  const json r = runJson("build cuboid:0.2,0.1,0.004")["structures"][0]["report"];
  EXPECT_EQ(r["leaks"], json({{"open_edges", 0}, {"non_manifold_edges", 0}, {"flipped_edges", 0}}));
  EXPECT_EQ(r["inside_doubtful"], false);
  EXPECT_EQ(r["thin_walls"]["below"], 0.01);
  EXPECT_NEAR(r["thin_walls"]["thinnest"].get<double>(), 0.004, 1e-6);
  EXPECT_GT(r["thin_walls"]["share"].get<double>(), 0.9);
  EXPECT_EQ(r["thin_walls"]["where"].size(), 3u);
  EXPECT_EQ(r["convex_hull"]["volume_ratio"], 1.0);
  const json ball = runJson("build sphere:0.05")["structures"][0]["report"];
  EXPECT_TRUE(ball["thin_walls"]["thinnest"].is_null());
}

TEST_F(Cli, BuildExplainPredictsWithoutBuilding) {
  const auto cache = folder_.path() / "cache";
  ::setenv("ABSTAND_CACHE", cache.c_str(), 1);
  const json j = runJson("build sphere:0.05 cuboid:9,9,9 --voxel 0.003 --point 0.004 --explain");
  EXPECT_FALSE(exists(cache));
  ASSERT_EQ(j["explained"].size(), 2u);
  const json& rows = j["explained"][0]["rows"];
  ASSERT_EQ(rows.size(), 6u);
  int asked = 0;
  for (const json& row : rows) {
    for (const char* key : {"error_bound", "memory_bytes", "points", "build_ms", "distance_us", "contact_us"})
      EXPECT_GT(row[key].get<double>(), 0.0) << key;
    if (row["asked"] == true) {
      ++asked;
      EXPECT_EQ(row["voxel"], 0.003);
      EXPECT_EQ(row["point"], 0.004);
    }
  }
  EXPECT_EQ(asked, 1);
  // Nine metres in millimetres are too many voxels.
  EXPECT_TRUE(j["explained"][1]["rows"].back()["refused"].is_string());
  for (const char* key : {"error_bound", "memory_bytes", "points", "build_ms", "distance_us", "contact_us"})
    EXPECT_TRUE(j["rules"].contains(key)) << key;
  const Answer text = run("build sphere:0.05 --explain");
  EXPECT_NE(text.out.find("*   5.00   5.00"), std::string::npos) << text.out;
}

// The same numbers from the cache; damage is noticed and mended; --no-cache leaves it alone.
TEST_F(Cli, BuildCachesStructuresAndRebuildsDamagedOnes) {
  const auto cache = folder_.path() / "cache";
  ::setenv("ABSTAND_CACHE", cache.c_str(), 1);
  const auto build = [&](const std::string& more) {
    return runJson("build sphere:0.05 --voxel 0.01 --point 0.01 " + more)["structures"][0];
  };
  json first = build("--no-cache");
  EXPECT_FALSE(exists(cache));
  EXPECT_EQ(first["cached"], false);
  EXPECT_EQ(build("")["cached"], false);
  json second = build("");
  EXPECT_EQ(second["cached"], true);
  for (const char* changes : {"cached", "made_ms", "build_ms"}) {
    first.erase(changes);
    second.erase(changes);
  }
  EXPECT_EQ(first, second);

  const auto file = std::filesystem::directory_iterator(cache)->path();
  std::string bytes = readFile(file);
  bytes[bytes.size() / 2] ^= 1;
  folder_.write("cache/" + file.filename().string(), bytes);
  const Answer damaged = run("build sphere:0.05 --voxel 0.01 --point 0.01 --json");
  EXPECT_EQ(damaged.code, 0);
  EXPECT_NE(damaged.err.find("warning: " + file.string() + " is damaged"), std::string::npos) << damaged.err;
  EXPECT_EQ(json::parse(damaged.out)["structures"][0]["cached"], false);
  EXPECT_EQ(build("")["cached"], true);
}

TEST_F(Cli, RunFromCacheGivesSameResults) {
  ::setenv("ABSTAND_CACHE", (folder_.path() / "cache").c_str(), 1);
  const std::string scene = write("s.yaml", kBallAndWall), poses = write("m.csv", ballPoses(-0.01));
  std::string csv[2];
  for (int i = 0; i < 2; ++i) {
    const std::string pairs = (folder_.path() / "p.csv").string();
    const json j = runJson("run " + scene + " --poses " + poses + " --pairs-out " + pairs);
    EXPECT_EQ(j["cached_structures"], i == 0 ? 0 : 2);
    csv[i] = readFile(pairs);
  }
  EXPECT_EQ(csv[0], csv[1]);
}

TEST_F(Cli, InterruptedBuildLeavesNoFiles) {
  const auto cache = folder_.path() / "cache";
  ::setenv("ABSTAND_CACHE", cache.c_str(), 1);
  // Without the signal this would take minutes.
  const auto err = folder_.path() / "err";
  const std::string command = "timeout --preserve-status -s INT 2 '" ABSTAND_PROGRAM
                              "' build sphere:0.5 --voxel 0.0015 --point 0.002 2>'" +
                              err.string() + "'";
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(readFile(err), "abstand: interrupted\n");
  EXPECT_FALSE(exists(cache));
}

TEST_F(Cli, BuildWithOneBadInputExitsWith5) {
  const Answer a = run("build sphere:0.02 missing.stl --json");
  EXPECT_EQ(a.code, 5);
  const json j = json::parse(a.out);
  EXPECT_EQ(j["structures"].size(), 1u);
  EXPECT_EQ(j["failed"][0]["name"], "missing.stl");
}

TEST_F(Cli, CyclesOutWritesWorkOfEachCycle) {
  std::string text = kBallAndWall;
  text.replace(text.find("{voxel"), 1, "{margin: 0.03, ");
  const std::string scene = write("s.yaml", text), poses = write("m.csv", ballPoses(-0.01));
  const std::string file = (folder_.path() / "c.csv").string();
  long contacts = 0;
  const auto rows = [&](const std::string& options) {
    const json j = runJson("run " + scene + " --poses " + poses + " --cycles-out " + file + options);
    std::istringstream in(readFile(file));
    std::vector<std::array<double, 4>> found;
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line, "cycle,t,work_us,colliding_pairs");
    double longest = 0.0;
    while (std::getline(in, line)) {
      found.emplace_back();
      char comma = 0;
      auto& [cycle, t, work, colliding] = found.back();
      std::istringstream(line) >> cycle >> comma >> t >> comma >> work >> comma >> colliding;
      longest = std::max(longest, work);
    }
    if (options.empty()) {
      EXPECT_NEAR(longest, j["cycle_us"]["max"].get<double>(), 0.001) << "rounded to ns";
      contacts = j["contacts"].get<long>();
    }
    return found;
  };
  const auto all = rows("");
  ASSERT_EQ(all.size(), 101u);
  long colliding = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i][0], static_cast<double>(i));
    EXPECT_GT(all[i][2], 0.0);
    colliding += static_cast<long>(all[i][3]);
  }
  EXPECT_EQ(colliding, contacts);
  EXPECT_GT(colliding, 0);
  EXPECT_LT(colliding, 101);
  const auto some = rows(" --cycles-every 10");
  ASSERT_EQ(some.size(), 11u);
  EXPECT_EQ(some[3][0], 30.0);
  EXPECT_EQ(some[3][1], all[30][1]);
}

TEST_F(Cli, RunAndCheckMatchKnownApproach) {
  const std::string scene = write("s.yaml", kBallAndWall), poses = write("m.csv", ballPoses(0.12));
  const std::string pairs = (folder_.path() / "p.csv").string();
  const json j = runJson("run " + scene + " --poses " + poses + " --pairs-out " + pairs);
  EXPECT_EQ(j["frames"], 101);
  EXPECT_EQ(j["pairs"], 1);
  EXPECT_NEAR(j["min_distance"]["value"].get<double>(), 0.12, 0.00125);
  for (const char* key : {"objects", "cycle_us", "overruns", "contacts", "peak_force", "slowest_pair",
                          "build_ms", "memory_bytes", "schema_version", "version"})
    EXPECT_TRUE(j.contains(key)) << key;
  const std::string csv = readFile(pairs);
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "t,a,b,distance,bound,fx,fy,fz,tx,ty,tz,contacts,ax,ay,az,bx,by,bz,reach");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 102);
  EXPECT_EQ(run("check " + scene + " --poses " + poses + " --min-distance 0.10").code, 0);
  const std::string junit = (folder_.path() / "j.xml").string(), html = (folder_.path() / "r.html").string();
  const Answer broken = run("check " + scene + " --poses " + poses + " --min-distance 0.15 --json --junit " +
                            junit + " --report " + html);
  EXPECT_EQ(broken.code, 1);
  const json violation = json::parse(broken.out)["violations"][0];
  EXPECT_EQ(violation["a"], "wall");
  EXPECT_NEAR(violation["start"].get<double>(), 0.85,
              0.011);  // the frame at which the ball is first below 0.15 m
  EXPECT_NEAR(violation["end"].get<double>(), 1.0, 1e-9);
  EXPECT_NE(readFile(junit).find("failures=\"1\""), std::string::npos);
  EXPECT_NE(readFile(html).find("Not passed"), std::string::npos);
}

TEST_F(Cli, CheckUsesMarginsFileAsLimits) {
  const std::string scene = write("s.yaml", kBallAndWall), poses = write("m.csv", ballPoses(0.12));
  const std::string margins = write("margins.yaml", "ball: 0.1  # the person\nwall: 0.05\n");
  EXPECT_EQ(run("check " + scene + " --poses " + poses + " --min-distance 0.10 --margins " + margins).code,
            1);
  const Answer bad =
      run("check " + scene + " --min-distance 0.10 --margins " + write("bad.yaml", "bal: 0.1\n"));
  EXPECT_EQ(bad.code, 3);
  EXPECT_NE(bad.err.find("did you mean 'ball'"), std::string::npos) << bad.err;
}

TEST_F(Cli, LostTrackingIsReportedAsStale) {
  std::string csv = ballPoses(0.12);
  csv.replace(csv.rfind("1,0,0,0.17"), 1, "nan");
  const json j = runJson("run " + write("s.yaml", kBallAndWall) + " --poses " + write("m.csv", csv));
  EXPECT_EQ(j["stale"], json({"ball"}));
  EXPECT_FALSE(j["min_distance"]["value"].is_null());
}

TEST_F(Cli, RunReportsCullingAndSpeedBoundBreaches) {
  const std::string poses = " --poses " + write("m.csv", ballPoses(0.12));
  std::string text = kBallAndWall;
  text.replace(text.find("voxel: 0.005, point: 0.005"), 26, "voxel: 0.02, point: 0.02");
  const std::string scene = write("s.yaml", text);
  const json plain = runJson("run " + scene + poses)["skipping"];
  EXPECT_EQ(plain["checked"], 89);  // the last 12 are one
  EXPECT_EQ(plain["rested"], 0);
  const json j = runJson("run " + scene + poses + " --rest 0.3");
  EXPECT_EQ(j["skipping"]["checked"].get<int>() + j["skipping"]["rested"].get<int>(), 89);
  EXPECT_GT(j["skipping"]["rested"], 10);
  EXPECT_GE(j["min_distance"]["value"].get<double>(), 0.12 - 0.005);
  EXPECT_EQ(run("run " + scene + poses + " --rest 1.5").code, 2);
  EXPECT_EQ(run("run " + scene + poses + " --horizon -1").code, 2);
  EXPECT_EQ(run("run " + scene + poses + " --budget -1").code, 2);

  // The same scene with leave to rest and a bound that the ball breaks: the gate queries all the same.
  text.replace(text.find("name: ball,"), 11, "name: ball, max_speed: 1.0e-3,");
  const std::string slow = write("slow.yaml", text + "skipping: {rest: 0.3, budget: 100}\n");
  const json s = runJson("run " + slow + poses)["skipping"];
  EXPECT_GT(s["rested"], 10);
  EXPECT_EQ(s["breach_count"], 1);
  EXPECT_EQ(s["breaches"][0]["object"], "ball");
  EXPECT_GT(s["breaches"][0]["speed"], 1e-3);
  EXPECT_EQ(s["breaches"][0]["bound"], 1e-3);
  EXPECT_EQ(run("check " + slow + poses + " --min-distance 0.1199").code,
            run("check " + scene + poses + " --min-distance 0.1199").code);
}

TEST_F(Cli, DryRunOutputReadsBack) {
  const Answer a = run("check --dry-run " + write("s.yaml", kBallAndWall));
  EXPECT_EQ(a.code, 0);
  const Answer again = run("check --dry-run " + write("again.yaml", a.out));
  EXPECT_EQ(again.out, a.out);
}

TEST_F(Cli, VerifyChecksEngineAndWritesReport) {
  const std::string page = (folder_.path() / "v.html").string();
  const json j = runJson("verify --only 'third law' --poses 1000 --report " + page);
  EXPECT_TRUE(j["passed"]);
  EXPECT_EQ(j["poses"], 1000);
  EXPECT_EQ(j["checks"][0]["name"], "third_law");
  EXPECT_EQ(j["checks"][0]["breaches"], 0);
  EXPECT_NE(readFile(page).find("third_law"), std::string::npos);
  EXPECT_EQ(run("verify --only nothing").code, 2);
  EXPECT_EQ(run("verify --poses 0").code, 2);
  EXPECT_EQ(run("verify --only 'third law' --poses 100 --report /nowhere/v.html").code, 2);
}

}  // namespace cli_test
}  // namespace abstand::testing
