// How long cycles took: what counts, what is said, and the way to the longest one.
#include "ui/plots/cycle_panel.hpp"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QSignalSpy>

#include "ui/style/elided_label.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {
namespace cycle_panel_test {

constexpr double kBin = 0.005;  // share, half the width of a bin of CycleStatistics

view::SceneOutline scene() {
  view::SceneOutline outline;
  outline.end = 10.0;
  outline.frame_period = 0.01;
  for (const char* name : {"hand", "arm", "base"}) outline.objects.push_back({name, "", false, true});
  outline.pairs = {{0, 1}, {0, 2}};
  return outline;
}

/// 1,000 cycles of 1, 2, … 1,000 us, the last one with the second pair nearest.
std::vector<view::PlotSample> ramp() {
  std::vector<view::PlotSample> samples;
  for (int i = 1; i <= 1000; ++i) {
    view::PlotSample sample;
    sample.t = i * 0.01;
    sample.cycle_s = i * 1e-6;
    sample.step_s = 0.9e-3;
    sample.nearest_pair = i == 1000 ? 1 : 0;
    sample.played = true;
    samples.push_back(sample);
  }
  return samples;
}

QString value(const CyclePanel& panel, const char* name) {
  for (const auto* label : panel.findChildren<ElidedLabel*>())
    if (label->accessibleName() == QLatin1String(name)) return label->text();
  return QStringLiteral("no such row");
}

TEST(CycleLog, ReportsQuantilesLongestAndLateCycles) {
  CycleLog log;
  log.open(scene());
  EXPECT_FALSE(log.longest());
  log.add(ramp());
  EXPECT_NEAR(log.statistics().median(), 500e-6, 500e-6 * kBin);
  EXPECT_NEAR(log.statistics().p999(), 999e-6, 999e-6 * kBin);
  EXPECT_EQ(log.statistics().overruns(), 0) << "the longest is as long as the deadline";
  EXPECT_EQ(log.late(), 100);
  EXPECT_DOUBLE_EQ(log.longest()->t, 10.0);
  EXPECT_DOUBLE_EQ(log.longest()->seconds, 1e-3);
  EXPECT_DOUBLE_EQ(log.series().at(5.0), 500e-6);
}

TEST(CycleLog, IgnoresCyclesNotPlayed) {
  CycleLog log;
  log.open(scene());
  std::vector<view::PlotSample> samples = ramp();
  for (view::PlotSample& sample : samples) sample.played = false;
  log.add(samples);
  EXPECT_EQ(log.statistics().count(), 0);
  EXPECT_FALSE(log.longest());
}

TEST(CycleLog, KeepsLongestCyclePerFrame) {
  CycleLog log;
  log.open(scene());
  std::vector<view::PlotSample> samples(3, ramp()[499]);
  samples[1].cycle_s = 2e-3;
  log.add(samples);
  EXPECT_DOUBLE_EQ(log.series().at(5.0), 2e-3);
  EXPECT_EQ(log.statistics().overruns(), 1);
  log.clear();
  EXPECT_EQ(log.statistics().count(), 0);
  EXPECT_EQ(log.late(), 0);
}

TEST(CyclePanelTest, ShowsCountsAndGoesToLongest) {
  CyclePanel panel;
  panel.open(scene());
  EXPECT_EQ(value(panel, "Median, 99 %, 99.9 %"), "nothing was played");
  panel.add(ramp());
  panel.refresh();
  EXPECT_EQ(value(panel, "Longest"), "1000 µs at 10.000 s");
  EXPECT_EQ(value(panel, "Nearest then"), "hand – base");
  EXPECT_EQ(value(panel, "Overruns"), QStringLiteral("100 of 1000 (%1 %)").arg(fixed(10.0, 2)));
  QSignalSpy picked(&panel, &CyclePanel::timePicked);
  QPushButton *go = nullptr, *anew = nullptr;
  for (auto* button : panel.findChildren<QPushButton*>())
    (button->text().contains("longest") ? go : anew) = button;
  go->click();
  ASSERT_EQ(picked.size(), 1);
  EXPECT_DOUBLE_EQ(picked.front().front().toDouble(), 10.0);
  anew->click();
  EXPECT_EQ(value(panel, "Longest"), "–");
  EXPECT_FALSE(go->isEnabled());
}

}  // namespace cycle_panel_test
}  // namespace abstand::ui
