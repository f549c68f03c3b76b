#include "ui/model/recording_review.hpp"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "tests/ui/fake_analysis.hpp"
#include "ui/model/event_text.hpp"

namespace abstand::ui {
namespace recording_review_test {

constexpr int kWaitMs = 60000;  // only a limit
using State = view::AnalysisNews::State;
using Kind = margin::ReviewEvent::Kind;

struct RecordingReviewTest : ::testing::Test {
  /// m, of parts; those of links are zero.
  void open(double margin) {
    std::vector<double> margins;
    for (const auto& object : session.outline().objects) margins.push_back(object.human ? margin : 0.0);
    review.open(&analysis, session.outline(), margins);
    review.pull();
  }
  int object(std::size_t part) const { return static_cast<int>(analysis.layout().parts[part].object); }
  bool settled() {
    const QSignalSpy changed(&review, &RecordingReview::changed);
    return QTest::qWaitFor([&] { return !changed.isEmpty(); }, kWaitMs);
  }

  FakeSession session;
  FakeAnalysis analysis{session.outline(), [this](std::size_t part, std::size_t frame) {
                          return valley(part, analysis.t(frame));
                        }};
  RecordingReview review;
};

TEST_F(RecordingReviewTest, GrowsWithAnalysis) {
  open(0.1);
  EXPECT_TRUE(review.available());
  ASSERT_TRUE(review.store());
  EXPECT_TRUE(review.store()->empty());
  EXPECT_TRUE(whatIfText(review).isEmpty());
  analysis.run(300);
  review.pull();
  EXPECT_EQ(review.state(), State::kRunning);
  EXPECT_EQ(review.store()->frames(), 256u) << "whole chunks";
  EXPECT_NEAR(review.progress(), 300.0 / 601.0, 1e-12);
  EXPECT_EQ(analysisText(review), "Analysis 49 %");
  EXPECT_TRUE(whatIfText(review).startsWith("So far: "));
  EXPECT_TRUE(momentText(review, 0, 11.0).contains("not analysed yet"));
  analysis.runAll();
  review.pull();
  EXPECT_EQ(review.state(), State::kDone);
  EXPECT_EQ(review.store()->frames(), analysis.frames());
  EXPECT_TRUE(analysisText(review).isEmpty());
}

TEST_F(RecordingReviewTest, FollowsMargins) {
  analysis.runAll();
  open(0.0);
  EXPECT_TRUE(review.review().events.empty());
  const double margin = 0.1;
  review.setMargin(object(2), margin);
  review.setMargin(object(4), margin);
  EXPECT_TRUE(review.review().events.empty()) << "judged once, later";
  ASSERT_TRUE(settled());
  std::vector<margin::ReviewEvent> inside;
  for (const auto& event : review.review().events)
    if (event.kind == Kind::kIntrusion) inside.push_back(event);
  ASSERT_EQ(inside.size(), 2u);
  for (const std::size_t n : {0u, 1u}) {
    const std::size_t part = n == 0 ? 2 : 4;
    EXPECT_EQ(inside[n].part, part);
    const double middle = 1.0 + 0.5 * static_cast<double>(part);
    const double half = (margin - 0.02 - 0.01 * static_cast<double>(part)) / 0.5;
    EXPECT_NEAR(inside[n].t0, middle - half, 1.01 * session.outline().frame_period);
    EXPECT_NEAR(inside[n].t1, middle + half, 1.01 * session.outline().frame_period);
    EXPECT_NEAR(inside[n].t_nearest, middle, 1e-9);
    EXPECT_EQ(review.marginOf(part, 0), margin);
  }
  EXPECT_EQ(review.review().outcome.stops, 2);
  EXPECT_TRUE(whatIfText(review).startsWith("2 stops, ")) << whatIfText(review).toStdString();
  review.setMargin(object(2), 0.0);
  review.setMargin(object(4), 0.0);
  ASSERT_TRUE(settled());
  EXPECT_TRUE(review.review().events.empty());
}

TEST_F(RecordingReviewTest, HasNearestPerFrameAndCommonMargin) {
  open(0.1);
  EXPECT_EQ(review.commonMargin(), 0.1);
  EXPECT_TRUE(std::isnan(review.nearest().at(2.0)));
  analysis.runAll();
  review.pull();
  for (const double t : {0.0, 2.0, 5.5, 12.0}) {
    double least = kInfinity;
    for (std::size_t part = 0; part < 14; ++part) least = std::min(least, valley(part, t));
    EXPECT_NEAR(review.nearest().at(t), least, 1e-6) << t;
  }
  review.setMargin(object(3), 0.2);
  EXPECT_FALSE(review.commonMargin());
}

TEST_F(RecordingReviewTest, GoesFromEventToEvent) {
  analysis.runAll();
  open(0.0);
  EXPECT_FALSE(review.nextEvent(0.0));
  review.setMargin(object(2), 0.1);
  review.setMargin(object(6), 0.05);
  ASSERT_TRUE(settled());
  // Part 2 comes inside; part 6 comes no nearer than 80 mm, which is near 50 mm.
  const auto first = review.nextEvent(0.0);
  ASSERT_TRUE(first);
  EXPECT_NEAR(*first, 2.0 - 0.06 / 0.5, session.outline().frame_period);
  const auto second = review.nextEvent(*first);
  ASSERT_TRUE(second);
  EXPECT_NEAR(*second, 4.0, 1e-9);
  EXPECT_FALSE(review.nextEvent(*second));
  EXPECT_EQ(review.previousEvent(*second), first);
  EXPECT_FALSE(review.previousEvent(*first));
}

TEST_F(RecordingReviewTest, NamesPairsOfOutline) {
  open(0.1);
  for (std::size_t part = 0; part < analysis.layout().parts.size(); ++part)
    for (std::size_t link = 0; link < analysis.layout().links.size(); ++link) {
      const int pair = review.pairOf(part, link);
      ASSERT_GE(pair, 0);
      const auto [a, b] = session.outline().pairs[static_cast<std::size_t>(pair)];
      EXPECT_EQ(std::minmax(a, b),
                std::minmax(object(part), static_cast<int>(analysis.layout().links[link].object)));
    }
  EXPECT_EQ(partText(*review.store(), 0), "torso");
  EXPECT_EQ(linkText(*review.store(), 1), "arm/link1");
}

TEST_F(RecordingReviewTest, IsEmptyAfterClosing) {
  analysis.runAll();
  open(0.2);
  EXPECT_FALSE(review.review().events.empty());
  review.open(nullptr, session.outline(), {});
  EXPECT_FALSE(review.available());
  EXPECT_FALSE(review.store());
  EXPECT_TRUE(review.review().events.empty());
  EXPECT_FALSE(review.nextEvent(0.0));
  EXPECT_TRUE(analysisText(review).isEmpty());
}

TEST_F(RecordingReviewTest, DescribesMoment) {
  FakeAnalysis gaps(session.outline(), [](std::size_t part, std::size_t) { return part == 1 ? kNaN : 0.05; });
  gaps.runAll();
  std::vector<double> margins(session.outline().objects.size(), 0.04);
  review.open(&gaps, session.outline(), margins);
  review.pull();
  EXPECT_EQ(
      momentText(review, 0, 2.0),
      "2.000 s, frame 101: torso – arm/link0: 60.0 mm ± 10.0 mm, so at least 50.0 mm; inside the margin of "
      "80.0 mm");
  EXPECT_EQ(momentText(review, 1, 2.0), "2.000 s, frame 101: head not seen");
  EXPECT_TRUE(nearestMomentText(review, 2.0).contains("head not seen")) << "never shown as farther";
}

/// Hands out what a test puts into it, as a server does that drops what is old.
struct HandedOut final : AnalysisPort {
  bool takeNews(view::AnalysisNews& out) override {
    out = news;
    return true;
  }
  view::AnalysisNews news;
};

TEST_F(RecordingReviewTest, ReplacedChunksLeaveNoEventsOfThoseThatWent) {
  // Not seen in the first chunk, and again near the end.
  FakeAnalysis gaps(session.outline(), [](std::size_t part, std::size_t frame) {
    return part == 1 && (frame < 100 || frame >= 560) ? kNaN : 0.5;
  });
  gaps.runAll();
  HandedOut port;
  ASSERT_TRUE(gaps.takeNews(port.news));
  ASSERT_EQ(port.news.chunks.size(), 3u);
  port.news.state = State::kLive;
  port.news.all = true;
  review.open(&port, session.outline(), std::vector<double>(session.outline().objects.size(), 0.0));
  const auto losses = [&] {
    review.pull();
    std::vector<double> begins;
    for (const RecordingEvent& event : review.events())
      if (event.kind == EventKind::kLost) begins.push_back(event.t0);
    return begins;
  };
  EXPECT_EQ(losses(), (std::vector<double>{gaps.t(0), gaps.t(560)}));
  port.news.chunks.erase(port.news.chunks.begin());
  EXPECT_EQ(losses(), (std::vector<double>{gaps.t(560)}));
}

}  // namespace recording_review_test
}  // namespace abstand::ui
