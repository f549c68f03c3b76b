// abstand events and report as a user runs them on results of `tune`.
#include "app/tune/stop_term.hpp"
#include "tests/app/cli/seven_people.hpp"

namespace abstand::testing {
namespace events_test {

using Events = SevenPeople;

TEST_F(Events, ListStopsOfMarginSetWithStoppingPair) {
  const std::string folder = out("results");
  runJson("tune " + scene_ + " --recordings" + recordings_ + " --out " + folder + " --margins 0.2:0.4:0.2");
  const std::string torso = folder_
                                .write("torso.yaml",
                                       "abstand_margins: 1\ndefault: {margin: 0.01}\nmargins:\n"
                                       "  - {part: torso, margin: 0.1, person_time: 0.5}\n")
                                .string();
  const std::string all = folder_.write("all.yaml", "abstand_margins: 1\ndefault: {margin: 0.4}\n").string();
  for (const std::string& set : {torso, all}) {
    const json events = runJson("events " + folder + " --margin-set " + set);
    EXPECT_TRUE(events["margin"].is_null());
    EXPECT_EQ(events["margin_set"], set);
    const json outcome = runJson("merge " + folder + " --margin-set " + set)["margin_sets"].back();
    int stops = 0, false_stops = 0, missed = 0;
    for (const json& e : events["events"]) {
      stops += e["kind"] == "intrusion";
      false_stops += e["false_stop"].get<bool>();
      missed += e["missed_stop"].get<bool>();
      EXPECT_LE(e["t0"], e["t_nearest"]);
      EXPECT_LE(e["t_nearest"], e["t1"]);
      EXPECT_LT(e["min_clearance"], 0.4);
      if (e["kind"] != "intrusion") continue;
      EXPECT_EQ(e["told_by"]["link"], "ball");
      if (set == all) {
        EXPECT_EQ(e["told_by"]["margin"], 0.4);
      } else if (e["told_by"]["part"] == "torso") {
        EXPECT_GE(e["told_by"]["margin"], 0.1);
        EXPECT_LE(e["told_by"]["margin"], 0.1 + 0.5 * 0.1 * kPeople);
      } else {
        EXPECT_EQ(e["told_by"]["margin"], 0.01);
      }
    }
    EXPECT_EQ(stops, outcome["stops"]);
    EXPECT_EQ(false_stops, outcome["false_stops"]);
    EXPECT_EQ(missed, outcome["missed_stops"]);
    EXPECT_GT(stops, 0);
    EXPECT_NE(run("events " + folder + " --margin-set " + set).out.find(", stopped by "), std::string::npos);
  }
  const std::string events = "events " + folder;
  EXPECT_EQ(run(events).code, 2);
  EXPECT_EQ(run(events + " --margin 0.2 --margin-set " + all).code, 2);
  EXPECT_EQ(run(events + " --margin-set " + out("none.yaml")).code, 3);
  EXPECT_EQ(run(events + " --margin-set " +
                folder_
                    .write("slip.yaml",
                           "abstand_margins: 1\ndefault: {margin: 0.1}\n"
                           "margins: [{link: bal, margin: 0.1}]\n")
                    .string())
                .code,
            2);
}

TEST_F(Events, DiffComparesMarginSetsWithinAndAcrossStudies) {
  const std::string few = out("few"), many = out("many");
  runJson("tune " + scene_ + " --recordings" + recordings_ + " --out " + many + " --margins 0.2:0.4:0.2");
  runJson("tune " + scene_ + " --recordings " + out("person1.csv") + " --out " + few +
          " --margins 0.2:0.4:0.2");
  const std::string a = folder_.write("a.yaml", "abstand_margins: 1\ndefault: {margin: 0.3}\n").string();
  const std::string b = folder_
                            .write("b.yaml",
                                   "abstand_margins: 1\ndefault: {margin: 0.3}\nmargins:\n"
                                   "  - {part: torso, margin: 0.4}\n")
                            .string();
  const std::string sets = " --margin-set " + a + " --margin-set " + b;
  const json one = runJson("diff " + many + sets);
  EXPECT_TRUE(one["proposed"].empty());
  ASSERT_EQ(one["margin_sets"].size(), 2u);
  ASSERT_EQ(one["differences"].size(), 1u);
  EXPECT_EQ(one["differences"][0]["part"], "torso");
  EXPECT_EQ(one["differences"][0]["margins"][0]["margin"], 0.3);
  EXPECT_EQ(one["differences"][0]["margins"][1]["margin"], 0.4);
  EXPECT_GT(one["margin_sets"][1]["stopped_share"][0], one["margin_sets"][0]["stopped_share"][0]);
  const json two = runJson("diff " + few + " " + many + sets);
  EXPECT_FALSE(two["proposed"].empty());
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(two["margin_sets"][s]["stops"][1], one["margin_sets"][s]["stops"][0]);
    const json merged = runJson("merge " + few + " --margin-set " + (s == 0 ? a : b))["margin_sets"].back();
    EXPECT_EQ(two["margin_sets"][s]["stops"][0], merged["stops"]);
    EXPECT_EQ(two["margin_sets"][s]["missed_stops"][0], merged["missed_stops"]);
  }
  EXPECT_EQ(run("diff " + many).code, 2);
  EXPECT_EQ(run("diff " + many + " --margin-set " + a).code, 2);
}

/// S_p of the pair that stopped the robot, recomputed from the speed that is stated.
void expectTerms(const json& e, double robot_speed, double tolerance) {
  const json& s = e["separation"];
  if (s.is_null()) return;
  safety::SeparationOptions options;
  options.intrusion = 0.3;
  options.stopping_time = 0.4;
  EXPECT_NEAR(s["robot_speed"], robot_speed, tolerance);
  const double near = s["clearance"].is_null() ? -1.0 : s["clearance"].get<double>();
  const auto needed = safety::protectiveDistance(options, s["robot_speed"], NAN, near);
  EXPECT_DOUBLE_EQ(s["person"], (near < 0.5 ? 2.0 : 1.6) * (0.1 + 0.4));
  EXPECT_DOUBLE_EQ(s["reaction"], needed.reaction);
  EXPECT_DOUBLE_EQ(s["stopping"], needed.stopping);
  EXPECT_DOUBLE_EQ(s["constant"], 0.3);
  EXPECT_NEAR(s["needed"], needed.sum(), 1e-12);
  EXPECT_EQ(s["largest"], "person") << "1 m, or 0.8 m";
  EXPECT_EQ(s["violated"], needed.sum() > near);
}

TEST_F(Events, NameTheLargestTermOfTheProtectiveDistance) {
  const std::string folder = out("terms");
  runJson("tune " + scene_ + " --recordings" + recordings_ + " --out " + folder + " --report " +
          out("terms.html") + " --separation intrusion=0.3 stopping_time=0.4");
  // Ahead of the ball the torso is approached with its full 0.5 m/s. Speeds are rounded up: of parts to
  // kSpeedStep, of pairs to 1/512 m/s.
  const json alone = runJson("events " + folder + " --margin 0.4 --part torso");
  ASSERT_FALSE(alone["events"].empty());
  for (const json& e : alone["events"]) {
    EXPECT_FALSE(e["separation"].is_null()) << e;
    expectTerms(e, 0.5, 0.01);
  }
  const std::string set = folder_.write("all.yaml", "abstand_margins: 1\ndefault: {margin: 0.4}\n").string();
  int named = 0;
  const json together = runJson("events " + folder + " --margin-set " + set);
  for (const json& e : together["events"]) {
    named += !e["separation"].is_null();
    expectTerms(e, 0.5, 0.01);
  }
  EXPECT_GT(named, 0);
  EXPECT_NE(run("events " + folder + " --margin 0.4").out.find("largest term: person"), std::string::npos);
  const std::string html = readFile(out("terms.html"));
  for (const char* said : {"Stops of the proposed margins", "stops by their largest term: "})
    EXPECT_NE(html.find(said), std::string::npos) << said;
}

TEST_F(Events, StandingRobotHasNoTerm) {
  tune::MarginEvent event;
  EXPECT_FALSE(tune::stopTerm(event, {})) << "the link does not move";
  event.told_robot_speed = 1.0;
  event.told_clearance = 0.2;
  safety::SeparationOptions options;
  options.stopping_time = 3.0;
  options.person_speed = options.person_speed_near = 0.1;
  const auto term = tune::stopTerm(event, options);
  ASSERT_TRUE(term);
  EXPECT_STREQ(term->largest, "stopping") << "1.5 m of 0.31, 0.1 and 1.5 m";
  EXPECT_TRUE(term->violated());
  event.kind = tune::MarginEvent::Kind::kBetweenFrames;
  EXPECT_FALSE(tune::stopTerm(event, options)) << "nothing stopped the robot";
}

TEST_F(Events, ListMatchesCounts) {
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

}  // namespace events_test
}  // namespace abstand::testing
