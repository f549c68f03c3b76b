// The status bar.
#include "ui/panels/status_panel.hpp"

#include <QLabel>
#include <QPalette>
#include <QStatusBar>
#include <algorithm>

#include "ui/format.hpp"
#include "ui/theme.hpp"

namespace abstand::ui {

namespace {

void colourText(QLabel* label, bool alarm) {
  QPalette palette = label->parentWidget()->palette();
  if (alarm) palette.setColor(QPalette::WindowText, QColor(kVermillion));
  if (label->palette().color(QPalette::WindowText) != palette.color(QPalette::WindowText))
    label->setPalette(palette);
}

constexpr int kAround = 12;  // px left and right of a text

void setText(QLabel* label, const QString& text) {
  label->setText(text);
  // Labels only grow, so that what stands beside them keeps its place.
  label->setMinimumWidth(
      std::max(label->minimumWidth(), label->fontMetrics().horizontalAdvance(text) + 2 * kAround));
}

}  // namespace

StatusPanel::StatusPanel(QStatusBar* bar)
    : QObject(bar),
      nearest_{new QLabel(bar)},
      cycle_{new QLabel(bar)},
      overruns_{new QLabel(bar)},
      real_time_{new QLabel(bar)} {
  bar->setSizeGripEnabled(false);
  auto* banner = new QLabel(bar);
  setText(banner, tr("Analysis tool, not a safety function"));
  banner->setForegroundRole(QPalette::PlaceholderText);
  banner->setAlignment(Qt::AlignCenter);
  nearest_->setAccessibleName(tr("Nearest pair"));
  cycle_->setToolTip(tr("Time of one computation cycle: median and 99th percentile"));
  overruns_->setToolTip(tr("Cycles that took longer than their period"));
  real_time_->setToolTip(tr("Simulation time by wall time"));
  nearest_->setContentsMargins(8, 0, 8, 0);
  bar->addWidget(nearest_, 1);
  for (QLabel* label : {cycle_, overruns_, real_time_}) {
    label->setAlignment(Qt::AlignCenter);
    bar->addPermanentWidget(label);
  }
  bar->addPermanentWidget(banner);
  clear();
}

void StatusPanel::refresh(const SceneOutline& outline, const SceneSnapshot& snapshot) {
  const auto pair = static_cast<std::size_t>(snapshot.nearest_pair);
  if (snapshot.nearest_pair >= 0 && pair < snapshot.pairs.size() && pair < outline.pairs.size()) {
    const auto [a, b] = outline.pairs[pair];
    const PairResult& result = snapshot.pairs[pair].result;
    const bool alarm = result.contacts > 0 || result.distance < 0.0;
    nearest_->setText(tr("%1Nearest: %2 – %3, %4")
                          .arg(alarm ? QStringLiteral("⚠ ") : QString(),
                               QString::fromStdString(outline.objects[static_cast<std::size_t>(a)].name),
                               QString::fromStdString(outline.objects[static_cast<std::size_t>(b)].name),
                               millimetresWithUnit(result.distance)));
    colourText(nearest_, alarm);
  } else {
    nearest_->clear();
  }
  setText(cycle_,
          tr("Cycle %1 / %2 µs").arg(fixed(snapshot.cycle_median_us, 0), fixed(snapshot.cycle_p99_us, 0)));
  setText(overruns_, tr("Overruns %1").arg(snapshot.overruns));
  setText(real_time_, tr("Real time %1×").arg(fixed(snapshot.real_time_factor, 2)));
}

void StatusPanel::clear() {
  for (QLabel* label : {nearest_, cycle_, overruns_, real_time_}) label->clear();
}

}  // namespace abstand::ui
