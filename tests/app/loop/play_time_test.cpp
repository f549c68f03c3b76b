// Playing keeps to wall time, on a real session with a clock of the test.
#include <gtest/gtest.h>

#include <cmath>

#include "app/loop/live_session.hpp"
#include "tests/app/loop/manual_clock.hpp"
#include "tests/app/loop/slide_scene.hpp"

namespace abstand::loop {
namespace play_time_test {

using testing::ManualClock;
using testing::ManualTime;
using testing::SlideScene;
using testing::thingComesTo;

constexpr double kEnd = 3.0;  // s, of the scene

/// A session that plays the slide's scene on manual time.
struct Playing {
  Playing(double look, double t, bool react, double speed)
      : time(look),
        slide("{repulsion: {range: 0.2, force: 100}}", thingComesTo(0.05)),
        live(
            std::make_unique<LiveSession>(std::move(slide.session), t, std::make_unique<ManualClock>(time))) {
    live->send(command::React{react});
    live->send(command::Speed{speed});
    // The loop is through with the commands when it has been round once more.
    begun = time.runTo(time.runTo(0.0) + 1e-3);
    live->send(command::Play{true});
  }
  ~Playing() {
    time.release();
    live.reset();
  }
  /// Seconds of wall time that have passed, `wall` at least.
  double runFor(double wall) {
    const double now = time.runTo(begun + wall);
    live->takeSnapshot(seen);
    return now - begun;
  }

  ManualTime time;
  SlideScene slide;
  std::unique_ptr<LiveSession> live;
  view::SceneSnapshot seen;
  double begun{0.0};
};

struct Pace {
  const char* name;
  double look;   ///< s that a look at the clock takes, and so a cycle
  double speed;  ///< asked for
  double wall;   ///< s
};

class PlayTime : public ::testing::TestWithParam<Pace> {
 protected:
  /// s of scene time: what the last snapshot may be behind, as one is published every few rounds.
  static double allowed(const Pace& p) { return p.speed * (0.008 + 6.0 * p.look); }
};

TEST_P(PlayTime, RecordedMotionKeepsWallTime) {
  const Pace& p = GetParam();
  Playing playing(p.look, 0.0, false, p.speed);
  const double wall = playing.runFor(p.wall);
  EXPECT_TRUE(playing.seen.playing);
  EXPECT_NEAR(playing.seen.t, p.speed * wall, allowed(p));
  EXPECT_NEAR(playing.seen.real_time_factor, p.speed, 0.02 * p.speed + allowed(p));
}

TEST_P(PlayTime, LoopingLosesNoTime) {
  const Pace& p = GetParam();
  Playing playing(p.look, kEnd - 0.25 * p.speed, false, p.speed);
  const double wall = playing.runFor(p.wall);
  EXPECT_NEAR(playing.seen.t, p.speed * (wall - 0.25), allowed(p));
}

TEST_P(PlayTime, OverrunsCountChosenStep) {
  const Pace& p = GetParam();
  Playing playing(p.look, 0.0, false, p.speed);
  playing.runFor(p.wall);
  EXPECT_GE(playing.seen.step_s, p.look);
  EXPECT_GT(playing.seen.played_cycles, 2);
  EXPECT_LE(playing.seen.overruns, 1) << "of the first step, before it was chosen";
}

INSTANTIATE_TEST_SUITE_P(Paces, PlayTime,
                         ::testing::Values(Pace{"quick", 1e-6, 1.0, 2.0}, Pace{"slow_motion", 1e-6, 0.5, 2.0},
                                           Pace{"fast", 1e-6, 2.0, 1.0}, Pace{"busy", 3e-4, 1.0, 2.0},
                                           Pace{"always_late", 5e-3, 1.0, 2.0},
                                           Pace{"very_late", 3e-2, 1.0, 2.0}),
                         [](const auto& pace) { return std::string(pace.param.name); });

TEST(PlayTimeClosedLoop, KeepsWallTimeIfFastEnough) {
  for (const double speed : {0.5, 1.0, 2.0}) {
    Playing playing(5e-5, 0.0, true, speed);
    const double wall = playing.runFor(1.2);
    EXPECT_NEAR(playing.seen.t, speed * wall, 0.01 * speed) << speed;
    EXPECT_NEAR(playing.seen.real_time_factor, speed, 0.03 * speed);
    EXPECT_EQ(playing.seen.overruns, 0);
    EXPECT_EQ(playing.seen.step_s, 1e-3 / speed);
  }
}

TEST(PlayTimeClosedLoop, SlowCyclesReduceRealTimeFactor) {
  Playing playing(5e-3, 0.0, true, 1.0);
  const double first_wall = playing.runFor(1.0);
  const double first_t = playing.seen.t;
  const double wall = playing.runFor(5.0);
  const double true_factor = (playing.seen.t - first_t) / (wall - first_wall);
  EXPECT_LT(true_factor, 0.2) << "5 ms of work and more for a millisecond of the scene";
  EXPECT_GT(true_factor, 0.02);
  EXPECT_NEAR(playing.seen.real_time_factor, true_factor, 0.1 * true_factor);
  EXPECT_EQ(playing.seen.overruns, playing.seen.played_cycles);
}

TEST(PlayTimeClosedLoop, ShortStallIsCaughtUpLongOneDropped) {
  PlayPace pace;
  pace.start(0.0);
  pace.advance(0.2, 1.0);
  pace.limitLag(1.0, 0.0);
  EXPECT_DOUBLE_EQ(pace.due(), 0.2);
  pace.played(0.2);
  pace.advance(10.0, 1.0);
  pace.limitLag(1.0, 0.0);
  EXPECT_EQ(pace.due(), 0.0);
  EXPECT_NEAR(pace.factor(), 0.02, 1e-12);
}

TEST(PlayTimeClosedLoop, NoFactorWhilePaused) {
  Playing playing(1e-6, 0.0, false, 1.0);
  playing.runFor(1.0);
  EXPECT_FALSE(std::isnan(playing.seen.real_time_factor));
  playing.live->send(command::Play{false});
  playing.runFor(1.1);
  const double t = playing.seen.t;
  EXPECT_TRUE(std::isnan(playing.seen.real_time_factor));
  // A pause is no lag: playing goes on where it was.
  playing.runFor(3.0);
  playing.live->send(command::Play{true});
  playing.runFor(3.5);
  EXPECT_NEAR(playing.seen.t, t + 0.5, 0.01);
}

}  // namespace play_time_test
}  // namespace abstand::loop
