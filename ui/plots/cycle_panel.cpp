#include "ui/plots/cycle_panel.hpp"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/plots/strip_chart.hpp"
#include "ui/style/elided_label.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr double kMicro = 1e6;
enum Row { kQuantiles, kLongest, kNearest, kMissed, kLate };
constexpr int kValueWidth = 170;  // px; longer names of pairs are elided

QString share(long part, long all) {
  return CyclePanel::tr("%1 of %2 (%3 %)")
      .arg(part)
      .arg(all)
      .arg(fixed(100.0 * static_cast<double>(part) / static_cast<double>(all), 2));
}

}  // namespace

CyclePanel::CyclePanel(QWidget* parent)
    : QWidget(parent),
      go_{new QPushButton(tr("&Go to the longest"), this)},
      anew_{new QPushButton(tr("Count &anew"), this)},
      chart_{new StripChart({tr("Longest cycle of each frame"), tr("µs"), kMicro, 0, true}, QColor(kAccent),
                            this)} {
  auto* form = new QFormLayout;
  form->setVerticalSpacing(2);
  const std::array<QString, 5> names{tr("Median, 99 %, 99.9 %"), tr("Longest"), tr("Nearest then"),
                                     tr("Longer than 1 ms"), tr("Overruns")};
  for (std::size_t i = 0; i < values_.size(); ++i) {
    values_[i] = new ElidedLabel(this);
    values_[i]->setFixedWidth(kValueWidth);
    values_[i]->setAccessibleName(names[i]);
    form->addRow(names[i], values_[i]);
  }
  values_[kQuantiles]->setToolTip(tr("Wall times that half, 99 % and 99.9 % of the played cycles kept"));
  values_[kLate]->setToolTip(tr("Cycles that took longer than the step that the loop had chosen for them"));
  go_->setToolTip(tr("Move to the moment of the longest cycle"));
  anew_->setToolTip(tr("Forget the cycles that were counted so far"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(go_);
  buttons->addWidget(anew_);
  auto* left = new QVBoxLayout;
  left->addLayout(form);
  left->addStretch();
  left->addLayout(buttons);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->addLayout(left);
  layout->addWidget(chart_, 1);
  connect(go_, &QPushButton::clicked, this, [this] {
    if (log_.longest()) Q_EMIT timePicked(log_.longest()->t);
  });
  connect(anew_, &QPushButton::clicked, this, &CyclePanel::startAnew);
  connect(chart_, &StripChart::timePicked, this, &CyclePanel::timePicked);
  connect(chart_, &StripChart::windowMoved, chart_, &StripChart::setWindow);
  open({});
}

void CyclePanel::open(const view::SceneOutline& outline) {
  log_.open(outline);
  pairs_.clear();
  const auto name = [&](int object) {
    return QString::fromStdString(outline.objects[static_cast<std::size_t>(object)].name);
  };
  for (const auto& [a, b] : outline.pairs) pairs_.push_back(tr("%1 – %2").arg(name(a), name(b)));
  chart_->setSeries(&log_.series());
  chart_->setWindow(outline.start, outline.end > outline.start ? outline.end : outline.start + 10.0);
  refresh();
}

void CyclePanel::startAnew() {
  log_.clear();
  refresh();
}

void CyclePanel::setTime(double t) { chart_->setPlayhead(t); }

QString CyclePanel::nearestText() const {
  const int pair = log_.longest()->nearest_pair;
  const auto index = static_cast<std::size_t>(pair);
  return pair >= 0 && index < pairs_.size() ? pairs_[index] : QStringLiteral("–");
}

void CyclePanel::refresh() {
  const scene::CycleStatistics& cycles = log_.statistics();
  const bool some = cycles.count() > 0;
  for (ElidedLabel* value : values_) value->setText(QStringLiteral("–"));
  values_[kQuantiles]->setText(tr("nothing was played"));
  if (some) {
    const auto whole = [](double seconds) { return fixed(kMicro * seconds, 0); };
    values_[kQuantiles]->setText(
        tr("%1, %2, %3 µs").arg(whole(cycles.median()), whole(cycles.p99()), whole(cycles.p999())));
    values_[kLongest]->setText(
        tr("%1 µs at %2").arg(whole(cycles.max()), secondsWithUnit(log_.longest()->t)));
    values_[kNearest]->setText(nearestText());
    values_[kNearest]->setToolTip(
        tr("The nearest pair of the scene in the longest cycle: %1").arg(nearestText()));
    values_[kMissed]->setText(share(cycles.overruns(), cycles.count()));
    values_[kLate]->setText(share(log_.late(), cycles.count()));
  }
  go_->setEnabled(some);
  anew_->setEnabled(some);
  chart_->refresh();
}

}  // namespace abstand::ui
