// What a depth camera would not see of people, over recordings.
#include "app/coverage/coverage.hpp"

#include <gtest/gtest.h>

#include "app/coverage/summary.hpp"
#include "core/base/error.hpp"
#include "humanmodel/human_model.hpp"
#include "tests/support/paths.hpp"
#include "tracking/table/skeleton_csv.hpp"

namespace abstand::coverage {
namespace coverage_test {

constexpr double kSpeed = 0.5, kRate = 10.0;  // m/s, Hz
constexpr int kFrames = 41;

struct CoverageTest : ::testing::Test {
  /// A person who stands upright at (0, y, 0) and moves along y, from -1 m to 1 m in 4 s; all joints, or
  /// those of the trunk alone.
  void write(const char* name, bool whole) const {
    tracking::Recording recording;
    for (int i = 0; i < kFrames; ++i) {
      humanmodel::SkeletonFrame frame = humanmodel::makeHuman({}).rest;
      frame.t = i / kRate;
      for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
        frame.p[j].y() += -1.0 + kSpeed * frame.t;
        if (!whole && j != static_cast<std::size_t>(humanmodel::Joint::kPelvis) &&
            j != static_cast<std::size_t>(humanmodel::Joint::kNeck))
          frame.state[j] = humanmodel::JointState::kMissing, frame.p[j].setConstant(kNaN);
      }
      recording.frames.push_back(frame);
    }
    tracking::writeSkeletonCsv(folder.path() / name, recording);
  }
  session::Session& open(const std::string& more, const char* recording = "walk.csv") {
    write("walk.csv", true);
    write("trunk.csv", false);
    session = std::make_unique<session::Session>(
        scene_file::parseScene("abstand: 1\ndefaults: {voxel: 0.1, point: 0.1}\npairs: {default: none}\n"
                               "humans:\n  - {name: anna, recording: {file: " +
                                   std::string(recording) + "}}\n" + more,
                               folder.path() / "scene.yaml"),
        session::SessionOptions{});
    return *session;
  }
  /// 4 m in front of the person's path, 1 m high, level.
  static CoverageOptions options() {
    CoverageOptions options;
    options.sensor = sensorNamed("kinect");
    options.sensor.camera.X_WC = tracking::lookingAt({4.0, 0.0, 1.0}, {0.0, 0.0, 1.0});
    return options;
  }
  static const PartCoverage& part(const Coverage& coverage, const std::string& name) {
    for (const PartCoverage& each : coverage.parts)
      if (each.name == name) return each;
    throw UsageError(name);
  }
  static PartSummary summary(const Coverage& coverage, const std::string& name) {
    return summarize(coverage.times, part(coverage, name).shares);
  }

