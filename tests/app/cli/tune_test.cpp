// abstand tune and merge as a user runs them.
#include <csignal>
#include <fstream>
#include <thread>

#include "tests/app/program.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::testing {
namespace {

namespace fs = std::filesystem;

/// Seven people who come at a ball on a rail, each at a speed of their own.
class Tune : public Cli {
 protected:
  static constexpr int kPeople = 7;
  Tune() {
    ::setenv("ABSTAND_CACHE", (folder_.path() / "cache").c_str(), 1);
    for (int i = 0; i < kPeople; ++i) {
      writeSlide(folder_, {.robot = 0.5, .person = 0.1 * i, .seconds = 2.5}, std::to_string(i));
      recordings_ += " " + (folder_.path() / ("person" + std::to_string(i) + ".csv")).string();
    }
    scene_ = (folder_.path() / "slide.yaml").string();
  }
  std::string out(const std::string& name) const { return (folder_.path() / name).string(); }
  std::size_t results(const std::string& folder) const {
    std::error_code ec;
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(out(folder) + "/results", ec))
      count += entry.path().extension() == ".h5";
    return count;
  }
  /// Without what differs from place to place.
  static std::string answerOf(json j) {
    j.erase("results");
    return j.dump(1);
  }

  std::string scene_, recordings_;
};

TEST_F(Tune, AnswersTheSameInAnyNumberOfPartsAndProcesses) {
  const std::string common = " --margins 0:0.6:0.1 --reaction-time 0.2";
  const json whole = runJson("tune " + scene_ + " --recordings" + recordings_ + common);
  EXPECT_EQ(whole["recordings"], kPeople);
  const std::string expected = answerOf(whole);
  std::size_t recordings = 0;
  for (const std::string shard : {"1/3", "2/3", "3/3"})
    recordings +=
        runJson("tune " + scene_ + " --recordings" + recordings_ + common + " --shard " + shard)["recordings"]
            .get<std::size_t>();
  EXPECT_EQ(recordings, kPeople) << "parts without a folder are answered by themselves";
  for (const int shards : {1, 2, 7}) {
    const std::string folder = "shards" + std::to_string(shards);
    for (int i = shards; i >= 1; --i)
      EXPECT_EQ(run("tune " + scene_ + " --recordings" + recordings_ + common + " --out " + out(folder) +
                    " --jobs " + std::to_string(shards) + " --shard " + std::to_string(i) + "/" +
                    std::to_string(shards))
                    .code,
                0);
    EXPECT_EQ(results(folder), kPeople);
    EXPECT_EQ(answerOf(runJson("merge " + out(folder) + " --margins 0:0.6:0.1")), expected) << shards;
  }
}

TEST_F(Tune, ProposesWhatTheFastestPersonNeeds) {
  const json j =
      runJson("tune " + scene_ + " --recordings" + recordings_ + " --reaction-time 0.2 --deceleration 1000");
  const json* torso = nullptr;
  for (const json& p : j["proposed"])
    if (p["part"] == "torso") torso = &p;
  ASSERT_TRUE(torso);
  // 0.5 m/s of the ball and 0.6 m/s of the person for 0.2 s, and a frame of 10 ms at most.
  EXPECT_GT((*torso)["margin"], 0.22);
  EXPECT_LT((*torso)["margin"], 0.22 + 0.011 + 0.002);
  EXPECT_NE((*torso)["decided_by"]["recording"].get<std::string>().find("person6.csv"), std::string::npos);
  EXPECT_EQ((*torso)["decided_by"]["link"], "ball");
  EXPECT_EQ((*torso)["confidence"]["recordings"], kPeople);
  EXPECT_NEAR((*torso)["confidence"]["unseen_share"], 1.0 - std::pow(0.05, 1.0 / kPeople), 1e-12);
}

