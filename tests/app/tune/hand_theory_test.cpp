// A hand that approaches at v and stops at d, and a robot that needs t to stop: margin, protective distance
// and speed of theory, each term by itself. Hand and robot are balls, so that every clearance has a closed
// form.
#include <gtest/gtest.h>

#include "app/tune/margin_table.hpp"
#include "app/tune/plan.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::tune {
namespace hand_theory_test {

// m: the engine's distances beyond 0.1 m are within 0.2 % of the true ones, and nearer within 10 um; searches
// between times end within 1e-4 m.
constexpr double kRelative = 2e-3, kEngine = 3e-4;
constexpr double kHand = 0.04, kRobot = 0.05;  // m, radii
constexpr double kApart = 1.4;                 // m, between the surfaces at the beginning

/// The right hand holds a ball that covers it as seen from the robot: on the robot's way, 0.9 m before the
/// person's middle.
std::unique_ptr<session::Session> openHand(const testing::ScratchFolder& folder,
                                           const testing::SlideSpeeds& speeds) {
  scene_file::SceneDescription scene = scene_file::loadScene(testing::writeSlide(folder, speeds));
  scene_file::ToolDescription ball;
  ball.name = "ball";
  ball.shape = geometry::Sphere{kHand};
  const humanmodel::HumanModel model = humanmodel::makeHuman({});
  const humanmodel::HumanPart& hand = model.part(humanmodel::BodyPart::kHandRight);
  const Vector3d centre = model.rest[hand.proximal] - hand.p_proximal;
  // The robot begins at x = -2.4 m.
  ball.X_HT.translation() = Vector3d(-2.4 + kRobot + kApart + kHand, 0.0, 1.2) - centre;
  scene.humans.front().tools.push_back(ball);
  session::SessionOptions options;
  options.threads = 1;
  options.cache = false;
  options.rest = 0.0;
  return depth::openSession(std::move(scene), options);
}

const PartClearance& handOf(const TunedRecording& tuned) {
  for (const PartClearance& part : tuned.pass.parts)
    if (part.part == "hand_right") return part;
  throw std::runtime_error("no right hand");
}

/// m, in step with the recording.
double clearanceAt(const testing::SlideSpeeds& s, double t) {
  return kApart - s.robot * t - s.person * std::min(t, s.stops_at);
}

struct MarginCase {
  const char* name;
  testing::SlideSpeeds speeds;
  BrakingOptions braking;
  double limit{0.0};

