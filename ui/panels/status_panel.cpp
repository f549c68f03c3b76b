// The status bar.
#include "ui/panels/status_panel.hpp"

#include <QLabel>
#include <QPalette>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/model/event_text.hpp"
#include "ui/model/live_text.hpp"
#include "ui/model/nearest_classes.hpp"
#include "ui/model/stop_text.hpp"
#include "ui/style/elided_label.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

void colourText(QLabel* label, const std::optional<QColor>& colour) {
  QPalette palette = label->parentWidget()->palette();
  if (colour) palette.setColor(QPalette::WindowText, *colour);
  if (label->palette().color(QPalette::WindowText) != palette.color(QPalette::WindowText))
    label->setPalette(palette);
}

void colourText(QLabel* label, bool alarm) {
  colourText(label, alarm ? std::optional(QColor(kVermillion)) : std::nullopt);
}

constexpr int kBarWidth = 160;
constexpr int kBarSteps = 1000;

/// "Checked 120 of 639, skipped 510 (far away), postponed 9"; what is 0 is not named.
QString leftOut(const scene::StepCounts& work, std::size_t pairs) {
  QString text = StatusPanel::tr("Checked %1 of %2").arg(work.checked).arg(pairs);
  const long skipped = work.rested + work.beyond;
  if (skipped > 0) text += StatusPanel::tr(", skipped %1 (far away)").arg(skipped);
  if (work.deferred > 0) text += StatusPanel::tr(", postponed %1").arg(work.deferred);
  return text;
}

std::size_t notChecked(const view::SceneSnapshot& snapshot) {
  return static_cast<std::size_t>(std::count_if(snapshot.pairs.begin(), snapshot.pairs.end(),
                                                [](const view::PairSnapshot& pair) { return pair.paused; }));
}

QString leftOutInWords(const scene::StepCounts& work, std::size_t pairs) {
  const long looked_at = work.checked + work.rested + work.beyond + work.deferred;
  return StatusPanel::tr(
             "Pairs in the last cycle\n"
             "checked: %1\n"
             "skipped, as they cannot have used up their clearance: %2\n"
             "skipped, as they are beyond the horizon: %3\n"
             "postponed, as the time budget was used up: %4 (longest: %5 cycles)\n"
             "unchanged since the last check: %6\n"
             "Whatever is skipped, the true distance is never below distance − bound.")
      .arg(work.checked)
      .arg(work.rested)
      .arg(work.beyond)
      .arg(work.deferred)
      .arg(work.longest_wait)
      .arg(static_cast<long>(pairs) - looked_at);
}

}  // namespace