TEST_F(Tune, GoesOnWhereItWasKilledAndMakesWhatIsDamagedAgain) {
  const std::string command = "tune " + scene_ + " --recordings" + recordings_ + " --out " + out("results");
  const std::string expected = answerOf(runJson("tune " + scene_ + " --recordings" + recordings_));
  EXPECT_EQ(
      run("tune " + scene_ + " --recordings" + recordings_ + " --out " + out("results") + " --shard 1/2")
          .code,
      0);
  const std::size_t first = results("results");
  EXPECT_EQ(first, 4u);
  // One of them is cut short, as by a machine that lost its power.
  fs::path damaged;
  for (const auto& entry : fs::directory_iterator(out("results") + "/results")) damaged = entry.path();
  fs::resize_file(damaged, fs::file_size(damaged) / 2);
  const Answer cut = run("merge " + out("results"));
  EXPECT_EQ(cut.code, 3);
  EXPECT_NE(cut.err.find(damaged.filename().string()), std::string::npos) << cut.err;
  EXPECT_NE(cut.err.find("checksum"), std::string::npos) << cut.err;
  const json again = runJson(command);
  EXPECT_EQ(again["results"]["kept"], first - 1);
  EXPECT_EQ(again["results"]["made"], kPeople - (first - 1));
  EXPECT_EQ(answerOf(again), expected);
}

TEST_F(Tune, KilledInTheMiddleLeavesNoHalfResult) {
  const std::string program = "'" ABSTAND_PROGRAM "' tune " + scene_ + " --recordings" + recordings_ +
                              " --out " + out("killed") + " --quiet";
  // -9 in the middle of its work, wherever that is.
  const std::string command = "timeout -s KILL 0.3 sh -c \"" + program + "\" >/dev/null 2>&1; exit 0";
  EXPECT_EQ(std::system(command.c_str()), 0);
  // Copies of the killed process may live a moment longer.
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const json done = runJson("tune " + scene_ + " --recordings" + recordings_ + " --out " + out("killed"));
  EXPECT_EQ(done["results"]["made"].get<int>() + done["results"]["kept"].get<int>(), kPeople);
  EXPECT_EQ(answerOf(done), answerOf(runJson("tune " + scene_ + " --recordings" + recordings_)));
}

TEST_F(Tune, ABadRecordingStopsNoOther) {
  write("bad.csv", "no recording\n");
  for (const std::string more : {"", " --jobs 2"}) {
    const Answer a =
        run("tune " + scene_ + " --recordings" + recordings_ + " " + out("bad.csv") + " --json" + more);
    EXPECT_EQ(a.code, 5) << a.err;
    const json j = json::parse(a.out, nullptr, false);
    EXPECT_EQ(j["recordings"], kPeople);
    ASSERT_EQ(j["failed"].size(), 1u);
    EXPECT_NE(j["failed"][0]["recording"].get<std::string>().find("bad.csv"), std::string::npos);
    EXPECT_NE(a.err.find("bad.csv"), std::string::npos);
  }
  const Answer alone = run("tune " + scene_ + " --recordings " + out("bad.csv"));
  EXPECT_EQ(alone.code, 3);
}

TEST_F(Tune, RunsAPlan) {
  write("plan.yaml",
        "abstand_plan: 1\nscenes: [slide.yaml]\nrecordings: [person1.csv, person2.csv]\n"
        "people: [{height: 1.6, sex: f}, {height: 1.9}]\nspeeds: [1, 1.5]\n");
  const json j = runJson("tune " + out("plan.yaml") + " --jobs 2");
  EXPECT_EQ(j["recordings"], 8);
  EXPECT_NE(j["inputs"][0]["recording"].get<std::string>().find("height 1.6, f"), std::string::npos)
      << j["inputs"][0];
}