  /// m: how much nearer they come from a stop that is told at t until the robot rests. The hand may stop
  /// before.
  double travelled(double t) const {
    const double braking_time = speeds.robot / braking.deceleration;
    const double end = t + braking.reaction_time + braking_time;
    const double hand = speeds.person * (std::min(end, speeds.stops_at) - std::min(t, speeds.stops_at));
    return hand + speeds.robot * braking.reaction_time + 0.5 * speeds.robot * braking_time;
  }
  bool tooLate(double t) const { return clearanceAt(speeds, t) - travelled(t) <= limit; }
};

class HandTheory : public ::testing::TestWithParam<MarginCase> {};

TEST_P(HandTheory, TheMarginIsTheClearanceOneFrameBeforeTheFirstStopThatComesTooLate) {
  const MarginCase& c = GetParam();
  const testing::ScratchFolder folder;
  TuneOptions options;
  options.pass.braking = c.braking;
  options.pass.limit = c.limit;
  const TunedRecording tuned = tuneRecording(*openHand(folder, c.speeds), options, {}, "hand");
  const PartClearance& hand = handOf(tuned);
  std::size_t frame = 1;
  while (frame < hand.track.frames() && !c.tooLate(hand.track.t[frame])) ++frame;
  ASSERT_LT(frame, hand.track.frames());
  const double before = hand.track.t[frame - 1];
  const double expected = clearanceAt(c.speeds, before);
  // Otherwise it depends on the last digits which frame is the first one.
  const double at = hand.track.t[frame];
  ASSERT_GT(clearanceAt(c.speeds, before) - c.travelled(before) - c.limit, 2 * kEngine);
  ASSERT_LT(clearanceAt(c.speeds, at) - c.travelled(at) - c.limit, -2 * kEngine);
  const margin::SafeMargin safe = margin::smallestSafeMargin(hand.track, options.margins());
  ASSERT_TRUE(safe.decided);
  EXPECT_NEAR(safe.margin, expected, kRelative * expected + kEngine);
  EXPECT_NEAR(tuned.pass.parts.front().track.t[frame], at, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    EachTermByItself, HandTheory,
    ::testing::Values(
        // The robot's way while it reacts: 0.8 m/s for 0.25 s, with almost no braking.
        MarginCase{"robot_reacts", {.robot = 0.8, .rate = 97.0, .seconds = 2.0}, {0.25, 1e4}},
        // While it brakes: v^2 / 2 a.
        MarginCase{"robot_brakes", {.robot = 0.8, .rate = 97.0, .seconds = 2.0}, {0.0, 2.0}},
        // The hand's way while a slow robot reacts.
        MarginCase{"hand_while_it_reacts",
                   {.robot = 0.01, .person = 1.2, .rate = 93.0, .seconds = 1.3},
                   {0.25, 1e4}},
        // While it brakes.
        MarginCase{
            "hand_while_it_brakes", {.robot = 0.4, .person = 0.6, .rate = 97.0, .seconds = 1.5}, {0.0, 1.0}},
        // The limit alone.
        MarginCase{"limit", {.robot = 0.8, .rate = 97.0, .seconds = 2.0}, {0.0, 1e4}, 0.05},
        // A hand that stops 0.2 m before the robot would be there.
        MarginCase{"hand_stops",
                   {.robot = 0.5, .person = 1.0, .stops_at = 0.71, .rate = 97.0, .seconds = 2.0},
                   {0.2, 2.0}},
        MarginCase{"all", {.robot = 0.5, .person = 0.7, .rate = 250.0, .seconds = 1.6}, {0.1, 1.5}, 0.02}),
    [](const auto& c) { return c.param.name; });

TEST(HandTheory, AHandThatStopsShortNeedsNoMarginAndIsAsNearAsItStops) {
  constexpr double kShort = 0.3;  // m, between hand and robot in the end
  const testing::SlideSpeeds speeds{.robot = 0.2, .person = 1.0, .stops_at = 0.7, .seconds = 2.0};
  const testing::ScratchFolder folder;
  const TunedRecording tuned = tuneRecording(*openHand(folder, speeds), {}, {}, "hand");
  const PartClearance& hand = handOf(tuned);
  EXPECT_NEAR(hand.distance.back(), kShort, kRelative * kShort + kEngine);
  EXPECT_FALSE(margin::smallestSafeMargin(hand.track, {}).decided);
  const margin::MarginOutcome outcome = margin::outcome(hand.track, 0.5, {});
  EXPECT_EQ(outcome.missed_stops, 0);
  EXPECT_EQ(outcome.false_stops, outcome.stops);
}

struct SeparationCase {
  const char* name;
  double robot;  // m/s
  safety::SeparationOptions options;
};

/// Everything 0, so that terms stand alone.
safety::SeparationOptions nothing() {
  safety::SeparationOptions o;
  o.reaction_time = o.stopping_time = o.person_speed = o.person_speed_near = o.near = 0.0;
  return o;
}

safety::SeparationOptions with(void (*change)(safety::SeparationOptions&)) {
  safety::SeparationOptions o = nothing();
  change(o);
  return o;
}

class SeparationTheory : public ::testing::TestWithParam<SeparationCase> {};

TEST_P(SeparationTheory, IsTheSumOfTheTermsAndAllowsTheSpeedThatFits) {
  const SeparationCase& c = GetParam();
  const safety::SeparationOptions& o = c.options;
  const testing::SlideSpeeds speeds{.robot = c.robot, .seconds = std::floor(95.0 * kApart / c.robot) / 100.0};
  const testing::ScratchFolder folder;
  TuneOptions options;
  options.pass.separation = o;
  const TunedRecording tuned = tuneRecording(*openHand(folder, speeds), options, {}, "hand");
  const PartClearance& hand = handOf(tuned);
  std::size_t scaled = 0;
  for (std::size_t i = 0; i + 1 < hand.track.frames(); ++i) {
    const double distance = clearanceAt(speeds, hand.track.t[i]);
    const double tolerance = kRelative * distance + kEngine;
    // ISO/TS 15066:2016, 5.5.4: S_h + S_r + S_s + C + Z_d + Z_r, in closed form.
    const double stopping = o.deceleration > 0.0 ? c.robot / o.deceleration : o.stopping_time;
    const double needed = o.person_speed * (o.reaction_time + stopping) + c.robot * o.reaction_time +
                          0.5 * c.robot * stopping + o.intrusion + o.person_error + o.robot_error;
    ASSERT_NEAR(hand.separation.missing[i], needed - distance, tolerance) << hand.track.t[i];
    if (std::abs(needed - distance) < 2 * tolerance) continue;
    double speed = c.robot;
    if (distance < needed) {
      // The speed that makes the sum equal to the distance; without a term that grows with it there is none.
      const double constant = o.intrusion + o.person_error + o.robot_error + o.person_speed * o.reaction_time;
      if (o.deceleration > 0.0) {
        // v_h v / a + v T_r + v^2 / 2 a = d - constant.
        const double b = o.person_speed / o.deceleration + o.reaction_time;
        speed = distance > constant
                    ? o.deceleration * (-b + std::sqrt(b * b + 2.0 * (distance - constant) / o.deceleration))
                    : 0.0;
      } else {
        const double time = o.reaction_time + 0.5 * o.stopping_time;
        const double left = distance - constant - o.person_speed * o.stopping_time;
        speed = time > 0.0 && left > 0.0 ? left / time : 0.0;
      }
    }
    scaled += speed < c.robot;
    // Of the distance's tolerance, as d speed / d distance is at most 1 / T.
    const double slope = o.deceleration > 0.0 ? o.deceleration / c.robot * 2.0
                                              : 1.0 / std::max(0.05, o.reaction_time + 0.5 * o.stopping_time);
    ASSERT_NEAR(hand.separation.speed_scale[i] * c.robot, speed, slope * tolerance + kEngine)
        << hand.track.t[i];
  }
  EXPECT_GT(scaled, 3u) << "the rule was broken somewhere";
}

INSTANTIATE_TEST_SUITE_P(
    EachTermByItself, SeparationTheory,
    ::testing::Values(SeparationCase{"robot_reaction", 0.8, with([](auto& o) { o.reaction_time = 0.3; })},
                      SeparationCase{"robot_stopping", 0.8, with([](auto& o) { o.stopping_time = 0.5; })},
                      SeparationCase{"robot_deceleration", 0.8, with([](auto& o) { o.deceleration = 1.0; })},
                      SeparationCase{"intrusion", 0.5, with([](auto& o) { o.intrusion = 0.4; })},
                      SeparationCase{"person_error", 0.5, with([](auto& o) { o.person_error = 0.3; })},
                      SeparationCase{"robot_error", 0.5, with([](auto& o) { o.robot_error = 0.2; })},
                      SeparationCase{"person", 0.1, with([](auto& o) {
                                       o.person_speed = o.person_speed_near = 1.6, o.reaction_time = 0.3;
                                     })},
                      SeparationCase{"person_while_it_stops", 0.1, with([](auto& o) {
                                       o.person_speed = o.person_speed_near = 1.6, o.stopping_time = 0.3;
                                     })},
                      SeparationCase{"all", 0.6, with([](auto& o) {
                                       o.person_speed = o.person_speed_near = 1.6, o.reaction_time = 0.1,
                                       o.deceleration = 2.0, o.intrusion = 0.1, o.person_error = 0.05,
                                       o.robot_error = 0.02;
                                     })}),
    [](const auto& c) { return c.param.name; });

}  // namespace hand_theory_test
}  // namespace abstand::tune
