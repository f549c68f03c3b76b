// Permitted speeds of `tune`: rules, profiles and the trade with margins.
#include "tests/app/cli/seven_people.hpp"

namespace abstand::testing {
namespace speed_profile_test {

using TuneSpeedProfile = SevenPeople;

TEST_F(TuneSpeedProfile, WritesProvenProfile) {
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

TEST_F(TuneSpeedProfile, WritesNoProfileIfRobotMustStand) {
  // The fastest person comes near while the robot moves; the protective distance leaves no speed.
  const Answer a = run("tune " + scene_ + " --recordings " + out("person6.csv") + " --json --speed-profile " +
                       out("slow"));
  EXPECT_EQ(a.code, 1) << a.err;
  EXPECT_NE(a.err.find("the robot would have to stand"), std::string::npos) << a.err;
  // Beside it at most the progress of a build that takes long.
  EXPECT_EQ(a.err.find("warning: "), a.err.rfind("warning: ")) << a.err;
  const json j = json::parse(a.out, nullptr, false);
  EXPECT_FALSE(j["proof"][0]["proven"]);
  EXPECT_EQ(j["proof"][0]["iterations"], 0);
  EXPECT_TRUE(j["proof"][0]["file"].is_null());
  EXPECT_TRUE(j["proof"][0]["stands"]["part"].is_string());
  EXPECT_FALSE(std::filesystem::exists(out("slow")));
}

TEST_F(TuneSpeedProfile, ReportsMarginAndTimePerSpeedScale) {
  const json j =
      runJson("tune " + scene_ + " --recordings " + out("person6.csv") +
              " --deceleration 1000 --reaction-time 0.2 --speed-scales 0.5,1 --report " + out("trade.html"));
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
  const std::string page = readFile(out("trade.html"), 1 << 24);
  for (const char* said :
       {"Permitted speeds", "Margin, speed and time", "<td>50 %</td>", "2.5 s as recorded"})
    EXPECT_NE(page.find(said), std::string::npos) << said;
}

TEST_F(TuneSpeedProfile, AppliesAnySpeedRuleToStoredResults) {
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

TEST_F(TuneSpeedProfile, RejectsInvalidOptions) {
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
  EXPECT_FALSE(std::filesystem::exists(out("x")));
}

}  // namespace speed_profile_test
}  // namespace abstand::testing