TEST_F(Tune, APlanHasPeopleOfAPercentile) {
  write("plan.yaml",
        "abstand_plan: 1\nscenes: [slide.yaml]\nrecordings: [person1.csv]\n"
        "people: [{percentile: 95, sex: m}, {percentile: 5}]\n");
  const json j = runJson("tune " + out("plan.yaml"));
  EXPECT_EQ(j["recordings"], 2);
  std::string names;
  for (const json& input : j["inputs"]) names += input["recording"].get<std::string>() + "\n";
  EXPECT_NE(names.find(", percentile 95, m\n"), std::string::npos) << names;
  EXPECT_NE(names.find(", percentile 5\n"), std::string::npos) << names;
}

TEST_F(Tune, ExportsAndComparesResults) {
  EXPECT_EQ(
      run("tune " + scene_ + " --recordings" + recordings_ + " --out " + out("slow") + " --reaction-time 0.3")
          .code,
      0);
  const json fast = runJson("tune " + scene_ + " --recordings" + recordings_ + " --out " + out("fast") +
                            " --reaction-time 0.1");
  const json diff = runJson("diff " + out("slow") + " " + out("fast"));
  EXPECT_EQ(diff["recordings"], json({kPeople, kPeople}));
  bool torso = false;
  for (const json& p : diff["proposed"])
    if (p["part"] == "torso") {
      torso = true;
      EXPECT_GT(p["before"], p["after"]) << "a slower reaction needs more";
    }
  EXPECT_TRUE(torso);
  const json written = runJson("export " + out("fast") + " --csv " + out("table.csv"));
  EXPECT_EQ(written["rows"], fast["frames"].get<int>() * 14);
  std::ifstream in(out("table.csv"));
  std::string text;
  std::getline(in, text);
  EXPECT_EQ(text, "recording,t,part,link,distance,bound,uncertainty,clearance,robot_speed,person_speed");
  int rows = 0;
  double least = 1e9;
  while (std::getline(in, text)) {
    ++rows;
    const auto parts = std::count(text.begin(), text.end(), ',');
    EXPECT_EQ(parts, 9) << text;
    std::istringstream fields(text);
    std::string value;
    for (int i = 0; i < 8; ++i) std::getline(fields, value, ',');
    least = std::min(least, std::stod(value));
  }
  EXPECT_EQ(rows, written["rows"]);
  EXPECT_LT(least, 0.0);
}

TEST_F(Tune, WritesAReport) {
  EXPECT_EQ(run("tune " + scene_ + " --recordings" + recordings_ + " --report " + out("report.html")).code,
            0);
  const std::string html = readFile(out("report.html"));
  for (const char* said : {"Proposed margins", "What margins cost", "Nearest approaches", "What was assumed",
                           "Inputs", "Signature", "hardest closing before", "stops per minute", "person6.csv",
                           "no certified safety function", "ISO/TS 15066:2016", "class=\"moment\""})
    EXPECT_NE(html.find(said), std::string::npos) << said;
  for (const char* outside : {"http://", "https://", "<script", "src="})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
}

TEST_F(Tune, SaysWhereAPlanIsWrong) {
  const auto expect = [&](const std::string& plan, const std::string& said) {
    write("plan.yaml", plan);
    const Answer a = run("tune " + out("plan.yaml"));
    EXPECT_EQ(a.code, 3) << plan;
    EXPECT_NE(a.err.find(said), std::string::npos) << a.err;
    EXPECT_NE(a.err.find("plan.yaml:"), std::string::npos) << a.err;
  };
  expect("abstand_plan: 1\nscenes: [slide.yaml]\nrecordings: [gone.csv]\n", "gone.csv");
  expect("abstand_plan: 2\nscenes: [slide.yaml]\n", "format version 1");
  expect("abstand_plan: 1\nscenes: []\nspeeds: [1, 2]\n", "plan.yaml:2:1: error: found no scene");
  expect("abstand_plan: 1\nscenes: [slide.yaml]\nrecording: [person1.csv]\n", "recordings");
  expect("abstand_plan: 1\nscenes: [slide.yaml]\nspeeds: [0]\n", "speeds");
  expect("abstand_plan: 1\nscenes: [slide.yaml]\npeople: [{percentile: 100}]\n", "from 1 to 99 %");
  expect("abstand_plan: 1\nscenes: [slide.yaml]\npeople: [{percentile: 95, mass: 20}]\n",
         "plan.yaml:3:23: error: the body mass index");
  expect("abstand_plan: 1\nscenes: [slide.yaml]\nrecordings: [person1.csv, person1.csv]\n", "twice");
}

