// A chart with the names of several lines, as low as it may become.
#include "ui/plots/strip_chart.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLabel>
#include <algorithm>
#include <cmath>
#include <memory>

namespace abstand::ui {
namespace strip_chart_test {

const std::vector<StripChart::Line> kLines{{"Person – Roboter, gesichert", Qt::blue},
                                           {"Person – Gegenstand", Qt::cyan},
                                           {"Roboter – Roboter", Qt::gray},
                                           {"Roboter – Gegenstand", Qt::darkYellow},
                                           {"left_arm/link7 – operator/biceps_right", Qt::green}};

struct LowChart : ::testing::TestWithParam<int> {
  LowChart() {
    for (int i = 0; i <= 10; ++i) series.add(0.1 * i, 0.06 * i);
    chart.setLines(kLines);
    chart.setSeries(&series);
    chart.setWindow(0.0, 1.0);
    chart.setStyleSheet(QStringLiteral("* { font-size: 11pt; }"));  // larger than Qwt expects
    chart.resize(GetParam(), 400);
    chart.show();
    QCoreApplication::sendPostedEvents();
    chart.resize(GetParam(), chart.minimumSizeHint().height());
    QCoreApplication::sendPostedEvents();
    for (std::size_t i = 0; i < kLines.size(); ++i) chart.setNow(0.1213, i);
    chart.refresh();
  }

  FrameSeries series{0.0, 1.0, 0.1, Keep::kSmallest};
  StripChart chart{{"Distance", "mm", 1e3, 1, true}, Qt::black};
};

TEST_P(LowChart, PlotIsBelowTheNamesOfItsLines) {
  const QList<QWidget*> children = chart.findChildren<QWidget*>();
  const auto it = std::find_if(children.begin(), children.end(),
                               [](const QWidget* child) { return child->inherits("QwtPlot"); });
  ASSERT_NE(it, children.end());
  const QWidget* plot = *it;
  for (const QLabel* label : chart.findChildren<QLabel*>()) {
    if (!label->isVisible()) continue;
    const QRect place(label->mapTo(&chart, QPoint(0, 0)), label->size());
    EXPECT_LE(place.bottom(), plot->geometry().top()) << label->text().toStdString();
    if (label->wordWrap()) {
      EXPECT_LE(label->heightForWidth(label->width()), label->height());
    }
  }
  EXPECT_LE(plot->geometry().bottom(), chart.height());
}

INSTANTIATE_TEST_SUITE_P(Widths, LowChart, ::testing::Range(280, 480, 3));

TEST(StripChart, ReadsNoSeriesOfEarlierLines) {
  StripChart chart({"Distance", "mm", 1e3, 1, true}, Qt::black);
  chart.setLines(kLines);
  auto series = std::make_unique<FrameSeries>(0.0, 1.0, 0.1, Keep::kSmallest);
  series->add(0.0, 0.5);
  for (std::size_t i = 0; i < kLines.size(); ++i) chart.setSeries(series.get(), i);
  chart.show();
  chart.refresh();
  EXPECT_EQ(chart.shownNow(1), 0.5);
  chart.setNow(0.4, 1);
  series.reset();
  // As Qt resizes a chart while the lines of its neighbour are laid.
  chart.resize(chart.width() / 2, chart.height());
  chart.setLines(kLines);
  for (std::size_t i = 0; i < kLines.size(); ++i) {
    EXPECT_EQ(chart.series(i), nullptr);
    EXPECT_TRUE(std::isnan(chart.shownNow(i)));
  }
}

}  // namespace strip_chart_test
}  // namespace abstand::ui