StatusPanel::StatusPanel(QStatusBar* bar)
    : QObject(bar),
      nearest_{new ElidedLabel(bar)},
      opening_{new ElidedLabel(bar)},
      opening_bar_{new QProgressBar(bar)},
      cancel_{new QToolButton(bar)},
      live_{new ElidedLabel(bar)},
      analysis_{new ElidedLabel(bar)},
      robots_{new ElidedLabel(bar)},
      left_out_{new ElidedLabel(bar)},
      cycle_{new ElidedLabel(bar)},
      overruns_{new ElidedLabel(bar)},
      real_time_{new ElidedLabel(bar)} {
  bar->setSizeGripEnabled(false);
  auto* banner = new ElidedLabel(bar);
  banner->keepWhole();
  banner->setText(tr("Analysis tool, not a safety function"));
  banner->setForegroundRole(QPalette::PlaceholderText);
  banner->setAlignment(Qt::AlignCenter);
  nearest_->setAccessibleName(tr("Nearest pair"));
  cycle_->setToolTip(tr("Time of one computation cycle: median and 99th percentile"));
  opening_->setObjectName(QStringLiteral("opening"));
  opening_bar_->setAccessibleName(tr("Progress of opening"));
  opening_bar_->setMaximumWidth(kBarWidth);
  opening_bar_->setTextVisible(false);
  left_out_->setObjectName(QStringLiteral("left_out"));
  live_->setObjectName(QStringLiteral("live"));
  live_->setAccessibleName(tr("Connection with the server"));
  live_->keepWhole();
  live_->hide();
  analysis_->setObjectName(QStringLiteral("analysis"));
  analysis_->setAccessibleName(tr("Progress of the analysis"));
  robots_->setObjectName(QStringLiteral("robots"));
  robots_->setAccessibleName(tr("State of the robots that react"));
  left_out_->setAccessibleName(tr("Pairs that were checked"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Stop opening, and keep what is there"));
  cancel_->setObjectName(QStringLiteral("cancel_opening"));
  bar->addWidget(opening_bar_);
  bar->addWidget(cancel_);
  bar->addWidget(opening_, 1);
  bar->addWidget(nearest_, 1);
  hideOpening();
  for (ElidedLabel* label : {live_, analysis_, robots_, left_out_, cycle_, overruns_, real_time_}) {
    label->setAlignment(Qt::AlignCenter);
    bar->addPermanentWidget(label);
  }
  for (ElidedLabel* label : {cycle_, overruns_, real_time_}) label->keepWhole();
  left_out_->setMinimumWidth(left_out_->fontMetrics().horizontalAdvance(tr("Checked %1 of %1").arg(9999)));
  bar->addPermanentWidget(banner);
  clear();
}

void StatusPanel::refresh(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  shown_step_ = snapshot.step;
  const auto pair = static_cast<std::size_t>(snapshot.nearest_pair);
  if (snapshot.nearest_pair >= 0 && pair < snapshot.pairs.size() && pair < outline.pairs.size()) {
    const PairLevel worst = nearestLevel(outline, snapshot);
    nearest_->setText(nearestText(outline, snapshot));
    nearest_->setToolTip(nearestLines(outline, snapshot));
    colourText(nearest_, isBroken(worst) ? std::optional(levelColour(worst)) : std::nullopt);
  } else {
    nearest_->clear();
  }
  showRobots(outline, snapshot);
  const std::size_t not_checked = notChecked(snapshot);
  QString left_out = leftOut(snapshot.work, snapshot.pairs.size());
  if (not_checked > 0) left_out = tr("⚠ %1 pairs not checked. %2").arg(not_checked).arg(left_out);
  left_out_->setText(left_out);
  colourText(left_out_, not_checked > 0);
  left_out_->setToolTip(leftOutInWords(snapshot.work, snapshot.pairs.size()));
}

void StatusPanel::refreshFigures(const view::SceneSnapshot& snapshot, long missed) {
  cycle_->setText(
      tr("Cycle %1 / %2 µs").arg(fixed(snapshot.cycle_median_us, 0), fixed(snapshot.cycle_p99_us, 0)));
  overruns_->setText(tr("Overruns %1 of %2").arg(snapshot.overruns).arg(snapshot.played_cycles));
  overruns_->setToolTip(tr("Cycles that took longer than the step that the loop has chosen, %1 ms, of all\n"
                           "since playing began or its speed changed")
                            .arg(fixed(1e3 * snapshot.step_s, 2)));
  real_time_->setText(std::isnan(snapshot.real_time_factor)
                          ? tr("Real time –")
                          : tr("Real time %1×").arg(fixed(snapshot.real_time_factor, 2)));
  real_time_->setToolTip(tr("Scene time that was played by wall time, over the last one and a half seconds.\n"
                            "Moments that were computed and came too fast to be drawn: %1")
                             .arg(missed));
}

void StatusPanel::showRobots(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  robots_->setVisible(!outline.reacting.empty());
  if (outline.reacting.empty()) return;
  bool alarm = false;
  const QString text = worstText(snapshot, outline, &alarm);
  if (!snapshot.robots.empty() && std::isnan(snapshot.loop_start)) {
    robots_->setText((alarm ? QStringLiteral("⚠ ") : QString()) + text);
    robots_->setToolTip(tr("As the server reports it. Reasons and times are in the panel \"Robots\"."));
  } else if (snapshot.robots.empty()) {
    robots_->setText(tr("React: off"));
    robots_->setToolTip(tr("Robots follow their recorded motion (React is off)"));
  } else {
    robots_->setText((alarm ? QStringLiteral("⚠ ") : QString()) + text);
    robots_->setToolTip(
        tr("Robots were restarted on their planned motion at %1 and react since then; a seek,\n"
           "a frame back and a new round restart them. Reasons and times are in the panel\n"
           "\"Robots\".")
            .arg(secondsWithUnit(snapshot.loop_start)));
  }
  colourText(robots_, alarm);
}

void StatusPanel::clear() {
  for (ElidedLabel* label : {nearest_, robots_, left_out_, cycle_, overruns_, real_time_}) label->clear();
  left_out_->setToolTip({});
}

void StatusPanel::showOpening(const Opening& opening) {
  const QString count = tr("%1 of %2").arg(opening.begun).arg(opening.all);
  const bool tracking = opening.begun == 0 && opening.images > 0;
  opening_->setText(
      tracking ? tr("Finding the person: image %1 of %2").arg(opening.images_done).arg(opening.images)
      : opening.begun == 0 ? tr("Reading files")
      : opening.building   ? tr("Building structure %1: %2").arg(count, opening.name)
                           : tr("Structure %1: %2").arg(count, opening.name));
  // Without steps the bar only says that something is going on.
  opening_bar_->setMaximum(opening.begun == 0 && !tracking ? 0 : kBarSteps);
  opening_bar_->setValue(
      tracking ? static_cast<int>(static_cast<long>(kBarSteps) * opening.images_done / opening.images)
               : static_cast<int>(kBarSteps * opening.fraction));
  cancel_->show();
  nearest_->hide();
  opening_->show();
  opening_bar_->show();
}

void StatusPanel::showAnalysis(const RecordingReview& review) {
  QString text = analysisText(review);
  if (text.isEmpty() && review.available()) text = leftOutText(review);
  analysis_->setText(text);
  analysis_->setVisible(!text.isEmpty());
  analysis_->setToolTip(
      review.problem().isEmpty()
          ? tr("Distances of the whole recording are computed for the timeline and the events")
          : review.problem());
  colourText(analysis_, review.state() == view::AnalysisNews::State::kFailed);
}

void StatusPanel::showLive(const std::optional<LiveStatus>& status) {
  live_->setVisible(status.has_value());
  // Of the loop here, which does not run.
  for (ElidedLabel* label : {overruns_, real_time_}) label->setVisible(!status);
  if (!status) return;
  live_->setText(liveText(*status));
  live_->setToolTip(liveLines(*status));
  colourText(live_, isStale(*status) || status->other_file);
}

void StatusPanel::hideOpening() {
  opening_->hide();
  opening_bar_->hide();
  cancel_->hide();
  nearest_->show();
}

}  // namespace abstand::ui
