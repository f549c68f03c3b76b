#include "ui/model/time_axis.hpp"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "tests/ui/fake_session.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/time_text.hpp"

namespace abstand::ui {
namespace time_axis_test {

constexpr double kExact = 1e-12;  // s

struct TimeAxisTest : ::testing::Test {
  TimeAxisTest() { axis.open(1.0, 11.0, 0.01); }
  TimeAxis axis;
};

TEST_F(TimeAxisTest, ZoomKeepsFixedPoint) {
  EXPECT_FALSE(axis.zoomed());
  axis.zoom(0.5, 3.0);
  EXPECT_NEAR(axis.view().from, 2.0, kExact);
  EXPECT_NEAR(axis.view().to, 7.0, kExact);
  axis.zoomSteps(1.0, 2.0);
  EXPECT_NEAR(axis.view().from, 2.0, kExact);
  EXPECT_NEAR(axis.view().length(), 4.0, kExact);
  axis.zoom(1e-9, 5.0);
  EXPECT_NEAR(axis.view().length(), 0.04, kExact) << "four frames";
  axis.showAll();
  EXPECT_EQ(axis.view(), axis.whole());
  EXPECT_FALSE(axis.zoomed());
}

TEST_F(TimeAxisTest, StaysWithinRecording) {
  axis.zoom(0.2, 2.0);
  axis.pan(-5.0);
  EXPECT_EQ(axis.view().from, 1.0);
  axis.pan(50.0);
  EXPECT_NEAR(axis.view().to, 11.0, kExact);
  axis.zoom(100.0, 6.0);
  EXPECT_EQ(axis.view(), axis.whole());
  axis.setView({4.0, 5.0});
  axis.reveal(4.5);
  EXPECT_EQ(axis.view(), (TimeRange{4.0, 5.0}));
  axis.reveal(8.0);
  EXPECT_EQ(axis.view(), (TimeRange{7.0, 8.0}));
  axis.reveal(2.0);
  EXPECT_EQ(axis.view(), (TimeRange{2.0, 3.0}));
}

TEST_F(TimeAxisTest, HasRangeWithTwoEnds) {
  const QSignalSpy changes(&axis, &TimeAxis::rangeChanged);
  EXPECT_FALSE(axis.range());
  axis.setIn(3.0);
  EXPECT_EQ(axis.range(), (TimeRange{3.0, 11.0}));
  axis.setOut(5.0);
  EXPECT_EQ(axis.range(), (TimeRange{3.0, 5.0}));
  axis.setIn(6.0);
  EXPECT_EQ(axis.range(), (TimeRange{6.0, 11.0})) << "an OUT before IN is none";
  axis.setOut(2.0);
  EXPECT_EQ(axis.range(), (TimeRange{1.0, 2.0}));
  EXPECT_EQ(changes.size(), 4);
  axis.setRange(TimeRange{-4.0, 99.0});
  EXPECT_EQ(axis.range(), axis.whole());
  axis.setRange(TimeRange{5.0, 5.0});
  EXPECT_FALSE(axis.range());
  axis.setIn(3.0);
  axis.open(0.0, 2.0, 0.01);
  EXPECT_FALSE(axis.range());
}

TEST_F(TimeAxisTest, ShowsSingleMoment) {
  axis.open(2.0, 2.0, 0.01);
  axis.zoom(0.5, 2.0);
  axis.setIn(2.0);
  EXPECT_EQ(axis.view(), (TimeRange{2.0, 2.0}));
  EXPECT_FALSE(axis.range());
}

TEST(TimeFromText, ParsesSecondsMinutesAndFrames) {
  FakeSession session;
  Playback playback;
  playback.setPort(&session);
  const auto time = [&](const char* text) { return timeFromText(QString::fromUtf8(text), playback); };
  EXPECT_EQ(time("12.5"), 12.5);
  EXPECT_EQ(time("12,5"), 12.5);
  EXPECT_EQ(time(" 3 s "), 3.0);
  EXPECT_EQ(time("-0.5"), -0.5);
  EXPECT_EQ(time("1:02.5"), 62.5);
  EXPECT_EQ(time("f1"), 0.0);
  EXPECT_NEAR(*time("Bild 3"), 2 * playback.framePeriod(), kExact);
  EXPECT_NEAR(*time("frame 120"), 119 * playback.framePeriod(), kExact);
  EXPECT_NEAR(*time("F 3"), 2 * playback.framePeriod(), kExact);
  for (const char* wrong : {"", "f", "abc", "1:75", "12.5 m", "f1.5", "1e400", "nan"})
    EXPECT_FALSE(time(wrong)) << wrong;
}

}  // namespace time_axis_test
}  // namespace abstand::ui