TEST_F(Tune, TellsTheEventsThatItCounts) {
  const std::string folder = out("events");
  const json tuned = runJson("tune " + scene_ + " --recordings" + recordings_ + " --out " + folder +
                             " --margins 0.2:0.4:0.2");
  for (const double margin : {0.2, 0.4}) {
    const std::string at = "events " + folder + " --margin " + std::to_string(margin);
    const json all = runJson(at);
    EXPECT_EQ(all["recordings"], kPeople);
    bool some = false;
    for (const json& row : tuned["margins"]) {
      if (row["part"] == "whole_body" || std::abs(row["margin"].get<double>() - margin) > 1e-9) continue;
      int stops = 0, false_stops = 0, missed = 0;
      for (const json& e : all["events"]) {
        if (e["part"] != row["part"]) continue;
        stops += e["kind"] == "intrusion";
        false_stops += e["false_stop"].get<bool>();
        missed += e["missed_stop"].get<bool>();
        EXPECT_LE(e["t0"], e["t_nearest"]);
        EXPECT_LE(e["t_nearest"], e["t1"]);
        EXPECT_LT(e["min_clearance"], margin);
      }
      EXPECT_EQ(row["stops"], stops) << row;
      EXPECT_EQ(row["false_stops"], false_stops) << row;
      EXPECT_EQ(row["missed_stops"], missed) << row;
      some = some || stops > 0;
    }
    EXPECT_TRUE(some) << margin;
    EXPECT_EQ(run(at + " --fail-on intrusion").code, 1);
    bool any_missed = false;
    for (const json& e : all["events"]) any_missed = any_missed || e["missed_stop"].get<bool>();
    EXPECT_EQ(run(at + " --fail-on missed").code, any_missed ? 1 : 0);
  }
  for (const double margin : {0.0, 0.4}) {
    const std::string at = std::to_string(margin);
    const json report = runJson("report " + folder + " --html " + out("page.html") + " --junit " +
                                out("junit.xml") + " --margin " + at);
    std::set<std::string> not_passed;
    const json events = runJson("events " + folder + " --margin " + at);
    for (const json& e : events["events"])
      if (e["missed_stop"].get<bool>()) not_passed.insert(e["recording"]);
    EXPECT_EQ(report["failed"], not_passed.size()) << margin;
    const std::string xml = readFile(out("junit.xml"));
    EXPECT_NE(xml.find("tests=\"" + std::to_string(kPeople) + "\" failures=\"" +
                       std::to_string(not_passed.size()) + "\""),
              std::string::npos)
        << xml;
    EXPECT_GT(std::filesystem::file_size(out("page.html")), 1000u);
  }
  EXPECT_EQ(run("report " + folder).code, 2);
  EXPECT_EQ(run("report " + folder + " --junit " + out("junit.xml")).code, 2);
  const json torso = runJson("events " + folder + " --margin 0.4 --part torso");
  ASSERT_FALSE(torso["events"].empty());
  for (const json& e : torso["events"]) EXPECT_EQ(e["part"], "torso");
  EXPECT_EQ(run("events " + folder + " --margin 0.2 --part torsso").code, 2);
}

