// Distances of single bodies and pairs over time.
#include "ui/model/watched_series.hpp"

#include <gtest/gtest.h>

#include <QMimeData>
#include <cmath>
#include <memory>

#include "tests/ui/fake_analysis.hpp"
#include "ui/model/recording_review.hpp"

namespace abstand::ui {
namespace watched_series_test {

constexpr double kQuantum = 1e-3;  // m: the store rounds

struct WatchedSeriesTest : ::testing::Test {
  FakeSession session;
  WatchedSeries watched;
};

TEST_F(WatchedSeriesTest, OfABodyTheNearestOfItsPairs) {
  watched.open(session.outline(), false);
  const int hand = session.indexOf("operator/hand_left");
  watched.setSelected({hand}, -1);
  ASSERT_EQ(watched.lines().size(), 1U);
  EXPECT_EQ(watched.lines()[0].name, "operator/hand_left");
  view::SceneSnapshot moment;
  session.seek(2.0);
  ASSERT_TRUE(session.takeSnapshot(moment));
  watched.add(moment);
  double least = kInfinity;
  for (std::size_t p = 0; p < moment.pairs.size(); ++p) {
    const auto [a, b] = session.outline().pairs[p];
    const auto& one = session.outline().objects[static_cast<std::size_t>(a)];
    if (b == hand && one.group == "arm") least = std::min(least, moment.pairs[p].result.distance);
  }
  EXPECT_EQ(watched.lines()[0].series->at(2.0), least);
  EXPECT_TRUE(std::isnan(watched.lines()[0].series->at(5.0))) << "not played yet";
}

TEST_F(WatchedSeriesTest, BodyPartsComeFromTheWholeRecording) {
  FakeAnalysis analysis(session.outline(), [this](std::size_t part, std::size_t frame) {
    return valley(part, session.outline().frame_period * static_cast<double>(frame));
  });
  RecordingReview review;
  review.open(&analysis, session.outline(), std::vector<double>(session.outline().objects.size(), 0.0));
  watched.open(session.outline(), true);
  watched.pin({{Watched::Kind::kBody, static_cast<int>(analysis.layout().parts[3].object)}});
  analysis.run(200);
  review.pull();
  watched.add(review);
  analysis.runAll();
  review.pull();
  watched.add(review);
  const FrameSeries& series = *watched.lines().at(0).series;
  for (const double t : {0.5, 2.5, 8.0}) EXPECT_NEAR(series.at(t), valley(3, t), kQuantum) << t;
}

TEST_F(WatchedSeriesTest, PinnedOnesStayAndTheSelectionGoes) {
  watched.open(session.outline(), false);
  watched.setSelected({0}, -1);
  watched.pin({{Watched::Kind::kPair, 3}});
  watched.setSelected({1}, -1);
  ASSERT_EQ(watched.lines().size(), 2U);
  EXPECT_TRUE(watched.lines()[0].pinned);
  EXPECT_EQ(watched.lines()[1].name, "arm/link1");
  watched.setSelected({0, 1, 2}, -1);
  EXPECT_EQ(watched.lines().size(), 1U) << "a whole robot is not drawn";
  watched.pin({{Watched::Kind::kBody, -1}, {Watched::Kind::kBody, 9999}});
  EXPECT_EQ(watched.lines().size(), 1U);
  watched.unpinAll();
  EXPECT_TRUE(watched.lines().empty());
}

TEST(WatchedMime, ComesBackAsItWas) {
  const std::vector<Watched> sent{{Watched::Kind::kBody, 7}, {Watched::Kind::kPair, 120}};
  const std::unique_ptr<QMimeData> data(mimeOf(sent));
  EXPECT_EQ(watchedIn(*data), sent);
  QMimeData other;
  other.setText("body 7");
  EXPECT_TRUE(watchedIn(other).empty());
}

}  // namespace watched_series_test
}  // namespace abstand::ui
