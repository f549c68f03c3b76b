// abstand tune and merge as a user runs them.
#include <csignal>
#include <fstream>
#include <set>
#include <thread>

#include "tests/app/cli/seven_people.hpp"

namespace abstand::testing {
namespace tune_test {

namespace fs = std::filesystem;

using Tune = SevenPeople;

TEST_F(Tune, ResultIsIndependentOfShardsAndProcesses) {
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

TEST_F(Tune, HasTheKeysOfItsContractAndTheyAgreeWithEachOther) {
  const json j = runJson("tune " + scene_ + " --recordings" + recordings_ + " --margins 0:0.4:0.1");
  const auto expectKeys = [](const json& row, std::initializer_list<const char*> keys) {
    for (const char* key : keys) EXPECT_TRUE(row.contains(key)) << key << " in " << row;
  };
  expectKeys(j, {"recordings", "frames", "seconds", "margins", "proposed", "speeds", "curve"});
  std::size_t frames = 0;
  double seconds = 0.0;
  for (const json& input : j["inputs"])
    frames += input["frames"].get<std::size_t>(), seconds += input["seconds"].get<double>();
  EXPECT_EQ(j["frames"], frames);
  EXPECT_NEAR(j["seconds"], seconds, 1e-9);
  // Five margins of each part and of the whole body, and the curve says of each the same.
  ASSERT_EQ(j["margins"].size(), 5 * (j["proposed"].size() + 1));
  ASSERT_EQ(j["curve"].size(), j["margins"].size());
  for (std::size_t i = 0; i < j["margins"].size(); ++i) {
    const json &row = j["margins"][i], &point = j["curve"][i];
    expectKeys(row, {"part", "margin", "stops", "stopped_share", "false_stops", "missed_stops",
                     "min_distance", "lead_time"});
    expectKeys(point, {"part", "margin", "stopped_share", "missed_stops"});
    for (const auto& [key, value] : point.items()) EXPECT_EQ(value, row[key]) << key;
    EXPECT_LE(row["false_stops"], row["stops"]);
  }
  for (const json& p : j["proposed"]) {
    expectKeys(p, {"part", "margin", "decided_by", "uncertainty", "confidence", "enclosed_share"});
    if (!p["decided_by"].is_null()) expectKeys(p["decided_by"], {"recording", "t", "link"});
  }
  ASSERT_FALSE(j["speeds"].empty());
  for (const json& s : j["speeds"]) {
    expectKeys(s, {"motion", "segment", "t0", "t1", "speed_scale", "limited_by"});
    EXPECT_EQ(s["limited_by"].is_null(), s["speed_scale"] == 1.0) << s;
  }
}

TEST_F(Tune, ProposesMarginForFastestPerson) {
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

TEST_F(Tune, ConfidenceByTimeCountsEachRecordingOnce) {
  const auto minutesOf = [](const json& answer, const std::string& part) {
    for (const json& p : answer["proposed"])
      if (p["part"] == part) return p["confidence"]["unseen_minutes"];
    return json();
  };
  const json many = runJson("tune " + scene_ + " --recordings" + recordings_);
  double judged = 0.0;
  for (const json& input : many["inputs"]) judged += input["seconds"].get<double>();
  const json foot = minutesOf(many, "foot_left");
  EXPECT_NEAR(foot["seconds"], judged, 1e-9) << "seven recordings of different content";
  EXPECT_NEAR(foot["violations_per_minute"], -std::log(0.05) / (judged / 60.0), 1e-9);
  EXPECT_NEAR(foot["share"], 1.0 - std::pow(0.05, 60.0 / judged), 1e-9);
  // Another person with the same motion is no other motion.
  write("plan.yaml",
        "abstand_plan: 1\nscenes: [slide.yaml]\nrecordings: [person1.csv]\n"
        "people: [{height: 1.6, sex: f}, {height: 1.9}]\n");
  const json variants = runJson("tune " + out("plan.yaml"));
  EXPECT_EQ(variants["recordings"], 2);
  const double one = variants["inputs"][0]["seconds"];
  EXPECT_NEAR(variants["seconds"], 2.0 * one, 1e-9);
  EXPECT_NEAR(minutesOf(variants, "foot_left")["seconds"], one, 1e-9);
}

TEST_F(Tune, ReportShowsTheFitOfTheExtremeValues) {
  const json j =
      runJson("tune " + scene_ + " --recordings" + recordings_ + " --report " + out("report.html"));
  const std::string html = readFile(out("report.html"));
  for (const char* said : {"Confidence by time", "Poisson process", "Extreme values and their fit",
                           "Gumbel fit", "torso: margins that the recordings need"})
    EXPECT_NE(html.find(said), std::string::npos) << said;
  for (const json& p : j["proposed"]) {
    const json& fit = p["confidence"]["gumbel"];
    if (fit.is_null()) continue;
    EXPECT_NEAR(fit["critical_misfit"], 0.92 / (std::sqrt(static_cast<double>(kPeople)) + 0.3), 1e-12);
    EXPECT_GT(fit["misfit"], 0.0);
  }
}

TEST_F(Tune, ResumesAfterKillAndRedoesDamagedResults) {
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

TEST_F(Tune, KillLeavesNoPartialResult) {
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

TEST_F(Tune, BadRecordingDoesNotStopOthers) {
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

TEST_F(Tune, PlanAcceptsPercentiles) {
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
  const json j =
      runJson("tune " + scene_ + " --recordings" + recordings_ + " --report " + out("report.html"));
  const std::string html = readFile(out("report.html"));
  for (const char* said : {"Proposed margins",
                           "Cost of margins",
                           "Nearest approaches",
                           "Assumptions",
                           "Inputs",
                           "Signature",
                           "hardest closing before",
                           "stops per minute",
                           "person6.csv",
                           "no certified safety function",
                           "ISO/TS 15066:2016",
                           "class=\"moment\"",
                           "Summary",
                           "Protective distance",
                           "robot's mass",
                           "not stated",
                           "latency of a person's pose",
                           "Z_d, error of the person's place",
                           "body encloses",
                           "clothing: none; tools: none",
                           "ISO 13855:2010",
                           "edition of 2024",
                           "ISO 10218-2:2025"})
    EXPECT_NE(html.find(said), std::string::npos) << said;
  for (const char* odd :
       {"not measured it", "way within", "'s way", "of late", "least certified", "broken for", "was broken"})
    EXPECT_EQ(html.find(odd), std::string::npos) << odd;
  for (const char* outside : {"http://", "https://", "<script", "src="})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  // Every file with its fingerprint: scene, robot, motion, and each recording.
  EXPECT_EQ(j["files"].size(), 3 + kPeople);
  for (const json& file : j["files"])
    EXPECT_NE(html.find(file["content"].get<std::string>()), std::string::npos) << file;
  // S_p of the worst moment is the sum of its terms.
  for (const json& row : j["separation"]) {
    if (row["worst"].is_null()) continue;
    const json& w = row["worst"];
    EXPECT_NEAR(w["needed"].get<double>(),
                w["person"].get<double>() + w["reaction"].get<double>() + w["stopping"].get<double>() +
                    w["constant"].get<double>(),
                1e-12);
  }
  EXPECT_EQ(j["standards"]["protective_distance"], "ISO/TS 15066:2016, 5.5.4");
  EXPECT_EQ(j["standards"]["person_speed"], "ISO 13855:2010");
  for (std::size_t at = html.find("ISO 13855"); at != std::string::npos; at = html.find("ISO 13855", at + 1))
    EXPECT_EQ(html.substr(at, 10), "ISO 13855:") << "always with its edition";
  // No id stands for two things.
  std::set<std::string> ids;
  std::size_t count = 0;
  for (std::size_t at = html.find("<clipPath id="); at != std::string::npos;
       at = html.find("<clipPath id=", at + 1)) {
    ids.insert(html.substr(at, html.find('>', at) - at));
    ++count;
  }
  EXPECT_GT(count, 0u);
  EXPECT_EQ(ids.size(), count);
}

TEST_F(Tune, ReportsPositionOfPlanErrors) {
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

TEST_F(Tune, ClampedPartsUseQuasiStaticLimits) {
  const std::string command = "tune " + scene_ + " --near 1 --out " + out("clamped");
  const json free = runJson("tune " + scene_ + " --near 1");
  EXPECT_EQ(free["clamped"], json::array());
  const json j = runJson(command + " --clamped torso hand_left torso");
  EXPECT_EQ(j["clamped"], json({"hand_left", "torso"}));
  EXPECT_EQ(j["inputs"][0]["clamped"], j["clamped"]);
  int clamped = 0;
  for (std::size_t i = 0; i < j["approaches"].size(); ++i) {
    const json &a = j["approaches"][i], &contact = a["contact"], &as_free = free["approaches"][i]["contact"];
    if (contact.is_null()) continue;
    const bool is_clamped = a["part"] == "torso" || a["part"] == "hand_left";
    clamped += is_clamped;
    EXPECT_EQ(contact["kind"], is_clamped ? "quasi-static" : "transient") << a;
    EXPECT_EQ(as_free["kind"], "transient");
    if (!is_clamped) {
      EXPECT_EQ(contact, as_free);
    }
  }
  EXPECT_GT(clamped, 0);
  json merged = runJson("merge " + out("clamped"));
  EXPECT_EQ(answerOf(merged), answerOf(j)) << "the result file keeps it";
  EXPECT_EQ(run("merge " + out("clamped") + " --report " + out("clamped.html")).code, 0);
  const std::string html = readFile(out("clamped.html"));
  for (const char* said : {"quasi-static", "parts that may be clamped", "hand_left, torso"})
    EXPECT_NE(html.find(said), std::string::npos) << said;
  const Answer wrong = run("tune " + scene_ + " --clamped paw");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(wrong.err.find("'paw', expected parts of the body: "), std::string::npos) << wrong.err;
}

TEST_F(Tune, SaysWhoStatedAnAssumption) {
  // The value of --reaction-time is that of the default: confirmed all the same.
  const std::string stated = " --reaction-time 0.1 --separation intrusion=0 stopping_time=0.2";
  const json j =
      runJson("tune " + scene_ + " --out " + out("said") + " --report " + out("said.html") + stated);
  const json plain = runJson("tune " + scene_);
  EXPECT_EQ(plain["assumed"]["reaction_time"], j["assumed"]["reaction_time"]);
  for (const auto& [name, by] : plain["assumed_by"].items()) EXPECT_EQ(by, "default") << name;
  const std::set<std::string> users{"reaction_time", "separation.reaction_time", "separation.intrusion",
                                    "separation.stopping_time"};
  for (const auto& [name, by] : j["assumed_by"].items())
    EXPECT_EQ(by, users.contains(name) ? "user" : "default") << name;
  EXPECT_NE(readFile(out("said.html")).find("<td>reaction time</td><td>100 ms</td><td>user</td>"),
            std::string::npos);
  // Result files keep it. What merge is asked for itself is stated there.
  EXPECT_EQ(runJson("merge " + out("said"))["assumed_by"], j["assumed_by"]);
  EXPECT_EQ(runJson("merge " + out("said") + " --restart-time 0")["assumed_by"]["restart_time"], "user");
  // Where one of two results has only the default, nobody has confirmed it for both.
  EXPECT_EQ(run("tune " + scene_ + " --out " + out("more") + " --recordings" + recordings_ +
                " --separation stopping_time=0.2")
                .code,
            0);
  const json both = runJson("merge " + out("said") + " " + out("more"));
  EXPECT_EQ(both["assumed_by"]["reaction_time"], "default");
  EXPECT_EQ(both["assumed_by"]["separation.stopping_time"], "user");
}

TEST_F(Tune, RejectsInvalidOptions) {
  for (const std::string wrong : {"--margins 0:1", "--margins 1:0:0.1", "--margins a", "--shard 3/2",
                                  "--jobs 0", "--reaction-time -1", "--deceleration 0", "--limit -0.1"})
    EXPECT_EQ(run("tune " + scene_ + " " + wrong).code, 2) << wrong;
  for (const std::string wrong : {"0/2", "3/2", "1", "/2"})
    EXPECT_EQ(run("tune " + scene_ + " --out " + out("x") + " --shard " + wrong).code, 2) << wrong;
  EXPECT_EQ(run("merge " + out("nothing")).code, 2);
}

TEST_F(Tune, MergeRejectsResultsOfDifferentOptions) {
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

}  // namespace tune_test
}  // namespace abstand::testing
