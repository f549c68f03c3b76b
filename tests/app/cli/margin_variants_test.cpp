// Uncertainty with its shares, and one recording as several people, places and sides.
#include <map>

#include "tests/app/program.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::testing {
namespace margin_variants_test {

// m: rounding to whole millimetres, and one to the next frame of two bodies at 0.8 m/s.
constexpr double kMillimetre = 1e-3, kFrame = 0.008;

class MarginVariants : public Cli {
 protected:
  MarginVariants() {
    ::setenv("ABSTAND_CACHE", (folder_.path() / "cache").c_str(), 1);
    scene_ = writeSlide(folder_, {.robot = 0.5, .person = 0.3, .seconds = 3.5}).string();
  }
  std::string plan(const std::string& text) {
    return folder_.write("plan.yaml", "abstand_plan: 1\nscenes: [slide.yaml]\n" + text).string();
  }
  std::string out(const std::string& name) const { return (folder_.path() / name).string(); }
  static const json& ofPart(const json& rows, const std::string& part) {
    for (const json& row : rows)
      if (row["part"] == part) return row;
    throw std::runtime_error("no row of " + part);
  }

  std::string scene_, options_{" --margins 0.1 --reaction-time 0.2 --deceleration 1000"};
};

TEST_F(MarginVariants, CalibrationErrorAddsToEveryUncertainty) {
  const json without = runJson("tune " + scene_ + options_),
             with = runJson("tune " + scene_ + options_ + " --calibration-error 0.03");
  EXPECT_EQ(with["assumed"]["calibration_error"], 0.03);
  const json &a = ofPart(without["closest"], "torso"), &b = ofPart(with["closest"], "torso");
  EXPECT_EQ(a["shares"]["calibration"], 0.0);
  EXPECT_EQ(b["shares"]["calibration"], 0.03);
  EXPECT_NEAR(b["clearance"].get<double>(), a["clearance"].get<double>() - 0.03, kMillimetre);
  for (const json* row : {&a, &b}) {
    double sum = 0.0;
    for (const auto& [name, share] : (*row)["shares"].items()) sum += share.get<double>();
    EXPECT_NEAR((*row)["error"], sum, 1e-12);
    EXPECT_NEAR((*row)["clearance"].get<double>(), (*row)["distance"].get<double>() - sum, 1e-12);
  }
  // A margin is broken by the clearance, which is smaller by the error, and has to end above it.
  const double margin = ofPart(with["proposed"], "torso")["margin"],
               before = ofPart(without["proposed"], "torso")["margin"];
  EXPECT_NEAR(margin, before, kFrame + kMillimetre) << "both sides of the comparison lose it";
}

TEST_F(MarginVariants, BandSpansRunsOfOneRecording) {
  // Nearer by 0.1 m, and the ball passes by at the side, farther than the trunk is wide.
  const json j =
      runJson("tune " + plan("places: [{}, {shift: [-0.1, 0, 0]}, {shift: [0, 3, 0]}]\n") + options_);
  ASSERT_EQ(j["recordings"], 3);
  const json& band = ofPart(j["bands"], "torso");
  EXPECT_EQ(band["runs"], 3);
  std::vector<double> clearance;
  for (const char* end : {"min", "max"}) clearance.push_back(band["clearance"][end]);
  EXPECT_NE(band["clearance"]["max_of"].get<std::string>().find("shift 0 3 0"), std::string::npos);
  EXPECT_GT(clearance[1], 2.0);
  EXPECT_LT(clearance[0], 0.0);
  EXPECT_EQ(band["margin"]["min"], 0.0) << "nobody needs a margin three metres beside";
  EXPECT_GT(band["margin"]["max"], 0.1);
}

TEST_F(MarginVariants, MirroredPersonSwapsSides) {
  const json j =
      runJson("tune " + plan("mirror: [false, true]\nplaces: [{shift: [0, 0.9, 0]}]\n") + options_);
  ASSERT_EQ(j["recordings"], 2);
  // The rest pose is its own mirror image but for the names, so the sides' bands are those of the other side.
  std::map<std::string, double> closest;
  for (const json& band : j["bands"]) {
    EXPECT_EQ(band["runs"], 2);
    EXPECT_NEAR(band["clearance"]["min"], band["clearance"]["max"], 2e-3) << band["part"] << ": symmetric";
  }
  const std::string name = ofPart(j["bands"], "torso")["clearance"]["max_of"];
  EXPECT_FALSE(name.empty());
}

TEST_F(MarginVariants, ALatencyIsAShareOfEveryUncertainty) {
  const json with = runJson("tune " + scene_ + options_ + " --latency 0.05 --out " + out("late"));
  EXPECT_EQ(with["assumed"]["latency"], 0.05);
  EXPECT_NEAR(ofPart(with["closest"], "torso")["shares"]["latency"], 0.05 * 2.0, 1e-12)
      << "at the speed of a hand in ISO 13855:2010";
  EXPECT_EQ(runJson("merge " + out("late") + " --margins 0.1")["closest"], with["closest"])
      << "the same from the files";
  EXPECT_EQ(run("tune " + scene_ + options_ + " --latency -1").code, 2);
}

TEST_F(MarginVariants, ClothingTakesItsThicknessAndAToolStandsOut) {
  const auto clearance = [](const json& j, const std::string& part) {
    return ofPart(j["closest"], part)["clearance"].get<double>();
  };
  // Passes beside the trunk at 0.9 m.
  const std::string plain = "tune " + plan("places: [{shift: [0, 0.9, 0]}]\n") + options_;
  const json bare = runJson(plain), clothed = runJson(plain + " --clothing torso=0.05,gloves"),
             armed = runJson(plain + " --tool right=sphere:0.1 --tool right=sphere:0.02");
  EXPECT_NEAR(clearance(clothed, "torso"), clearance(bare, "torso") - 0.05, kMillimetre);
  EXPECT_EQ(clearance(clothed, "head"), clearance(bare, "head"));
  // The right hand, 40 to 50 mm wide, is within the ball of 100 mm about its centre.
  EXPECT_LT(clearance(armed, "hand_right"), clearance(bare, "hand_right") - 0.03);
  EXPECT_EQ(clearance(armed, "hand_left"), clearance(bare, "hand_left"));
  const std::string body = armed["inputs"][0]["people"][0]["body"];
  EXPECT_NE(body.find("tools: hand_right/sphere, hand_right/sphere_2"), std::string::npos) << body;
  EXPECT_NE(clothed["inputs"][0]["people"][0]["body"].get<std::string>().find("torso 50 mm"),
            std::string::npos);
}

TEST_F(MarginVariants, APlanHasClothingAndToolsAsVariants) {
  const json j = runJson("tune " +
                         plan("clothing: [{}, {preset: winter_clothes}]\n"
                              "tools: [[], [{name: rod, hand: left, shape: {capsule: {radius: 0.02, length: "
                              "0.4}}}]]\n") +
                         options_);
  ASSERT_EQ(j["recordings"], 4);
  std::string names;
  for (const json& input : j["inputs"]) names += input["recording"].get<std::string>() + "\n";
  EXPECT_NE(names.find("foot"), 0u);
  EXPECT_NE(names.find(", tool hand_left/rod\n"), std::string::npos) << names;
  EXPECT_NE(names.find(", clothing torso 0.04 head 0.01"), std::string::npos) << names;
  EXPECT_EQ(ofPart(j["bands"], "torso")["runs"], 4);
}

TEST_F(MarginVariants, SaysWhatShareOfPeopleTheBodyEncloses) {
  const json j =
      runJson("tune " + plan("people: [{percentile: 5, sex: f}, {percentile: 95, sex: m}]\n") + options_);
  for (const json& row : j["proposed"]) {
    const json& all = row["enclosed_share"]["all_statures"];
    EXPECT_LT(all["min"], all["max"]) << row["part"];
    EXPECT_GT(all["max"], 0.9) << row["part"];
    EXPECT_LT(all["min"], 0.2) << row["part"];
  }
  // Of the body in the scene the same as `abstand human` says.
  const json human = runJson("human --height 1.75");
  const json scene = runJson("tune " + scene_ + options_);
  for (const json& part : human["parts"]) {
    const json& share = ofPart(scene["proposed"], part["name"])["enclosed_share"];
    EXPECT_EQ(share["at_stature"]["min"], part["enclosed_share"]);
    EXPECT_EQ(share["at_stature"]["max"], part["enclosed_share"]);
    EXPECT_EQ(share["all_statures"]["max"], part["enclosed_share_all_statures"]);
  }
}

TEST_F(MarginVariants, PlanRejectsUnknownKeysAndValues) {
  for (const std::string text :
       {"clothing: [{preset: tie}]\n", "tools: [[{name: t}]]\n", "tools: [{name: t}]\n",
        "places: [{shift: [1, 2]}]\n", "places: [{turns: 1}]\n", "mirror: [perhaps]\n"}) {
    const Answer answer = run("tune " + plan(text) + options_);
    EXPECT_EQ(answer.code, 3) << text;
    EXPECT_NE(answer.err.find("plan.yaml:3:"), std::string::npos) << answer.err;
  }
}

}  // namespace margin_variants_test
}  // namespace abstand::testing
