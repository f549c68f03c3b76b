#include "ui/model/play_rules.hpp"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "tests/ui/fake_analysis.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/time_axis.hpp"

namespace abstand::ui {
namespace play_rules_test {

struct PlayRulesTest : ::testing::Test {
  PlayRulesTest() {
    playback.setPort(&session);
    axis.open(session.outline().start, session.outline().end, session.outline().frame_period);
  }
  /// Shows every frame of `seconds` of play.
  void play(double seconds) {
    playback.setPlaying(true);
    for (double done = 0.0; done < seconds && playback.playing(); done += frame) {
      session.advance(frame);
      view::SceneSnapshot snapshot;
      if (session.takeSnapshot(snapshot)) playback.onSnapshot(snapshot);
    }
  }

  FakeSession session;
  const double frame = session.outline().frame_period;
  Playback playback;
  TimeAxis axis;
  RecordingReview review;
  PlayRules rules{playback, axis, review, nullptr};
};

TEST_F(PlayRulesTest, LoopsBetweenInAndOut) {
  axis.setRange(TimeRange{2.0, 3.0});
  playback.setLoop(true);
  playback.seek(2.5);
  play(3.2);
  EXPECT_TRUE(playback.playing());
  EXPECT_GE(playback.time(), 2.0);
  EXPECT_LE(playback.time(), 3.0 + frame);
  const auto seeks = std::count(session.log.begin(), session.log.end(), "seek 2");
  EXPECT_EQ(seeks, 3);
}

TEST_F(PlayRulesTest, RangeHasNoEffectWithoutLoop) {
  axis.setRange(TimeRange{2.0, 3.0});
  playback.seek(2.5);
  play(1.5);
  EXPECT_NEAR(playback.time(), 4.0, 2 * frame);
}

TEST_F(PlayRulesTest, RestartsAtInPoint) {
  axis.setRange(TimeRange{11.0, 12.0});
  playback.setLoop(true);
  playback.seek(11.5);
  play(2.0);
  EXPECT_GE(playback.time(), 11.0 - frame);
}

TEST_F(PlayRulesTest, PausesAtBeginningOfEvent) {
  FakeAnalysis analysis(session.outline(),
                        [&](std::size_t part, std::size_t i) { return valley(part, analysis.t(i)); });
  analysis.runAll();
  std::vector<double> margins(session.outline().objects.size(), 0.0);
  margins[analysis.layout().parts[2].object] = 0.1;
  margins[analysis.layout().parts[9].object] = 0.2;
  review.open(&analysis, session.outline(), margins);
  review.pull();
  const auto first = review.nextEvent(0.0);
  ASSERT_TRUE(first);
  const auto second = review.nextEvent(*first);
  ASSERT_TRUE(second);
  QSignalSpy paused(&rules, &PlayRules::pausedAt);
  play(6.0);
  EXPECT_TRUE(playback.playing()) << "only when it is asked for";
  playback.setPlaying(false);
  playback.seek(0.0);
  rules.setPauseOnEvents(true);
  for (const double event : {*first, *second}) {
    play(8.0);
    EXPECT_FALSE(playback.playing());
    EXPECT_EQ(playback.time(), event);
    EXPECT_EQ(session.time(), event);
  }
  EXPECT_EQ(paused.size(), 2);
}

}  // namespace play_rules_test
}  // namespace abstand::ui