  testing::ScratchFolder folder;
  std::unique_ptr<session::Session> session;
};

TEST_F(CoverageTest, EverythingIsSeenInTheOpen) {
  const Coverage coverage = evaluateCoverage(open(""), options());
  EXPECT_EQ(coverage.times.size(), 41u);
  EXPECT_EQ(coverage.parts.size(), humanmodel::kBodyPartCount);
  EXPECT_EQ(coverage.columns, 320);
  EXPECT_EQ(coverage.rows, 240);
  for (const PartCoverage& each : coverage.parts) {
    // Beside the middle, the trunk hides some of an arm.
    EXPECT_TRUE(isSeen(each.shares[20])) << each.name;
    const PartSummary found = summarize(coverage.times, each.shares);
    if (each.name == "anna/head" || each.name == "anna/torso") {
      EXPECT_EQ(shareOf(found.times, Cause::kSeen), 1.0f) << each.name;
      EXPECT_TRUE(found.spans.empty()) << each.name;
    }
    for (std::size_t k = 1; k < kCauses; ++k)
      if (static_cast<Cause>(k) != Cause::kSelf) EXPECT_EQ(found.surface[k], 0.0f) << each.name;
    for (const Shares& shares : each.shares) {
      float sum = 0.0f;
      for (const float share : shares) sum += share;
      EXPECT_NEAR(sum, 1.0f, 1e-5f);
    }
  }
}

TEST_F(CoverageTest, WallHidesWhoIsBehindIt) {
  // The wall covers y > 0 at x = 2, half way to the camera: the shadow on the path is y > 0, too. A part
  // whose middle is at y0 in the rest pose is there at t = 1 m / kSpeed - y0 / kSpeed.
  Coverage coverage = evaluateCoverage(
      open("objects:\n  - {name: wall, shape: {cuboid: {size: [0.02, 4, 4]}}, pose: {xyz: [2, 2, 0]}}\n"),
      options());
  // The rest pose is symmetric: head and torso are at y = 0.
  for (const char* name : {"anna/head", "anna/torso"}) {
    const PartSummary found = summary(coverage, name);
    ASSERT_EQ(found.spans.size(), 1u) << name;
    EXPECT_EQ(found.spans[0].cause, Cause::kThing);
    EXPECT_EQ(found.longest()->t1, coverage.times.back());
    // Hidden from 70 % of the surface on: after the middle, before the far rim, at most 0.25 m later.
    EXPECT_GE(found.spans[0].t0, 1.0 / kSpeed) << name;
    EXPECT_LE(found.spans[0].t0, (1.0 + 0.25) / kSpeed + 1.0 / kRate) << name;
    EXPECT_NEAR(shareOf(found.times, Cause::kThing), (4.0 - found.spans[0].t0 + 0.1) * kRate / kFrames, 0.01);
  }
  // At the time when the middle is at the edge, half of the surface is hidden.
  EXPECT_NEAR(shareOf(part(coverage, "anna/head").shares[20], Cause::kThing), 0.5f, 0.1f);
}

TEST_F(CoverageTest, CameraThatLooksAwaySeesNobody) {
  CoverageOptions away = options();
  away.sensor.camera.X_WC = tracking::lookingAt({4.0, 0.0, 1.0}, {8.0, 0.0, 1.0});
  CoverageOptions far = options();
  far.sensor.farthest = 3.0;
  session::Session& opened = open("");
  for (const auto& [with, cause] :
       {std::pair(away, Cause::kOutOfImage), std::pair(far, Cause::kOutOfRange)}) {
    const Coverage coverage = evaluateCoverage(opened, with);
    for (const PartCoverage& each : coverage.parts) {
      const PartSummary found = summarize(coverage.times, each.shares);
      EXPECT_EQ(shareOf(found.times, cause), 1.0f) << each.name;
      ASSERT_TRUE(found.longest());
      EXPECT_EQ(found.longest()->t0, coverage.times.front());
      EXPECT_EQ(found.longest()->t1, coverage.times.back());
    }
  }
}

TEST_F(CoverageTest, ArmBehindTrunkIsHiddenByThePerson) {
  // From the side, the far arm hangs behind the trunk.
  CoverageOptions side = options();
  side.sensor.camera.X_WC = tracking::lookingAt({0.0, 4.0, 1.0}, {0.0, 0.0, 1.0});
  const Coverage coverage = evaluateCoverage(open(""), side);
  const PartSummary left = summary(coverage, "anna/biceps_left"),
                    right = summary(coverage, "anna/biceps_right");
  // The rest pose faces +x: left is at y > 0, next to the camera.
  EXPECT_EQ(shareOf(left.times, Cause::kSeen), 1.0f);
  EXPECT_GT(shareOf(right.surface, Cause::kSelf), 0.5f);
  EXPECT_EQ(shareOf(right.surface, Cause::kThing) + shareOf(right.surface, Cause::kRobot), 0.0f);
}

TEST_F(CoverageTest, PartThatIsNotRecordedIsUnknown) {
  const Coverage coverage = evaluateCoverage(open("", "trunk.csv"), options());
  const PartSummary hand = summary(coverage, "anna/hand_left");
  EXPECT_EQ(shareOf(hand.times, Cause::kUnknown), 1.0f);
  EXPECT_EQ(shareOf(hand.times, Cause::kSeen), 0.0f);
}

TEST_F(CoverageTest, InterruptKeepsWhatIsDone) {
  CoverageOptions some = options();
  std::size_t done = 0;
  some.progress = [&](std::size_t n, std::size_t all) {
    done = n;
    EXPECT_EQ(all, 41u);
  };
  some.interrupted = [&] { return done == 5; };
  const Coverage coverage = evaluateCoverage(open(""), some);
  EXPECT_TRUE(coverage.interrupted);
  EXPECT_EQ(coverage.times.size(), 5u);
  EXPECT_EQ(coverage.parts[0].shares.size(), 5u);
}

TEST_F(CoverageTest, SceneWithoutPeopleIsRefused) {
  session::Session nobody(
      scene_file::parseScene(
          "abstand: 1\nobjects:\n  - {name: a, shape: {sphere: {radius: 0.2}}, voxel: 0.1, "
          "point: 0.1}\n",
          folder.path() / "scene.yaml"),
      session::SessionOptions{});
  EXPECT_THROW(evaluateCoverage(nobody, options()), UsageError);
  CoverageOptions blind = options();
  blind.sensor.farthest = blind.sensor.nearest;
  EXPECT_THROW(evaluateCoverage(open(""), blind), UsageError);
  CoverageOptions still = options();
  still.rate = 0.0;
  EXPECT_THROW(evaluateCoverage(open(""), still), UsageError);
}

/// Seen with this share; the rest is hidden by one cause.
Shares seen(float share, Cause rest) {
  Shares shares{};
  shares[0] = share;
  shares[static_cast<std::size_t>(rest)] += 1.0f - share;
  return shares;
}

TEST(Summary, SpansLastUntilThePartIsSeenAgain) {
  const std::vector<double> times{0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  const std::vector<Shares> shares{seen(0.31f, Cause::kRobot),     seen(0.29f, Cause::kRobot),
                                   seen(0.0f, Cause::kThing),      seen(1.0f, Cause::kThing),
                                   seen(0.0f, Cause::kOutOfImage), seen(1.0f, Cause::kSelf),
                                   seen(0.0f, Cause::kSelf)};
  const PartSummary found = summarize(times, shares);
  ASSERT_EQ(found.spans.size(), 3u);
  EXPECT_EQ(found.spans[0].t0, 0.1);
  EXPECT_EQ(found.spans[0].t1, 0.3);
  EXPECT_EQ(found.spans[0].cause, Cause::kThing) << "1.0 of it by the thing, 0.71 by the robot";
  EXPECT_EQ(found.spans[1].t0, 0.4);
  EXPECT_EQ(found.spans[1].t1, 0.5);
  EXPECT_EQ(found.spans[2].t0, 0.6);
  EXPECT_EQ(found.spans[2].t1, 0.6);
  EXPECT_EQ(found.longest(), &found.spans[0]);
  EXPECT_FLOAT_EQ(shareOf(found.times, Cause::kSeen), 3.0f / 7.0f);
  EXPECT_FLOAT_EQ(shareOf(found.times, Cause::kRobot), 1.0f / 7.0f);
  EXPECT_FLOAT_EQ(shareOf(found.times, Cause::kThing), 1.0f / 7.0f);
  EXPECT_FLOAT_EQ(shareOf(found.surface, Cause::kRobot), (0.69f + 0.71f) / 7.0f);
  EXPECT_FALSE(summarize({}, {}).longest());
}

}  // namespace coverage_test
}  // namespace abstand::coverage
