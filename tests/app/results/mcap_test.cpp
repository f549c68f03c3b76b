// MCAP files, read by a reader of their specification in Python.
#include "app/results/mcap_results.hpp"

#include <fstream>

#include "tests/app/program.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::results {
namespace mcap_test {

using testing::Answer;
using testing::json;

class Mcap : public testing::Cli {
 protected:
  Mcap() {
    ::setenv("ABSTAND_CACHE", (folder_.path() / "cache").c_str(), 1);
    for (int i = 0; i < 3; ++i) {
      testing::writeSlide(
          folder_, {.robot = 0.5, .person = 0.2 * i, .stops_at = kInfinity, .rate = 100.0, .seconds = 2.5},
          std::to_string(i));
      recordings_ += " " + file("person" + std::to_string(i) + ".csv");
    }
  }
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  void tune(const std::string& recordings) {
    const Answer a = run("tune " + file("slide.yaml") + " --recordings" + recordings + " --out " +
                         file("results") + " --quiet");
    ASSERT_EQ(a.code, 0) << a.err;
  }
  /// What the check in Python says of both exports.
  json checked(const std::string& arguments, const std::string& more = "") {
    const json counts = runJson("export " + file("results") + " --mcap " + file("a.mcap") + " --csv " +
                                file("a.csv") + arguments);
    const std::string command = std::string("'" ABSTAND_PYTHON "' -B '") +
                                testing::projectFile("tests/app/results/mcap_check.py").string() + "' " +
                                file("a.mcap") + " " + file("a.csv") + more + " >" + file("checked.json") +
                                " 2>" + file("checked.err");
    EXPECT_EQ(std::system(command.c_str()), 0) << readFile(file("checked.err"), 1 << 20, true);
    const json found = json::parse(readFile(file("checked.json"), 1 << 28, true), nullptr, false);
    EXPECT_EQ(counts["topics"], found["topics"].size());
    EXPECT_EQ(counts["rows"], found["rows"]);
    EXPECT_EQ(counts["messages"],
              found["rows"].get<int>() + found["events"].get<int>() + found["approaches"].get<int>());
    return found;
  }

  std::string recordings_;
};

TEST_F(Mcap, HoldsTableRows) {
  tune(recordings_);
  const json found = checked("");
  EXPECT_EQ(found["rows"], 3 * 251 * 14);
  EXPECT_GT(found["chunks"], 1) << "some chunks, so that their order is seen";
  EXPECT_EQ(found["topics"].size(), 3u * 14u + 1u);
  EXPECT_EQ(found["topics"][0], "/approaches");
  EXPECT_EQ(found["topics"][1], "/person0_csv/biceps_left");
  EXPECT_GT(found["approaches"], 0);
}

TEST_F(Mcap, HoldsEventsAtMargin) {
  tune(recordings_);
  const Answer events = run("events " + file("results") + " --margin 0.3 --json");
  write("events.json", events.out);
  EXPECT_GT(checked(" --margin 0.3", " " + file("events.json"))["events"], 0);
}

TEST_F(Mcap, OmitsUnknownClearances) {
  // The left hand is never seen.
  std::ifstream in(file("person1.csv"));
  std::ofstream out(file("blind.csv"));
  std::string line;
  std::vector<bool> hidden;
  for (bool header = true; std::getline(in, line); header = false) {
    std::istringstream cells(line);
    std::string cell;
    for (std::size_t i = 0; std::getline(cells, cell, ','); ++i) {
      if (header)
        hidden.push_back(cell.find("wrist_left") == 0 || cell.find("hand_left") == 0 ||
                         cell.find("elbow_left") == 0);
      out << (i > 0 ? "," : "") << (header || !hidden[i] ? cell : "");
    }
    out << '\n';
  }
  out.close();
  tune(" " + file("blind.csv"));
  const json found = checked("");
  EXPECT_GE(found["unseen"], 251) << "a part that is never seen has no clearance";
  EXPECT_LT(found["unseen"], found["rows"]);
}

TEST_F(Mcap, ShiftsNegativeTimesToZero) {
  std::ifstream in(file("person1.csv"));
  std::ofstream out(file("early.csv"));
  std::string line;
  std::getline(in, line);
  out << line << '\n';
  while (std::getline(in, line)) {
    const auto comma = line.find(',');
    out << formatDouble(std::stod(line) - 1.25) << line.substr(comma) << '\n';
  }
  out.close();
  tune(" " + file("early.csv"));
  EXPECT_EQ(checked("")["topics"].size(), 15u);
}

TEST_F(Mcap, IsWrittenAtomicallyAndReproducibly) {
  tune(recordings_);
  const std::string command = "export " + file("results") + " --mcap ";
  EXPECT_EQ(run(command + file("x.mcap")).code, 0);
  EXPECT_EQ(run(command + file("y.mcap")).code, 0);
  EXPECT_EQ(readFile(file("x.mcap")), readFile(file("y.mcap")));
  EXPECT_EQ(run(command + "/dev/full").code, 4);
  EXPECT_EQ(run("export " + file("results")).code, 2) << "nothing to write";
  EXPECT_EQ(run("export " + file("results") + " --csv " + file("z.csv") + " --margin 0.2").code, 2);
}

TEST(TopicNames, AreShortPlainAndUnique) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(topicNames({"/data/a/reach.bvh", "/data/b/walk.bvh, height 1.62, f"}),
            (Names{"/a/reach_bvh", "/b/walk_bvh_height_1_62_f"}));
  EXPECT_EQ(topicNames({"/data/a/reach.bvh"}), Names{"/reach_bvh"});
  EXPECT_EQ(topicNames({"a b.bvh", "a_b.bvh", "a.b.bvh"}), (Names{"/a_b_bvh", "/a_b_bvh_2", "/a_b_bvh_3"}));
  EXPECT_EQ(topicNames({"x", "x"}), (Names{"/x", "/x_2"}));
  EXPECT_EQ(topicNames({"d/", "d/.."}), (Names{"/recording", "/recording_2"}));
  EXPECT_EQ(topicNames({}), Names{});
}

}  // namespace mcap_test
}  // namespace abstand::results
