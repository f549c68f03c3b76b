// The series behind time strip and plots.
#include "ui/model/frame_series.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "ui/model/run_history.hpp"

namespace abstand::ui {
namespace frame_series_test {

TEST(FrameSeries, KeepsExtremePerFrameAndRestartsOnReplay) {
  FrameSeries series(1.0, 2.0, 0.1, Keep::kSmallest);
  ASSERT_EQ(series.size(), 11u);
  series.add(1.30, 0.5);
  series.add(1.31, 0.2);
  series.add(1.29, 0.4);
  EXPECT_EQ(series.at(1.3), 0.2);
  series.add(1.4, 0.9);
  series.add(1.3, 0.7);  // played again, with wider margins or other poses
  EXPECT_EQ(series.at(1.3), 0.7);
  EXPECT_TRUE(std::isnan(series.at(1.5)));
}

TEST(FrameSeries, IgnoresOutOfRangeAndNonFiniteValues) {
  FrameSeries series(0.0, 1.0, 0.1, Keep::kLargest);
  for (const double t : {-1.0, 1.2, 1e300, std::nan("")}) series.add(t, 1.0);
  series.add(0.5, std::nan(""));
  series.add(0.5, INFINITY);
  EXPECT_EQ(series.revision(), 0);
  EXPECT_TRUE(std::isnan(series.between(0.0, 1.0).high));
}

TEST(FrameSeries, SizeIsBoundedForAnyDuration) {
  EXPECT_LE(FrameSeries(0.0, 1e12, 1e-9, Keep::kSmallest).size(), FrameSeries::kMaxFrames);
  FrameSeries live(0.0, 0.0, 0.001, Keep::kLargest);
  for (int i = 0; i < 1200000; ++i) live.add(i * 0.001, i);
  EXPECT_LE(live.size(), FrameSeries::kMaxFrames);
  EXPECT_EQ(live.at(1199.999), 1199999.0);
  live.add(1e9, 5.0);  // a jump far ahead
  EXPECT_LE(live.size(), FrameSeries::kMaxFrames);
  EXPECT_EQ(live.at(1e9), 5.0);
}

TEST(Decimation, KeepsExtremesInTwoPointsPerColumn) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (const int n : {50, 999, 20000}) {
    FrameSeries series(0.0, n * 0.01, 0.01, Keep::kSmallest);
    for (int i = 0; i <= n; ++i) series.add(i * 0.01, value(random));
    const int spike = n / 3;
    series.add(-1.0, 0.0);
    series.add(spike * 0.01, 40.0);
    for (const int columns : {40, 300}) {
      SCOPED_TRACE(testing::Message() << n << " frames, " << columns << " columns");
      std::vector<SeriesPoint> points;
      series.decimate(0.0, n * 0.01, columns, points);
      // One column more at the right edge, where the last frame may fall upon the border.
      EXPECT_LE(points.size(), static_cast<std::size_t>(2 * (columns + 1)));
      const Extremes all = series.between(0.0, n * 0.01);
      const auto less = [](const SeriesPoint& a, const SeriesPoint& b) { return a.value < b.value; };
      EXPECT_EQ(std::min_element(points.begin(), points.end(), less)->value, all.low);
      EXPECT_EQ(std::max_element(points.begin(), points.end(), less)->value, 40.0);
      EXPECT_TRUE(std::is_sorted(points.begin(), points.end(),
                                 [](const SeriesPoint& a, const SeriesPoint& b) { return a.t < b.t; }));
    }
  }
}

TEST(Decimation, SplitsLineAtUnknownValues) {
  FrameSeries series(0.0, 10.0, 0.1, Keep::kSmallest);
  for (int i = 0; i <= 20; ++i) series.add(i * 0.1, 1.0);
  for (int i = 60; i <= 100; ++i) series.add(i * 0.1, 1.0);
  std::vector<SeriesPoint> points;
  series.decimate(0.0, 10.0, 500, points);
  EXPECT_EQ(
      std::count_if(points.begin(), points.end(), [](const SeriesPoint& p) { return std::isnan(p.value); }),
      1);
}

TEST(RunHistory, FindsBeginningOfContacts) {
  view::SceneOutline outline;
  outline.end = 10.0;
  outline.frame_period = 0.1;
  RunHistory history;
  history.open(outline);
  std::vector<view::PlotSample> samples;
  for (int i = 0; i <= 100; ++i) {
    const bool contact = (i >= 20 && i < 30) || (i >= 70 && i < 72);
    samples.push_back(
        {.t = i * 0.1, .min_distance = contact ? -0.01 : 0.2, .contact_force = contact ? 5.0 : 0.0});
  }
  history.add(samples);
  EXPECT_DOUBLE_EQ(history.nextContact(0.0).value(), 2.0);
  EXPECT_DOUBLE_EQ(history.nextContact(2.0).value(), 7.0);
  EXPECT_DOUBLE_EQ(history.previousContact(2.5).value(), 2.0);
  EXPECT_FALSE(history.nextContact(7.0).has_value());
  EXPECT_FALSE(history.previousContact(2.0).has_value());
}

TEST(FrameSeries, ForgetsStretch) {
  FrameSeries series(0.0, 10.0, 0.1, Keep::kLargest);
  for (int i = 0; i <= 100; ++i) series.add(0.1 * i, 1.0);
  const long before = series.revision();
  series.forget(2.0, 3.0);
  EXPECT_GT(series.revision(), before);
  EXPECT_EQ(series.at(1.9), 1.0);
  EXPECT_TRUE(std::isnan(series.at(2.0)));
  EXPECT_TRUE(std::isnan(series.at(3.0)));
  EXPECT_EQ(series.at(3.1), 1.0);
  series.forget(20.0, 30.0);
  EXPECT_EQ(series.at(10.0), 1.0);
}

TEST(RunHistory, ForcesOfEarlierMarginsAreNotThoseOfPresentOnes) {
  view::SceneOutline outline;
  outline.end = 10.0;
  outline.frame_period = 0.1;
  outline.objects = {{"p/a", "p", true, true}, {"arm/b", "arm", false, true}, {"arm/c", "arm", false, true}};
  outline.pairs = {{1, 2}, {0, 1}};
  RunHistory history;
  history.open(outline);
  EXPECT_EQ(history.classes(), (std::vector{PairClass::kPersonRobot, PairClass::kRobotRobot}));
  const auto play = [&](int from, int to, double force, long edits) {
    std::vector<view::PlotSample> samples;
    for (int i = from; i <= to; ++i) {
      view::PlotSample sample{.t = 0.1 * i, .min_distance = 0.05, .virtual_force = force};
      sample.class_distance[0] = 0.3;
      sample.class_distance[2] = 0.05;
      sample.peak_torque.contact = 2.0 * force;
      sample.peak_torque.gravity = 7.0;
      sample.margin_edits = edits;
      samples.push_back(sample);
    }
    history.add(samples);
  };
  play(0, 50, 8.0, 0);
  EXPECT_FALSE(history.hasEarlier());
  EXPECT_TRUE(history.wasInside(2.0, 2.0));
  EXPECT_EQ(history.firstDistance().at(2.0), 0.3) << "people first";
  EXPECT_EQ(history.distanceOf(PairClass::kRobotRobot).at(2.0), 0.05);
  // The margin becomes smaller while the time stands at 5 s.
  play(50, 50, 0.0, 1);
  EXPECT_TRUE(history.hasEarlier());
  EXPECT_TRUE(std::isnan(history.virtualForce().at(2.0))) << "not known under the present margins";
  EXPECT_FALSE(history.wasInside(2.0, 2.0));
  EXPECT_TRUE(history.wasInsideEarlier(2.0, 2.0));
  EXPECT_EQ(history.earlierForce().at(2.0), 8.0);
  EXPECT_EQ(history.earlierTorque().at(2.0), 16.0);
  EXPECT_TRUE(std::isnan(history.torques()[0].at(2.0)));
  EXPECT_EQ(history.torques()[2].at(2.0), 7.0) << "gravity does not depend on margins";
  EXPECT_EQ(history.virtualForce().at(5.0), 0.0);
  EXPECT_TRUE(std::isnan(history.earlierForce().at(5.0))) << "played anew";
  EXPECT_EQ(history.distanceOf(PairClass::kPersonRobot).at(2.0), 0.3) << "distances stay";
  // And a part is played again.
  play(10, 20, 3.0, 1);
  EXPECT_EQ(history.virtualForce().at(1.5), 3.0);
  EXPECT_TRUE(std::isnan(history.earlierForce().at(1.5)));
  EXPECT_EQ(history.earlierForce().at(3.0), 8.0);
  // Twice changed: what was fresh is of earlier margins, too.
  play(30, 30, 1.0, 3);
  EXPECT_EQ(history.earlierForce().at(1.5), 3.0);
  EXPECT_TRUE(std::isnan(history.virtualForce().at(1.5)));
  EXPECT_EQ(history.nextContact(0.0), std::optional(3.0));
  history.open(outline);
  EXPECT_FALSE(history.hasEarlier());
}

}  // namespace frame_series_test
}  // namespace abstand::ui
