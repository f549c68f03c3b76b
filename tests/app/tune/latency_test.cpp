// Each share of the error by itself, in closed form.
#include "app/tune/latency.hpp"

#include <gtest/gtest.h>

#include "app/tune/closest_approach.hpp"
#include "humanmodel/part_uncertainty.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::tune {
namespace latency_test {

constexpr double kRounding = 1e-9;
constexpr double kLatency = 0.08;  // s

TunedRecording tuned(const testing::SlideSpeeds& speeds, const PassOptions& pass) {
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, speeds);
  TuneOptions options;
  options.pass = pass;
  return tuneRecording(*session, options, {}, "slide");
}

ClosestApproach torsoOf(const TunedRecording& recording, double calibration) {
  for (const ClosestApproach& c : closestApproaches({recording}, calibration))
    if (c.part == "torso") return c;
  throw std::runtime_error("no torso");
}

/// A person at 0.3 m/s: slower than the bound of 2 m/s.
constexpr testing::SlideSpeeds kSlow{.robot = 0.2, .person = 0.3, .seconds = 2.0};

TEST(Latency, TakesTheSpeedBoundTimesItself) {
  PassOptions pass;
  pass.latency = kLatency;
  const ClosestApproach with = torsoOf(tuned(kSlow, pass), 0.0), without = torsoOf(tuned(kSlow, {}), 0.0);
  EXPECT_EQ(without.latency, 0.0);
  EXPECT_NEAR(with.latency, kLatency * humanmodel::kPersonSpeed, kRounding);
  EXPECT_EQ(with.distance, without.distance) << "the measured distance stays";
  EXPECT_NEAR(with.pose, without.pose, kRounding);
  EXPECT_NEAR(with.clearance(), without.clearance() - with.latency, 1e-4);
}

TEST(Latency, TakesTheSpeedOfAPersonWhoIsFasterThanTheBound) {
  PassOptions pass;
  pass.latency = kLatency;
  constexpr double kFast = 5.0;
  const testing::SlideSpeeds fast{.robot = 0.01, .person = kFast, .stops_at = 0.2, .seconds = 0.5};
  // The whole person is shifted: each point at the same speed.
  EXPECT_NEAR(torsoOf(tuned(fast, pass), 0.0).latency, kLatency * kFast, 1e-6);
}

TEST(Latency, TakesTheBoundOfTheScene) {
  const testing::ScratchFolder folder;
  scene_file::SceneDescription scene = scene_file::loadScene(testing::writeSlide(folder, kSlow));
  scene.humans.front().settings.max_speed = 3.0;
  scene.humans.front().parts[humanmodel::BodyPart::kHead].max_speed = 0.1;
  session::SessionOptions options;
  options.threads = 1;
  options.cache = false;
  const auto session = depth::openSession(std::move(scene), options);
  const std::vector<double> latency = latencyUncertainty(*session, kLatency);
  const auto of = [&](const char* name) {
    ObjectId id(0);
    EXPECT_TRUE(session->scene().find(name, &id)) << name;
    return latency[id.index()];
  };
  EXPECT_NEAR(of("person/torso"), kLatency * 3.0, kRounding);
  EXPECT_NEAR(of("person/head"), kLatency * 0.3, 1e-6) << "recorded faster than the scene says";
  EXPECT_EQ(of("ball"), 0.0) << "the robot's pose is of now";
}

TEST(Latency, CoversWhatThePersonDidMeanwhile) {
  // What is shown at t was true kLatency ago: the true clearance is that of the person kLatency later, beside
  // the robot of t.
  const testing::SlideSpeeds speeds{.robot = 0.0, .person = 1.5, .seconds = 1.0};
  PassOptions pass;
  pass.latency = kLatency;
  const TunedRecording recording = tuned(speeds, pass);
  for (const PartClearance& part : recording.pass.parts) {
    const auto later = static_cast<std::size_t>(kLatency * speeds.rate + 0.5);
    for (std::size_t i = 0; i + later < part.track.frames(); ++i)
      ASSERT_LE(part.track.clearance[i], part.distance[i + later] + kRounding) << part.part << " " << i;
  }
}

TEST(ErrorShares, AddUpAndStandAlone) {
  struct Case {
    const char* name;
    PassOptions pass;
    double latency, calibration;
  };
  PassOptions late, apart, both;
  late.latency = both.latency = kLatency;
  apart.calibration_error = both.calibration_error = 0.03;
  const double expected = kLatency * humanmodel::kPersonSpeed;
  for (const Case& c : {Case{"none", {}, 0.0, 0.0}, Case{"latency", late, expected, 0.0},
                        Case{"calibration", apart, 0.0, 0.03}, Case{"both", both, expected, 0.03}}) {
    SCOPED_TRACE(c.name);
    const ClosestApproach got = torsoOf(tuned(kSlow, c.pass), c.pass.calibration_error);
    EXPECT_NEAR(got.latency, c.latency, kRounding);
    EXPECT_NEAR(got.calibration, c.calibration, kRounding);
    EXPECT_NEAR(got.pose, 0.0, kRounding) << "nothing is said of the tracker";
    EXPECT_LT(got.between_frames, 0.01 * (kSlow.robot + kSlow.person) + 3e-4) << "at most one frame's way";
    EXPECT_NEAR(got.error(), got.bound + c.latency + c.calibration + got.between_frames, kRounding);
  }
}

}  // namespace latency_test
}  // namespace abstand::tune