TEST_F(Tune, TellsWhoWasNearForHowLongAndWhere) {
  for (const int i : {1, 2})
    EXPECT_EQ(run("tune " + scene_ + " --recordings" + recordings_ + " --out " +
                  out("half" + std::to_string(i)) + " --shard " + std::to_string(i) + "/2")
                  .code,
              0);
  const std::string both = out("half1") + " " + out("half2");
  const json all = runJson("exposure " + both + " --segment 0.5 --html " + out("page.html") + " --csv " +
                           out("table.csv") + " --room " + out("room.ply") + " --body " + out("body.ply"));
  EXPECT_EQ(all["recordings"], kPeople);
  EXPECT_EQ(all["bands"], (std::vector<double>{0.0, 0.05, 0.1, 0.2, 0.5}));
  // Parts of both halves add up, and stretches to the whole.
  const json one = runJson("exposure " + out("half1")), two = runJson("exposure " + out("half2"));
  constexpr double kSums = 1e-9;
  ASSERT_EQ(all["parts"].size(), one["parts"].size());
  for (std::size_t p = 0; p < all["parts"].size(); ++p)
    EXPECT_NEAR(all["parts"][p]["weighted"],
                one["parts"][p]["weighted"].get<double>() + two["parts"][p]["weighted"].get<double>(), kSums);
  double weighted = 0.0, cells = 0.0, parts = 0.0;
  for (const json& row : all["phases"]) weighted += row["weighted"].get<double>();
  for (const json& cell : all["body"]) cells += cell["weighted"].get<double>();
  for (const json& row : all["parts"]) parts += row["weighted"].get<double>();
  EXPECT_GT(weighted, 0.1);
  EXPECT_NEAR(weighted, all["whole_body"]["weighted"], kSums);
  EXPECT_NEAR(cells, parts, kSums);
  EXPECT_EQ(all["phases"].size(), 5u) << "2.5 s";
  EXPECT_NEAR(all["whole_body"]["time"], 2.5 * kPeople, kSums);
  EXPECT_EQ(all["whole_body"]["near_misses"], all["approaches"].size());
  const std::string page = readFile(out("page.html"));
  for (const char* there :
       {"<h2>Exposure</h2>", "exposure on the body", "exposure on the floor", "left side"})
    EXPECT_NE(page.find(there), std::string::npos) << there;
  const std::string csv = readFile(out("table.csv"));
  EXPECT_EQ(csv.substr(0, 20), "of,part,link,t0,t1,t");
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
            2 + all["parts"].size() + all["links"].size() + all["pairs"].size() + all["phases"].size());
  for (const char* mesh : {"room.ply", "body.ply"})
    EXPECT_EQ(readFile(out(mesh), 1 << 28, true).substr(0, 4), "ply\n");
  EXPECT_EQ(run("merge " + both + " --report " + out("margins.html")).code, 0);
  EXPECT_NE(readFile(out("margins.html")).find("<h2>Exposure</h2>"), std::string::npos);
  EXPECT_EQ(run("exposure " + out("nothing")).code, 2);
  EXPECT_EQ(run("exposure " + both + " --segment 0").code, 2);
}

