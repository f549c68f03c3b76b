// The live plots on one time axis.
#include "ui/plots/plot_panel.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/format.hpp"
#include "ui/plots/strip_chart.hpp"
#include "ui/theme.hpp"

namespace abstand::ui {

namespace {
constexpr double kDefaultSpan = 10.0;  // s
// The playhead stands here in the window while following, with a little of the future in sight.
constexpr double kPlayheadPlace = 0.85;
}  // namespace

PlotPanel::PlotPanel(QWidget* parent) : QWidget(parent), span_{new QComboBox(this)} {
  charts_ = {new StripChart({tr("Smallest distance"), tr("mm"), 1e3, 1, false}, QColor(kAccent), this),
             new StripChart({tr("Largest force"), tr("N"), 1.0, 1, false}, QColor(kVermillion), this),
             new StripChart({tr("Largest joint torque"), tr("N·m"), 1.0, 2, true}, QColor(0xff7a5aa6), this)};
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2, 4, 2, 2);
  layout->setSpacing(2);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(6, 0, 6, 0);
  auto* label = new QLabel(tr("&Window"), this);
  label->setBuddy(span_);
  for (const double seconds : {2.0, 5.0, 10.0, 30.0, 60.0}) span_->addItem(tr("%1 s").arg(seconds), seconds);
  span_->addItem(tr("all"), 0.0);
  span_->setCurrentIndex(span_->findData(kDefaultSpan));
  span_->setAccessibleName(tr("Time span of the plots"));
  span_->setToolTip(tr("How much time the plots show while they follow"));
  head->addWidget(label);
  head->addWidget(span_);
  head->addStretch();
  layout->addLayout(head);
  for (StripChart* chart : charts_) {
    layout->addWidget(chart, chart == charts_.back() ? 4 : 3);
    connect(chart, &StripChart::timePicked, this, &PlotPanel::timePicked);
    connect(chart, &StripChart::windowMoved, this, [this](double left, double right) {
      setFollow(false);
      moveWindow(left, right);
    });
  }
  connect(span_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    setFollow(true);
    followTime();
  });
}

void PlotPanel::setSeries(const FrameSeries* distance, const FrameSeries* force, const FrameSeries* effort,
                          double start, double end) {
  charts_[0]->setSeries(distance);
  charts_[1]->setSeries(force);
  charts_[2]->setSeries(effort);
  start_ = start;
  end_ = end;
  time_ = start;
  followTime();
  setTime(start);
}

void PlotPanel::setTime(double t) {
  time_ = t;
  for (StripChart* chart : charts_) chart->setPlayhead(t);
  if (follow_) followTime();
}

void PlotPanel::setMargin(double metres) {
  charts_[0]->setBand(metres, tr("margin %1").arg(millimetresWithUnit(metres, 0)));
}

void PlotPanel::refresh() {
  if (!isVisible()) return;
  for (StripChart* chart : charts_) chart->refresh();
}

void PlotPanel::setFollow(bool on) {
  if (on == follow_) return;
  follow_ = on;
  if (on) followTime();
  Q_EMIT followChanged(on);
}

void PlotPanel::moveWindow(double left, double right) {
  for (StripChart* chart : charts_) chart->setWindow(left, right);
}

void PlotPanel::followTime() {
  const double chosen = span_->currentData().toDouble();
  const double whole = std::max(end_ - start_, 0.0);
  if (chosen <= 0.0) {
    moveWindow(start_, start_ + std::max({whole, time_ - start_, 0.1}));
    return;
  }
  if (whole > 0.0 && whole <= chosen) {
    moveWindow(start_, end_);
    return;
  }
  double left = std::max(start_, time_ - kPlayheadPlace * chosen);
  if (whole > 0.0) left = std::min(left, end_ - chosen);
  moveWindow(left, left + chosen);
}

}  // namespace abstand::ui
