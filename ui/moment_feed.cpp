// One moment in all parts of the window.
#include "ui/moment_feed.hpp"

#include <algorithm>
#include <utility>

#include "ui/model/moment_sample.hpp"
#include "ui/model/nearest_classes.hpp"
#include "ui/model/pair_sentence.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/run_history.hpp"
#include "ui/model/scene_tree_model.hpp"
#include "ui/model/session_port.hpp"
#include "ui/model/stop_text.hpp"
#include "ui/model/watched_series.hpp"
#include "ui/panels/depth_panel.hpp"
#include "ui/panels/group_panel.hpp"
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/pair_matrix.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/recording_panel.hpp"
#include "ui/panels/robot_panel.hpp"
#include "ui/panels/separation_panel.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/panels/time_strip.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/plots/cycle_panel.hpp"
#include "ui/plots/plot_panel.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

MomentFeed::MomentFeed(const Parts& parts, QObject* parent)
    : QObject(parent),
      my_{parts},
      history_{std::make_unique<RunHistory>()},
      watched_{new WatchedSeries(this)} {
  connect(watched_, &WatchedSeries::changed, this,
          [this] { my_.panels.plots->setWatched(watched_->lines()); });
  connect(my_.panels.plots, &PlotPanel::dropped, watched_, &WatchedSeries::pin);
  connect(my_.panels.plots, &PlotPanel::jointChosen, this, [this](int joint) {
    history_->torqueOf(joint);
    history_->add(snapshot_);
  });
  tellTips();
}

MomentFeed::~MomentFeed() = default;

/// Tips tell the moment that is shown.
void MomentFeed::tellTips() {
  const auto pair = [this](int of) {
    return session_ ? pairSentence(session_->outline(), snapshot_, of, times_.of(of)) : QString();
  };
  const auto body = [this](int of) {
    return session_ ? bodySentence(session_->outline(), snapshot_, of, times_) : QString();
  };
  my_.panels.pairs->model()->setSentence(pair);
  my_.tree.setSentence(body);
  my_.viewport.setTipSource(body);
}

void MomentFeed::attach(SessionPort* session) {
  session_ = session;
  snapshot_ = {};
  samples_.clear();
  times_.clear();
  missed_ = 0;
  if (!session_) return;
  session_->takeSnapshot(snapshot_);
  span_ = session_->span();
}

/// The series begin anew; the session gives their samples again.
void MomentFeed::moveSpan() {
  span_ = session_->span();
  const view::SceneOutline& outline = session_->outline();
  history_->open(outline);
  my_.panels.timeline->strip()->setHistory(history_.get(), outline.start, outline.end);
  openPlots(outline);
  my_.panels.cycles->open(outline);
  Q_EMIT spanMoved();
}

void MomentFeed::open(const view::SceneOutline& outline, const std::vector<double>& margins) {
  const PanelSet& panels = my_.panels;
  history_->open(outline);
  my_.tree.open(outline);
  panels.pairs->open(outline);
  panels.margins->open(outline, margins);
  panels.robots->open(outline);
  loops_ = snapshot_.loops;
  panels.timeline->strip()->setHistory(history_.get(), outline.start, outline.end);
  panels.timeline->strip()->setStopText([&outline](const StopSpan& span) { return spanText(span, outline); });
  openPlots(outline);
  panels.groups->open(outline);
  panels.recordings->open(outline.recordings);
  panels.cycles->open(outline);
  panels.depth->open(session_ ? session_->depth() : nullptr);
  panels.inspector->open(outline);
  panels.matrix->open(outline);
  panels.separation->open(outline);
  panels.status->clear();
  is_stale_ = session_ != nullptr;
}

void MomentFeed::openPlots(const view::SceneOutline& outline) {
  PlotPanel& plots = *my_.panels.plots;
  // What robots that react do differs from what was recorded.
  whole_plot_ = my_.review.available() && outline.reacting.empty() && !outline.falls;
  PlotSeries series{{},
                    &history_->contactForce(),
                    &history_->virtualForce(),
                    &history_->earlierForce(),
                    &history_->torques(),
                    &history_->earlierTorque()};
  for (const PairClass of : history_->classes()) {
    const bool certified = whole_plot_ && of == PairClass::kPersonRobot;
    series.distances.push_back(
        {of, certified ? &my_.review.nearest() : &history_->distanceOf(of), certified});
  }
  plots.setSeries(series, outline.start, outline.end);
  plots.setJoints(outline.joints);
  watched_->open(outline, whole_plot_);
}

void MomentFeed::pull() {
  if (!session_) return;
  if (session_->span() != span_) moveSpan();
  samples_.clear();
  session_->drainPlot(samples_);
  history_->add(samples_);
  my_.panels.cycles->add(samples_);
  const long before = snapshot_.step;
  if (!session_->takeSnapshot(snapshot_)) return;
  if (snapshot_.playing) missed_ += std::max(0L, snapshot_.step - before - 1);
  history_->add(snapshot_);
  watched_->add(snapshot_);
  times_.add(session_->outline(), snapshot_);
  is_stale_ = true;
  my_.playback.onSnapshot(snapshot_);
  show();
}

void MomentFeed::show() {
  if (!session_) return;
  const view::SceneOutline& outline = session_->outline();
  const PanelSet& panels = my_.panels;
  Q_EMIT aboutToShow();
  my_.viewport.refresh(snapshot_);
  panels.pairs->refresh(snapshot_);
  my_.tree.refresh(outline, snapshot_);
  panels.status->refresh(outline, snapshot_);
  panels.timeline->refresh(snapshot_);
  if (panels.robots->isVisible()) panels.robots->refresh(outline, snapshot_);
  if (panels.groups->isVisible()) panels.groups->refresh(snapshot_);
  panels.depth->refresh(snapshot_);
  panels.inspector->refresh(snapshot_);
  panels.matrix->refresh(snapshot_);
  panels.separation->refresh(snapshot_);
  panels.plots->showEarlier(history_->hasEarlier());
  panels.plots->setMoment(snapshot_.step, momentSample(outline, snapshot_, panels.plots->joint()),
                          clearancePersonRobot(outline, snapshot_));
  panels.plots->refresh();
  if (std::exchange(loops_, snapshot_.loops) != snapshot_.loops && !snapshot_.robots.empty())
    Q_EMIT restarted(snapshot_.loop_start);
  Q_EMIT shown();
}

void MomentFeed::refreshSlow() {
  if (!session_) return;
  const PanelSet& panels = my_.panels;
  my_.review.pull();
  my_.review.setStops(panels.timeline->stops(), session_->outline());
  watched_->add(my_.review);
  if (std::exchange(is_stale_, false)) {
    panels.pairs->sortAgain();
    panels.status->refreshFigures(snapshot_, missed_);
    const auto nearest = static_cast<std::size_t>(snapshot_.nearest_pair);
    panels.plots->setMargin(whole_plot_ ? my_.review.commonMargin().value_or(0.0)
                            : snapshot_.nearest_pair >= 0 && nearest < snapshot_.pairs.size()
                                ? snapshot_.pairs[nearest].margin
                                : 0.0);
  }
  panels.timeline->strip()->refresh();
  panels.plots->refresh();
  if (panels.cycles->isVisible()) panels.cycles->refresh();
}

std::vector<std::pair<const char*, long>> MomentFeed::shownSteps() const {
  return {{"3D view", my_.viewport.shownStep()},
          {"scene tree", my_.tree.shownStep()},
          {"pairs", my_.panels.pairs->shownStep()},
          {"plots", my_.panels.plots->shownStep()},
          {"status", my_.panels.status->shownStep()}};
}

}  // namespace abstand::ui