TEST_F(Tune, WritesASpeedProfileThatItHasProven) {
  // A person who stands; contacts nearer than 1 m count, which only the trunk is: its chest allows a wall
  // 0.28 m/s.
  const std::string person = " --recordings " + out("person0.csv"), rule = " --speed-rule contact --near 1.0";
  const json j = runJson("tune " + scene_ + person + rule + " --speed-profile " + out("slow"));
  EXPECT_EQ(j["speed_rule"], "contact");
  double slowest = 1.0;
  for (const json& s : j["speeds"]) {
    EXPECT_EQ(s["speed_scale"], s["by_contact"]) << s;
    slowest = std::min(slowest, s["speed_scale"].get<double>());
    EXPECT_EQ(s["limited_by"].is_null(), s["speed_scale"] == 1.0) << s;
    if (!s["limited_by"].is_null()) {
      EXPECT_EQ(s["limited_by"]["kind"], "contact") << s;
    }
  }
  EXPECT_NEAR(slowest, 0.28 / 0.5, 2e-3);
  ASSERT_EQ(j["proof"].size(), 1u);
  const json& proof = j["proof"][0];
  EXPECT_EQ(proof["motion"], "slide");
  EXPECT_TRUE(proof["proven"]);
  EXPECT_EQ(proof["broken_contacts"], 0);
  EXPECT_GE(proof["iterations"], 1);
  EXPECT_GT(proof["cycle_time"], 2.5);
  EXPECT_EQ(proof["file"], out("slow") + "/slide.csv");
  // The file is a motion that the scene can have; what it does now breaks nothing.
  std::string scene = readFile(scene_);
  scene.replace(scene.find("go.csv"), 6, "slow/slide.csv");
  write("again.yaml", scene);
  const json again = runJson("tune " + out("again.yaml") + person + rule);
  for (const json& s : again["speeds"]) EXPECT_EQ(s["by_contact"], 1.0) << s;
  // In processes of their own the answer is the same.
  json parallel = runJson("tune " + scene_ + person + rule + " --jobs 2 --speed-profile " + out("slow2"));
  EXPECT_EQ(readFile(out("slow2") + "/slide.csv"), readFile(out("slow") + "/slide.csv"));
  EXPECT_EQ(parallel["proof"][0]["cycle_time"], proof["cycle_time"]);
}

TEST_F(Tune, WritesNoSpeedProfileWhereTheRobotWouldHaveToStand) {
  // The fastest person comes near while the robot moves; the protective distance leaves no speed.
  const Answer a = run("tune " + scene_ + " --recordings " + out("person6.csv") + " --json --speed-profile " +
                       out("slow"));
  EXPECT_EQ(a.code, 1) << a.err;
  EXPECT_NE(a.err.find("the robot would have to stand"), std::string::npos) << a.err;
  EXPECT_EQ(std::count(a.err.begin(), a.err.end(), '\n'), 1) << a.err;
  const json j = json::parse(a.out, nullptr, false);
  EXPECT_FALSE(j["proof"][0]["proven"]);
  EXPECT_EQ(j["proof"][0]["iterations"], 0);
  EXPECT_TRUE(j["proof"][0]["file"].is_null());
  EXPECT_TRUE(j["proof"][0]["stands"]["part"].is_string());
  EXPECT_FALSE(fs::exists(out("slow")));
}

TEST_F(Tune, TradesSpeedForMarginAndTime) {
  const json j = runJson("tune " + scene_ + " --recordings " + out("person6.csv") +
                         " --deceleration 1000 --reaction-time 0.2 --speed-scales 0.5,1");
  ASSERT_EQ(j["trade"].size(), 2u);
  double whole_body = 0.0;
  for (const json& p : j["proposed"]) whole_body = std::max(whole_body, p["margin"].get<double>());
  for (const json& p : j["trade"]) {
    const double scale = p["speed_scale"];
    EXPECT_NEAR(p["cycle_time"].get<double>(), 2.5 / scale, 1e-9);
    // 0.5 m/s of the ball and 0.6 m/s of the person for 0.2 s, and a frame of 10 ms at most.
    EXPECT_GT(p["margin"], 0.2 * (0.5 * scale + 0.6)) << p;
    EXPECT_LT(p["margin"], 0.21 * (0.5 * scale + 0.6) + 0.002) << p;
    EXPECT_TRUE(p["stopped_share"].is_number());
  }
  EXPECT_EQ(j["trade"][1]["margin"], whole_body) << "at full speed it is the proposed one";
  EXPECT_EQ(j["trade"][0]["speed_scale"], 0.5);
}

