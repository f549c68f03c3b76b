// Sets of margins by part, link and pair, as a user judges them with `tune` and `merge`.
#include <map>

#include "tests/app/program.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::testing {
namespace margin_set_test {

/// A ball on a rail that drives at a person who comes along.
class MarginSet : public Cli {
 protected:
  MarginSet() {
    ::setenv("ABSTAND_CACHE", (folder_.path() / "cache").c_str(), 1);
    scene_ =
        writeSlide(folder_, {.robot = 0.5, .person = 0.3, .stops_at = 3.0, .rate = 100.0, .seconds = 3.5})
            .string();
    common_ = " --reaction-time 0.2 --deceleration 2 --margins 0:0.6:0.05";
  }
  std::string set(const std::string& name, const std::string& text) {
    return folder_.write(name, "abstand_margins: 1\n" + text).string();
  }
  static const json& named(const json& rows, const std::string& key, const std::string& name) {
    for (const json& row : rows)
      if (row[key] == name) return row;
    throw std::runtime_error("no row " + name);
  }

  std::string scene_, common_;
};

TEST_F(MarginSet, UniformSetMatchesWholeBodyRow) {
  const std::string file = set("uniform.yaml", "default: {margin: 0.3}\n");
  const json j = runJson("tune " + scene_ + common_ + " --margin-set " + file);
  const json& of_set = named(j["margin_sets"], "name", file);
  for (const json& row : j["margins"]) {
    if (row["part"] != "whole_body" || std::abs(row["margin"].get<double>() - 0.3) > 1e-9) continue;
    for (const char* count : {"stops", "false_stops", "missed_stops", "unseen"})
      EXPECT_EQ(of_set[count], row[count]);
    // Clearances of result files are whole steps of 0.01 mm: a stop begins or ends a frame earlier or later.
    EXPECT_NEAR(of_set["stopped_share"], row["stopped_share"], 2.0 / 350.0);
    return;
  }
  FAIL() << "no margin of 0.3 m";
}

TEST_F(MarginSet, MarginGrowsWithSpeeds) {
  // Ball and person go towards each other at constant speeds until the ball is through.
  const double robot = 0.5, person = 0.3, robot_time = 0.2, person_time = 0.4, margin = 0.1;
  const std::string speeds =
      set("speeds.yaml", "default: {margin: 0.1, robot_time: 0.2, person_time: 0.4}\n");
  const std::string fixed =
      set("fixed.yaml",
          "default: {margin: " + std::to_string(margin + robot_time * robot + person_time * person) + "}\n");
  const std::string small = set("small.yaml", "default: {margin: 0.1}\n");
  const std::string out = (folder_.path() / "results").string();
  runJson("tune " + scene_ + common_ + " --out " + out);
  const auto first = [&](const std::string& file) {
    const json j = runJson("merge " + out + " --margin-set " + file);
    return named(j["margin_sets"], "name", file)["lead_time"].get<double>();
  };
  // The lead time tells when the stop was told. Speeds are rounded up to 1/512 m/s, and a frame is 10 ms.
  EXPECT_NEAR(first(speeds), first(fixed), 0.0101);
  EXPECT_NEAR(first(speeds) - first(small), (robot_time * robot + person_time * person) / (robot + person),
              0.0201);
}

TEST_F(MarginSet, PairMarginsOverridePartsAndLinks) {
  const std::string out = (folder_.path() / "results").string();
  runJson("tune " + scene_ + common_ + " --out " + out);
  const auto stops = [&](const std::string& file) {
    return named(runJson("merge " + out + " --margin-set " + file)["margin_sets"], "name", file)["stops"]
        .get<int>();
  };
  EXPECT_EQ(stops(set("none.yaml", "margins: [{link: ball, margin: 0}]\ndefault: {margin: 9}\n")), 1)
      << "a touch breaks a margin of nothing, too";
  const std::string apart = "default: {margin: 0}\nmargins:\n  - {part: torso, margin: 0.5}\n";
  EXPECT_EQ(runJson("merge " + out + " --margin-set " + set("torso.yaml", apart) + " --margin-set " +
                    set("pair.yaml", apart + "  - {part: torso, link: ball, margin: 0}\n"))["margin_sets"]
                .size(),
            4u + 2u);
}

TEST_F(MarginSet, ProposedMarginsMissNoStops) {
  const std::string out = (folder_.path() / "results").string();
  const json j = runJson("tune " + scene_ + common_ + " --out " + out);
  std::map<std::string, double> of_part, of_pair;
  double largest = 0.0;
  for (const json& p : j["proposed"]) of_part[p["part"]] = p["margin"];
  for (const json& p : j["proposed_pairs"]) {
    of_pair[p["part"]] = p["margin"];
    largest = std::max(largest, p["margin"].get<double>());
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_EQ(of_part, of_pair) << "with one link a part is a pair";
  ASSERT_EQ(j["proposed_links"].size(), 1u);
  EXPECT_NEAR(j["proposed_links"][0]["margin"], largest, 0.011)
      << "the nearest part of all decides, a frame apart";
  for (const char* name : {"uniform", "per_part", "per_link", "per_pair"})
    EXPECT_EQ(named(j["margin_sets"], "name", name)["missed_stops"], 0) << name;
  // Written to a file and judged again they are the same.
  for (const std::string by : {"part", "link", "pair"}) {
    const std::string file = (folder_.path() / ("by_" + by + ".yaml")).string();
    runJson("merge " + out + " --margins-out " + file + " --by " + by);
    json again = named(runJson("merge " + out + " --margin-set " + file)["margin_sets"], "name", file);
    json expected = named(j["margin_sets"], "name", "per_" + by);
    again.erase("name"), expected.erase("name");
    EXPECT_EQ(again, expected) << by;
  }
}

TEST_F(MarginSet, RejectsInvalidSets) {
  const std::string out = (folder_.path() / "results").string();
  runJson("tune " + scene_ + common_ + " --out " + out);
  const struct {
    const char *text, *message;
    int code;
  } cases[] = {
      {"margins: [{part: torso, margin: 0.1}]\n", "found no margin for ", 2},
      {"default: {margin: 0.1}\nmargins: [{link: bal, margin: 0.1}]\n", "found the link `bal`", 2},
      {"default: {margin: -1}\n", ":2:19:", 3},
      {"default: {}\n", "margin", 3},
      {"margins: [{margin: 0.1}]\n", "neither a part nor a link", 3},
      {"margins: [{part: tail, margin: 0.1}]\n", "tail", 3},
      {"margins: [{part: torso, margin: 0.1}, {part: torso, margin: 0.2}]\n", "second margin", 3},
      {"", "found no margin", 3},
  };
  for (const auto& c : cases) {
    const Answer answer = run("merge " + out + " --margin-set " + set("bad.yaml", c.text));
    EXPECT_EQ(answer.code, c.code) << c.text << answer.err;
    EXPECT_NE(answer.err.find(c.message), std::string::npos) << c.text << answer.err;
  }
}

}  // namespace margin_set_test
}  // namespace abstand::testing
