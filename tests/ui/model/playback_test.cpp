// The clock as the window sees it.
#include "ui/model/playback.hpp"

#include <gtest/gtest.h>

#include "tests/ui/fake_session.hpp"

namespace abstand::ui {
namespace playback_test {

struct PlaybackTest : ::testing::Test {
  void SetUp() override { playback.setPort(&session); }
  void pull() {
    view::SceneSnapshot snapshot;
    if (session.takeSnapshot(snapshot)) playback.onSnapshot(snapshot);
  }
  FakeSession session;
  Playback playback;
};

TEST_F(PlaybackTest, ShowsSeekAtOnceAndClampsIt) {
  playback.seek(3.0);
  EXPECT_EQ(playback.time(), 3.0);
  EXPECT_EQ(session.log.back(), "seek 3");
  playback.seek(99.0);
  EXPECT_EQ(playback.time(), playback.end());
  playback.seek(-1.0);
  EXPECT_EQ(playback.time(), playback.start());
}

TEST_F(PlaybackTest, IgnoresSnapshotsFromBeforeSeek) {
  view::SceneSnapshot old;
  session.takeSnapshot(old);
  playback.seek(3.0);
  playback.onSnapshot(old);
  EXPECT_EQ(playback.time(), 3.0);
  pull();
  EXPECT_EQ(playback.time(), 3.0);
  // But a session that went elsewhere is believed in the end.
  playback.seek(5.0);
  for (int i = 0; i < 100; ++i) playback.onSnapshot(old);
  EXPECT_EQ(playback.time(), old.t);
}

TEST_F(PlaybackTest, StepsAccumulateBeforeSessionAnswers) {
  playback.stepFrames(1);
  playback.stepFrames(1);
  playback.stepFrames(-1);
  playback.stepFrames(1);
  EXPECT_DOUBLE_EQ(playback.time(), 2.0 * playback.framePeriod());
  pull();
  EXPECT_DOUBLE_EQ(playback.time(), session.time());
  EXPECT_EQ(playback.frame(), 2);
}

TEST_F(PlaybackTest, PlayAtEndRestartsAndStepPauses) {
  playback.toEnd();
  playback.setPlaying(true);
  EXPECT_EQ(playback.time(), playback.start());
  EXPECT_TRUE(session.playing());
  playback.stepFrames(1);
  EXPECT_FALSE(playback.playing());
  EXPECT_FALSE(session.playing());
}

TEST_F(PlaybackTest, SpeedIsClamped) {
  playback.setSpeed(100.0);
  EXPECT_EQ(session.speed, Playback::kMaxSpeed);
  playback.setSpeed(1e-9);
  EXPECT_EQ(session.speed, Playback::kMinSpeed);
  playback.slower();
  EXPECT_EQ(playback.speed(), Playback::kMinSpeed);
  playback.setSpeed(1.0);
  playback.faster();
  EXPECT_EQ(playback.speed(), 1.5);
  playback.slower();
  EXPECT_EQ(playback.speed(), 1.0);
}

TEST_F(PlaybackTest, NothingMovesWithoutSession) {
  playback.setPort(nullptr);
  playback.setPlaying(true);
  playback.seek(1.0);
  playback.stepFrames(1);
  EXPECT_FALSE(playback.playing());
  EXPECT_EQ(playback.time(), 0.0);
}

}  // namespace playback_test
}  // namespace abstand::ui