TEST_F(Tune, JudgesKeptResultsByAnySpeedRule) {
  const std::string person = " --recordings " + out("person4.csv"), folder = out("rules");
  json whole = runJson("tune " + scene_ + person + " --out " + folder);
  for (const std::string rule : {"both", "separation", "contact"}) {
    const json merged = runJson("merge " + folder + " --speed-rule " + rule);
    ASSERT_EQ(merged["speeds"].size(), whole["speeds"].size());
    for (const json& s : merged["speeds"]) {
      const double separation = s["by_separation"], contact = s["by_contact"];
      EXPECT_EQ(s["speed_scale"].get<double>(), rule == "both"         ? std::min(separation, contact)
                                                : rule == "separation" ? separation
                                                                       : contact)
          << rule << s;
    }
    if (rule == "both") {
      EXPECT_EQ(merged["speeds"], whole["speeds"]);
    }
  }
}

TEST_F(Tune, RefusesASpeedProfileThatCannotBe) {
  const std::vector<std::string> all{"--speed-rule all",
                                     "--speed-scales 0",
                                     "--speed-scales 2",
                                     "--speed-scales a",
                                     "--max-iterations 0 --speed-profile " + out("x"),
                                     "--shard 1/2 --speed-profile " + out("x"),
                                     "--speed-profile " + scene_};
  for (const std::string& wrong : all) EXPECT_EQ(run("tune " + scene_ + " " + wrong).code, 2) << wrong;
  // A motion that is read is not replaced.
  write("slide.csv", "t,q0\n0,0\n2,0.5\n");
  std::string scene = readFile(scene_);
  scene.replace(scene.find("go.csv"), 6, "slide.csv");
  write("in_place.yaml", scene);
  const Answer a = run("tune " + out("in_place.yaml") + " --speed-profile " + folder_.path().string());
  EXPECT_EQ(a.code, 2) << a.err;
  EXPECT_NE(a.err.find("input"), std::string::npos) << a.err;
  write("plan.yaml",
        "abstand_plan: 1\nscenes: [slide.yaml]\nrecordings: [person1.csv]\n"
        "programs: [{slide: go.csv}, {slide: slide.csv}]\n");
  EXPECT_EQ(run("tune " + out("plan.yaml") + " --speed-scales 0.5").code, 2);
  EXPECT_FALSE(fs::exists(out("x")));
}

TEST_F(Tune, RefusesWhatMakesNoSense) {
  for (const std::string wrong : {"--margins 0:1", "--margins 1:0:0.1", "--margins a", "--shard 3/2",
                                  "--jobs 0", "--reaction-time -1", "--deceleration 0", "--limit -0.1"})
    EXPECT_EQ(run("tune " + scene_ + " " + wrong).code, 2) << wrong;
  for (const std::string wrong : {"0/2", "3/2", "1", "/2"})
    EXPECT_EQ(run("tune " + scene_ + " --out " + out("x") + " --shard " + wrong).code, 2) << wrong;
  EXPECT_EQ(run("merge " + out("nothing")).code, 2);
}

TEST_F(Tune, RefusesToMergeResultsOfDifferentOptions) {
  EXPECT_EQ(
      run("tune " + scene_ + " --recordings" + recordings_ + " --out " + out("a") + " --shard 1/7").code, 0);
  EXPECT_EQ(run("tune " + scene_ + " --recordings" + recordings_ + " --out " + out("a") +
                " --shard 2/7 --reaction-time 0.3")
                .code,
            3)
      << "what the folder holds is merged for the answer";
  const Answer a = run("merge " + out("a"));
  EXPECT_EQ(a.code, 3);
  EXPECT_NE(a.err.find("other options"), std::string::npos) << a.err;
  EXPECT_EQ(
      run("tune " + scene_ + " --recordings" + recordings_ + " --out " + out("b") + " --shard 1/7").code, 0);
  EXPECT_EQ(run("tune " + scene_ + " --recordings" + recordings_ + " --out " + out("c") +
                " --shard 2/7 --separation intrusion=0.3")
                .code,
            0);
  EXPECT_EQ(run("merge " + out("b") + " " + out("c")).code, 3);
}

}  // namespace
}  // namespace abstand::testing
