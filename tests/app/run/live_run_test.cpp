// Live mode against lock step: the same frames give the same forces, torques and distances.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "app/run/run_scene.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "tests/app/loop/slide_scene.hpp"
#include "tests/support/paths.hpp"

namespace abstand::run {
namespace live_run_test {

using testing::projectFile;
using testing::ScratchFolder;
using testing::SlideScene;

// Live groups start each query from the pair's last answer, so that nearest points may be others, within what
// queryPair() allows: 1 % beyond 0.1 m, and less than 1 mm below.
constexpr double kShareOfDistance = 0.01, kMinDistance = 1e-3;
// Of forces and torques, N and N m: sums of the same contacts.
constexpr double kShareOfForce = 1e-9, kMinForce = 1e-9;
constexpr int kFrames = 12;

using Row = std::map<std::string, std::string>;

std::vector<Row> readTable(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line, cell;
  std::vector<std::string> header;
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    Row row;
    std::size_t i = 0;
    while (std::getline(cells, cell, ',')) {
      if (rows.empty() && row.empty() && header.empty()) {
        header.push_back(cell);
        while (std::getline(cells, cell, ',')) header.push_back(cell);
        break;
      }
      row[header.at(i++)] = cell;
    }
    if (i > 0) rows.push_back(row);
  }
  return rows;
}

double number(const Row& row, const std::string& key) { return std::stod(row.at(key)); }

struct Tables {
  std::vector<Row> pairs, objects, joints;
  RunSummary summary;
};

Tables runTables(session::Session& session, RunMode mode, const ScratchFolder& folder) {
  RunOptions options;
  options.mode = mode;
  options.pace = LivePace::kSettled;
  const std::vector<double> all = session.frameTimes(1000.0);
  options.rate = all.back() > all.front() ? kFrames / (all.back() - all.front()) : 1.0;
  options.csv = {folder.path() / "pairs.csv", folder.path() / "objects.csv", folder.path() / "joints.csv"};
  Tables t;
  t.summary = runScene(session, options);
  t.pairs = readTable(options.csv.pairs);
  t.objects = readTable(options.csv.objects);
  t.joints = readTable(options.csv.joints);
  return t;
}

void expectNear(const Row& live, const Row& step, const std::string& key) {
  const double a = number(live, key), b = number(step, key);
  EXPECT_NEAR(a, b, std::max(kMinForce, kShareOfForce * std::abs(b))) << key << " at " << step.at("t");
}

class ShippedScene : public ::testing::TestWithParam<const char*> {};

TEST_P(ShippedScene, LiveModeMatchesLockStep) {
  const ScratchFolder folder;
  scene_file::SceneDescription scene =
      scene_file::loadScene(projectFile(std::string("data/scenes/") + GetParam() + ".yaml"));
  for (const scene_file::HumanDescription& human : scene.humans)
    if (!human.recording.file.empty() && !std::filesystem::exists(human.recording.file))
      GTEST_SKIP() << human.recording.file << " is not there";
  session::SessionOptions options;
  options.threads = 1;
  session::Session session(std::move(scene), options);
  const Tables step = runTables(session, RunMode::kLockstep, folder);
  const Tables live = runTables(session, RunMode::kLive, folder);

  ASSERT_EQ(live.pairs.size(), step.pairs.size());
  for (std::size_t i = 0; i < step.pairs.size(); ++i) {
    const Row &a = live.pairs[i], &b = step.pairs[i];
    const double distance = number(b, "distance");
    EXPECT_NEAR(number(a, "distance"), distance,
                std::max(kMinDistance, kShareOfDistance * std::abs(distance)));
    EXPECT_EQ(a.at("contacts"), b.at("contacts"));
    for (const char* key : {"fx", "fy", "fz", "tx", "ty", "tz"}) expectNear(a, b, key);
    EXPECT_EQ(a.at("age"), "0");
    EXPECT_EQ(b.count("age"), 0u) << "the columns of lock step are those of the contract";
  }
  ASSERT_EQ(live.objects.size(), step.objects.size());
  long with_forces = 0;
  for (std::size_t i = 0; i < step.objects.size(); ++i) {
    const Row &a = live.objects[i], &b = step.objects[i];
    EXPECT_EQ(a.at("colliding"), b.at("colliding")) << b.at("object") << " at " << b.at("t");
    for (const char* key : {"fx", "fy", "fz", "tx", "ty", "tz"}) expectNear(a, b, key);
    with_forces += b.at("colliding") == "1";
  }
  ASSERT_EQ(live.joints.size(), step.joints.size());
  for (std::size_t i = 0; i < step.joints.size(); ++i)
    for (const auto& [key, value] : step.joints[i]) expectNear(live.joints[i], step.joints[i], key);
  EXPECT_EQ(live.summary.contacts, step.summary.contacts);
  EXPECT_EQ(with_forces > 0, step.summary.contacts > 0);
  ASSERT_TRUE(live.summary.oldest_result || live.pairs.empty());
  if (live.summary.oldest_result) {
    EXPECT_EQ(live.summary.oldest_result->value, 0.0);
  }
  EXPECT_FALSE(step.summary.oldest_result);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScene,
                         ::testing::Values("arm6", "hug_alone", "hug_avoid", "hug_boxing", "hug_reach",
                                           "humanoid", "humanoid_self", "rail7", "rods", "spheres",
                                           "two_people"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(ShippedScenes, AreAllCompared) {
  std::size_t shipped = 0;
  for (const auto& entry : std::filesystem::directory_iterator(projectFile("data/scenes")))
    shipped += entry.path().extension() == ".yaml";
  EXPECT_EQ(shipped, 11u) << "a scene that is new belongs into the list above";
}

TEST(LiveRun, RealTimeHasContactForcesFromFirstFrame) {
  // The thing overlaps the ball by 2 cm and nothing moves, so that no machine is too slow.
  SlideScene s("{}", testing::thingAt([](double) { return 0.08; }));
  const ScratchFolder folder;
  RunOptions options;
  options.mode = RunMode::kLive;
  options.end = 0.05;
  options.rate = 100.0;
  options.csv.objects = folder.path() / "objects.csv";
  options.csv.joints = folder.path() / "joints.csv";
  options.csv.pairs = folder.path() / "pairs.csv";
  const RunSummary summary = runScene(*s.session, options);
  EXPECT_EQ(summary.frames, 6u);
  ASSERT_TRUE(summary.oldest_result);
  EXPECT_LE(summary.oldest_result->value, 0.05 + 1e-9);
  for (const Row& row : readTable(options.csv.objects)) {
    EXPECT_EQ(row.at("colliding"), "1");
    EXPECT_GT(std::abs(number(row, "fx")), 1.0);
  }
  for (const Row& row : readTable(options.csv.joints)) EXPECT_LT(number(row, "slide.effort0"), -1.0);
  for (const Row& row : readTable(options.csv.pairs)) {
    EXPECT_GE(number(row, "age"), 0.0);
    EXPECT_LE(number(row, "age"), 0.05 + 1e-9);
  }
}

}  // namespace live_run_test
}  // namespace abstand::run
