// The last ten minutes: exact moments, bounded memory, what is stale, and servers that start again.
#include "app/viewer/live_record.hpp"

#include <gtest/gtest.h>

#include "tests/app/viewer/example_moment.hpp"

namespace abstand::viewer {
namespace live_record_test {

using moment::exampleCard;
using moment::exampleFrame;
using moment::exampleMoment;

struct LiveRecordTest : ::testing::Test {
  LiveRecord record;
  /// A moment at `t` (s, server), which arrives at `now`.
  bool add(double t, double now) {
    const auto moment = exampleMoment(t, 0.001 * t);
    return record.add(exampleFrame(moment), moment, now);
  }
  /// Distance of pair 0 in a copied frame, m.
  double distance(const LiveRecord::Copy& copy) {
    moment::Moment read = moment::makeMoment(exampleCard());
    EXPECT_TRUE(moment::readMoment(copy.frame, read));
    EXPECT_EQ(read.shown.t, copy.t);
    return read.shown.pairs[0].result.distance;
  }
};

TEST(MomentRing, DropsTheOldestAfterTenMinutes) {
  MomentRing ring;
  const auto frame = exampleFrame(exampleMoment(1.0));
  for (int i = 0; i <= 700; ++i) EXPECT_TRUE(ring.add(i, frame));
  EXPECT_EQ(ring.size(), 601u);
  EXPECT_EQ(ring.time(ring.begin()), 100.0);
  EXPECT_EQ(ring.begin(), 100u);  // numbers stay with their moments
  EXPECT_EQ(ring.time(ring.end() - 1), 700.0);
  EXPECT_EQ(ring.bytes(), 601 * frame.size());
  EXPECT_FALSE(ring.add(700.0, frame));
  EXPECT_EQ(ring.at(350.5), 350u);
  EXPECT_EQ(ring.at(0.0), 100u);
  EXPECT_EQ(ring.at(1e9), 700u);
}

TEST(MomentRing, StaysWithinItsMemory) {
  const auto frame = exampleFrame(exampleMoment(1.0));
  MomentRing ring({600.0, 10 * frame.size() + 1});
  for (int i = 0; i < 1000; ++i) {
    ring.add(0.01 * i, frame);
    EXPECT_LE(ring.bytes(), 10 * frame.size() + 1);
  }
  EXPECT_EQ(ring.size(), 10u);
  ring.clear();
  EXPECT_TRUE(ring.empty());
  EXPECT_FALSE(ring.at(1.0));
  // 100 bytes a moment, 6000 in ten minutes: 10 Hz.
  EXPECT_DOUBLE_EQ(MomentRing::rateFor({600.0, 600000}, 100, 30.0), 10.0);
  EXPECT_DOUBLE_EQ(MomentRing::rateFor({600.0, 6000000}, 100, 30.0), 30.0);
}

TEST_F(LiveRecordTest, RewindsToTheExactMoment) {
  ASSERT_TRUE(record.begin(exampleCard(), LinkState::kConnected, 0.0));
  // Ten moments a second, all of which are kept, for eleven minutes.
  for (int i = 1; i <= 6600; ++i) ASSERT_TRUE(add(0.1 * i, 0.1 * i));
  const LiveRecord::Span span = record.span();
  EXPECT_DOUBLE_EQ(span.last, 660.0);
  EXPECT_NEAR(span.first, 60.0, 1e-9);
  EXPECT_EQ(span.kept, 6001u);
  LiveRecord::Copy copy;
  ASSERT_TRUE(record.copyAt(0.1 * 1234 + 0.05, 0, copy));
  EXPECT_EQ(copy.t, 0.1 * 1234);
  EXPECT_EQ(copy.frame, exampleFrame(exampleMoment(0.1 * 1234, 0.001 * (0.1 * 1234))));
  // The next, and those beyond the ends.
  ASSERT_TRUE(record.copyAt(copy.t, 1, copy));
  EXPECT_EQ(copy.t, 0.1 * 1235);
  ASSERT_TRUE(record.copyAt(0.0, -5, copy));
  EXPECT_EQ(copy.t, span.first);
  ASSERT_TRUE(record.copyAt(1e6, 5, copy));
  EXPECT_EQ(copy.t, span.last);
}

TEST_F(LiveRecordTest, MemoryIsFlat) {
  record.begin(exampleCard(), LinkState::kConnected, 0.0);
  std::size_t most = 0;
  for (int i = 1; i <= 60 * 60 * 13; ++i) {
    add(i / 60.0, i / 60.0);
    if (i > 60 * 60 * 11) {
      EXPECT_LE(record.span().bytes, most);
    }
    most = std::max(most, record.span().bytes);
  }
  // 60 moments a second come, 30 are kept: of thirteen minutes the last ten.
  EXPECT_NEAR(static_cast<double>(record.span().kept), 600.0 * LiveRecord::kKeptRate, 2.0);
}

TEST_F(LiveRecordTest, StaleAfterHalfASecondOfSilence) {
  EXPECT_TRUE(record.status(0.0).stale());
  record.begin(exampleCard(), LinkState::kConnected, 10.0);
  add(1.0, 10.0);
  EXPECT_FALSE(record.status(10.5).stale());
  EXPECT_TRUE(record.status(10.51).stale());
  record.alive(10.6);
  EXPECT_FALSE(record.status(11.0).stale());
  EXPECT_NEAR(record.status(11.0).moment_age, 1.0, 1e-12);
  record.end(LinkState::kConnecting, true);
  EXPECT_TRUE(record.status(11.0).stale());
  EXPECT_EQ(record.status(11.0).damaged, 1);
}

TEST_F(LiveRecordTest, CountsMomentsOfTheLastSecond) {
  record.begin(exampleCard(), LinkState::kConnected, 0.0);
  for (int i = 1; i <= 120; ++i) add(i / 60.0, i / 60.0);
  EXPECT_NEAR(record.status(2.0).rate, 60.0, 1.0);
  EXPECT_EQ(record.status(9.0).rate, 0.0);
}

TEST_F(LiveRecordTest, AServerThatStartsAgainContinuesTheTime) {
  record.begin(exampleCard(1), LinkState::kConnected, 0.0);
  add(100.0, 50.0);
  record.end(LinkState::kConnecting, false);
  ASSERT_TRUE(record.begin(exampleCard(2), LinkState::kConnected, 53.0));
  ASSERT_TRUE(add(0.25, 54.0));  // 4 s later
  LiveRecord::Copy copy;
  ASSERT_TRUE(record.copyNewest(copy));
  EXPECT_NEAR(copy.t, 104.0, 1e-12);
  distance(copy);  // the frame says the same time
  // The same server again: its own clock.
  record.begin(exampleCard(2), LinkState::kConnected, 55.0);
  ASSERT_TRUE(add(1.25, 55.0));
  record.copyNewest(copy);
  EXPECT_NEAR(copy.t, 105.0, 1e-12);
}

TEST_F(LiveRecordTest, AnotherSceneIsNotFollowed) {
  record.begin(exampleCard(1), LinkState::kConnected, 0.0);
  add(1.0, 0.0);
  auto other = exampleCard(2);
  other.objects[2] = "door";
  EXPECT_FALSE(record.begin(other, LinkState::kConnected, 1.0));
  EXPECT_EQ(record.status(1.0).state, LinkState::kOtherScene);
  EXPECT_TRUE(record.status(1.0).stale());
  other = exampleCard(2);
  other.scene.low ^= 1;
  EXPECT_FALSE(record.begin(other, LinkState::kConnected, 1.0));
}

TEST_F(LiveRecordTest, ChangesOfStopStatesAreLogged) {
  record.begin(exampleCard(), LinkState::kConnected, 0.0);
  const auto add_state = [&](double t, safety::StopState state, double since) {
    auto moment = exampleMoment(t);
    moment.shown.robots[0].state = state;
    moment.shown.robots[0].since = since;
    record.add(exampleFrame(moment), moment, t);
  };
  add_state(1.0, safety::StopState::kRunning, 0.5);
  add_state(2.0, safety::StopState::kRunning, 0.5);
  add_state(3.0, safety::StopState::kProtectiveStop, 2.5);
  add_state(4.0, safety::StopState::kProtectiveStop, 2.5);
  add_state(5.0, safety::StopState::kRunning, 4.75);
  std::vector<view::RobotSnapshot> robots(1);
  record.copyLogs(robots);
  const safety::StopLog& log = robots[0].log;
  ASSERT_EQ(log.count(), 2u);
  EXPECT_EQ(log.entry(0).t, 2.5);
  EXPECT_EQ(log.entry(0).from, safety::StopState::kRunning);
  EXPECT_EQ(log.entry(0).to, safety::StopState::kProtectiveStop);
  EXPECT_EQ(log.entry(0).cause.reason, safety::StopReason::kDistance);
  EXPECT_EQ(log.entry(0).lasted, 2.0);
  EXPECT_EQ(log.entry(1).t, 4.75);
  EXPECT_EQ(log.entry(1).lasted, 2.25);
}

TEST_F(LiveRecordTest, PlotSamplesComeOnceAndAgain) {
  record.begin(exampleCard(), LinkState::kConnected, 0.0);
  for (int i = 1; i <= 10; ++i) add(i, i);
  std::vector<view::PlotSample> samples;
  record.drainPlot(samples);
  ASSERT_EQ(samples.size(), 10u);
  EXPECT_EQ(samples[4].t, 5.0);
  EXPECT_EQ(samples[4].min_distance, -0.01);  // of pair 1; that of pair 2 is not known
  EXPECT_EQ(samples[4].nearest_pair, 1);
  EXPECT_NEAR(samples[4].contact_force, Vector3d(1.1, 2.2, 3.3).norm(), 1e-12);
  EXPECT_EQ(samples[4].virtual_force, 0.0);
  samples.clear();
  record.drainPlot(samples);
  EXPECT_TRUE(samples.empty());
  record.replayPlot();
  record.drainPlot(samples);
  EXPECT_EQ(samples.size(), 10u);
}

}  // namespace live_record_test
}  // namespace abstand::viewer
