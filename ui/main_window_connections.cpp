// What the window connects with what.
#include <QAbstractButton>
#include <QDockWidget>
#include <QLineEdit>
#include <QSlider>
#include <QTimer>
#include <algorithm>

#include "ui/arrow_dialog.hpp"
#include "ui/bookmark_commands.hpp"
#include "ui/camera_commands.hpp"
#include "ui/dock_set.hpp"
#include "ui/document/document.hpp"
#include "ui/file_commands.hpp"
#include "ui/live_commands.hpp"
#include "ui/main_window.hpp"
#include "ui/margin_commands.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recent_files.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/scene_tree_model.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/watched_series.hpp"
#include "ui/moment_feed.hpp"
#include "ui/panels/bookmark_panel.hpp"
#include "ui/panels/command_palette.hpp"
#include "ui/panels/compare_lanes.hpp"
#include "ui/panels/depth_panel.hpp"
#include "ui/panels/event_panel.hpp"
#include "ui/panels/help_dialogs.hpp"
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/key_editor.hpp"
#include "ui/panels/lane_view.hpp"
#include "ui/panels/margin_curve.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_tools.hpp"
#include "ui/panels/pair_matrix.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/person_editor.hpp"
#include "ui/panels/recording_panel.hpp"
#include "ui/panels/robot_panel.hpp"
#include "ui/panels/separation_panel.hpp"
#include "ui/panels/start_page.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/panels/time_strip.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/plots/cycle_panel.hpp"
#include "ui/plots/plot_panel.hpp"
#include "ui/project_commands.hpp"
#include "ui/reading_dialog.hpp"
#include "ui/report_commands.hpp"
#include "ui/speed_commands.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"
#include "ui/style/units.hpp"
#include "ui/time_commands.hpp"
#include "ui/time_preview.hpp"
#include "ui/tour_steps.hpp"
#include "ui/verification_commands.hpp"
#include "ui/video_recorder.hpp"
#include "ui/viewport/viewport.hpp"
#include "ui/what_if_dialog.hpp"

namespace abstand::ui {

namespace {
using Id = ActionId;
constexpr int kSlowMs = 100, kMaxTreeLevels = 20;
}  // namespace

void MainWindow::connectView() {
  for (const Id id : {Id::kForces, Id::kTorques, Id::kJointTorques, Id::kVelocities, Id::kClosest,
                      Id::kLabels, Id::kFloor, Id::kShadows, Id::kTransparent, Id::kAutoScale})
    connect((*actions_)[id], &QAction::toggled, this, &MainWindow::applyOptions);
  connect(opacity_, &QSlider::valueChanged, this, &MainWindow::applyOptions);
  connect(opacity_, &QSlider::sliderReleased, document_, &Document::endStep);
  commands_.camera = new CameraCommands(*actions_, *viewport_, *selection_, this);
  connect(feed_, &MomentFeed::aboutToShow, this, [this] { commands_.camera->follow(feed_->moment()); });
  const auto on = [&](Id id, auto&& command) {
    connect((*actions_)[id], &QAction::triggered, this, command);
  };
  on(Id::kClearSelection, [this] { selection_->clear(); });
  connect((*actions_)[Id::kFollowPlots], &QAction::toggled, panels_.plots, &PlotPanel::setFollow);
  connect(panels_.plots, &PlotPanel::followChanged, (*actions_)[Id::kFollowPlots], &QAction::setChecked);
  on(Id::kFindPair, [this] {
    DockSet::raise(docks_->pairs);
    panels_.pairs->filterBox()->setFocus(Qt::ShortcutFocusReason);
  });
  connect((*actions_)[Id::kFullScreen], &QAction::toggled, this,
          [this](bool full) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, full)); });
  on(Id::kResetLayout, [this] { docks_->arrange(); });
  on(Id::kLayoutReplay, [this] { docks_->arrangeFor(DockSet::Task::kReplay); });
  on(Id::kLayoutTuning, [this] { docks_->arrangeFor(DockSet::Task::kTuning); });
  on(Id::kLayoutReview, [this] { docks_->arrangeFor(DockSet::Task::kReview); });
  on(Id::kLookInside, [this] {
    const int next = (static_cast<int>(viewport_->insideView()) + 1) % kInsideViews;
    lookInside(static_cast<InsideView>(next), viewport_->insideLevel());
  });
  on(Id::kTreeFiner, [this] { lookInside(InsideView::kTree, viewport_->insideLevel() + 1); });
  on(Id::kTreeCoarser, [this] { lookInside(InsideView::kTree, viewport_->insideLevel() - 1); });
  on(Id::kArrowOptions, [this] {
    if (const auto view = askArrows(document_->work().view, this))
      document_->edit(tr("arrows"), [&](Work& work) { work.view = *view; });
  });
  connect((*actions_)[Id::kMetres], &QAction::toggled, this, &MainWindow::followUnits);
  connect((*actions_)[Id::kRadians], &QAction::toggled, this, &MainWindow::followUnits);
  followUnits();
}

void MainWindow::lookInside(InsideView view, int level) {
  level = std::clamp(level, 0, kMaxTreeLevels);
  viewport_->setInsideView(view, level);
  const QString of = selection_->objects().empty() ? tr(" Select a body to see it.") : QString();
  switch (view) {
    case InsideView::kNothing:
      return say(tr("Inside of the selection: nothing"));
    case InsideView::kPoints:
      return say(tr("Inside of the selection: shell points.") + of);
    case InsideView::kTree:
      return say(tr("Inside of the selection: spheres of the tree, level %1.").arg(level) + of);
    case InsideView::kSlice:
      return say(tr("Inside of the selection: distances on a plane through its middle, dark from 50 mm on; "
                    "pink: inside.") +
                 of);
  }
}

void MainWindow::followUnits() {
  Units::shown().setLength((*actions_)[Id::kMetres]->isChecked() ? LengthUnit::kMetre
                                                                 : LengthUnit::kMillimetre);
  Units::shown().setAngle((*actions_)[Id::kRadians]->isChecked() ? AngleUnit::kRadian : AngleUnit::kDegree);
  feed_->show();
}

void MainWindow::connectHelp() {
  const auto on = [&](Id id, auto&& command) {
    connect((*actions_)[id], &QAction::triggered, this, command);
  };
  on(Id::kQuit, [this] { close(); });
  on(Id::kPalette, [this] { (new CommandPalette(*actions_, this))->open(); });
  on(Id::kShortcuts, [this] { showShortcuts(*actions_, this); });
  on(Id::kEditKeys, [this] { (new KeyEditor(*actions_, this))->open(); });
  on(Id::kTour, [this] { (new Tour(tourSteps(*docks_), this))->show(); });
  on(Id::kVerify, [this] { commands_.verification->open(); });
  on(Id::kAbout, [this] { showAbout(this); });
  connect(start_, &StartPage::fileWanted, this, &MainWindow::openFile);
}

/// The selection in one part of the window is that of all.
void MainWindow::connectSelection() {
  connect(selection_, &Selection::changed, this, [this] {
    panels_.timeline->laneView()->setSelected(selection_->objects());
    panels_.margins->setSelected(selection_->objects());
    feed_->watched().setSelected(selection_->objects(), selection_->pair());
  });
  connect((*actions_)[Id::kPinPlot], &QAction::triggered, this, &MainWindow::pinSelection);
  connect((*actions_)[Id::kUnpinPlots], &QAction::triggered, &feed_->watched(), &WatchedSeries::unpinAll);
  connect(panels_.separation, &SeparationPanel::pairPicked, this, &MainWindow::choosePair);
  connect(panels_.separation, &SeparationPanel::edited, this, [this](const SeparationSettings& settings) {
    document_->edit(
        tr("separation"), [&](Work& work) { work.separation = settings; }, QStringLiteral("separation"));
  });
}

void MainWindow::pinSelection() {
  if (selection_->pair() >= 0) return feed_->watched().pin({{Watched::Kind::kPair, selection_->pair()}});
  std::vector<Watched> bodies;
  for (const int object : selection_->objects()) bodies.push_back({Watched::Kind::kBody, object});
  if (bodies.empty()) return say(tr("Select a body or a pair first"));
  feed_->watched().pin(bodies);
}

void MainWindow::connectTime() {
  const auto* times =
      new TimeCommands(*actions_, {*playback_, *axis_, *review_, feed_->history(), *document_}, this);
  connect(times, &TimeCommands::said, this, &MainWindow::say);
  connect((*actions_)[Id::kGoToTime], &QAction::triggered, this, [this] {
    DockSet::raise(docks_->timeline);
    panels_.timeline->timeField()->setFocus(Qt::ShortcutFocusReason);
  });
  const auto previews = std::make_shared<TimePreview>(*review_, *viewport_);
  const MomentTips tips = [previews](double t, const QString& text) { return previews->tip(t, text); };
  panels_.timeline->strip()->setTips(tips);
  panels_.timeline->laneView()->setTips(tips);
  connect(viewport_, &Viewport::scrubbed, this,
          [this](double share) { playback_->seek(playback_->time() + share * axis_->view().length()); });
  connect(panels_.plots, &PlotPanel::timePicked, playback_, &Playback::seek);
  connect(panels_.cycles, &CyclePanel::timePicked, playback_, &Playback::seek);
  connect(playback_, &Playback::timeChanged, panels_.plots, &PlotPanel::setTime);
  connect(playback_, &Playback::timeChanged, panels_.cycles, &CyclePanel::setTime);
  timers_.pull = new QTimer(this);
  timers_.pull->setTimerType(Qt::PreciseTimer);
  timers_.pull->setInterval(viewport_->interval());
  connect(timers_.pull, &QTimer::timeout, this, &MainWindow::pull);
  timers_.slow = new QTimer(this);
  timers_.slow->setInterval(kSlowMs);
  connect(timers_.slow, &QTimer::timeout, feed_, &MomentFeed::refreshSlow);
  connect(timers_.slow, &QTimer::timeout, commands_.live, &LiveCommands::refresh);
  connect(feed_, &MomentFeed::spanMoved, this, &MainWindow::followSpan);
}

void MainWindow::connectSession() {
  connect((*actions_)[Id::kReact], &QAction::toggled, this, [this](bool react) {
    if (session_) session_->setReact(react);
  });
  connect((*actions_)[Id::kResetStops], &QAction::triggered, this, [this] {
    if (session_) session_->resetStops();
  });
  const auto show_reset_key = [this] {
    viewport_->setResetKey((*actions_)[Id::kResetStops]->shortcut().toString(QKeySequence::NativeText));
  };
  connect((*actions_)[Id::kResetStops], &QAction::changed, viewport_, show_reset_key);
  show_reset_key();
  connect((*actions_)[Id::kReactionTorques], &QAction::toggled, this, [this](bool torques) {
    if (session_) session_->setTorques(torques);
  });
  connect(panels_.robots, &RobotPanel::resetRequested, (*actions_)[Id::kResetStops], &QAction::trigger);
  connect(feed_, &MomentFeed::restarted, this, [this](double t) {
    say(tr("Robots were restarted on their planned motion at %1").arg(secondsWithUnit(t)));
  });
  connect(feed_, &MomentFeed::shown, this, [this] { commands_.videos->onMoment(feed_->moment().t); });
  connect(tree_model_, &SceneTreeModel::visibilityChanged, viewport_, &Viewport::setObjectVisible);
  connect(review_, &RecordingReview::changed, this, [this] { panels_.status->showAnalysis(*review_); });
}

void MainWindow::connectPicks() {
  connect(panels_.recordings, &RecordingPanel::wanted, this, &MainWindow::openRecordingRequested);
  connect(panels_.timeline->laneView(), &LaneView::pairPicked, this, &MainWindow::chooseLane);
  connect(panels_.events, &EventPanel::picked, this, [this](double t, int part, int link) {
    playback_->seek(t);
    chooseLane(part, link);
  });
  connect(panels_.events, &EventPanel::stopPicked, this, [this](double t, int pair) {
    playback_->seek(t);
    choosePair(pair);
  });
  connect(panels_.events, &EventPanel::kindsWanted, review_, &RecordingReview::showKinds);
  connect(panels_.robots, &RobotPanel::pairPicked, this, &MainWindow::choosePair);
}

void MainWindow::choosePair(int pair) {
  if (!session_ || pair < 0) return;
  const auto [a, b] = session_->outline().pairs[static_cast<std::size_t>(pair)];
  selection_->setPair(pair, a, b);
}

void MainWindow::chooseLane(int part, int link) {
  choosePair(review_->pairOf(static_cast<std::size_t>(part), static_cast<std::size_t>(link)));
}

void MainWindow::connectInspector() {
  InspectorPanel* panel = panels_.inspector;
  connect(selection_, &Selection::changed, this, [this, panel] {
    panel->setSubject(selection_->objects(), selection_->pair());
    panel->refresh(feed_->moment());
  });
  connect(docks_->inspector, &QDockWidget::visibilityChanged, this, [this, panel](bool visible) {
    panel->setInFront(visible);
    panel->refresh(feed_->moment());
  });
  connect(panel->person(), &PersonEditor::wanted, this, &MainWindow::personRequested);
  connect(docks_->matrix, &QDockWidget::visibilityChanged, this, [this](bool visible) {
    panels_.matrix->setInFront(visible);
    panels_.matrix->refresh(feed_->moment());
  });
  connect(docks_->depth, &QDockWidget::visibilityChanged, this, [this](bool visible) {
    panels_.depth->setInFront(visible);
    panels_.depth->refresh(feed_->moment());
  });
}

void MainWindow::connectDocument() {
  connectUndo();
  connectProjects();
  connectBookmarks();
  connectMargins();
}

void MainWindow::connectUndo() {
  QUndoStack& steps = document_->steps();
  QAction* undo = (*actions_)[ActionId::kUndo];
  QAction* redo = (*actions_)[ActionId::kRedo];
  undo->setEnabled(false);
  redo->setEnabled(false);
  connect(undo, &QAction::triggered, &steps, &QUndoStack::undo);
  connect(redo, &QAction::triggered, &steps, &QUndoStack::redo);
  connect(&steps, &QUndoStack::canUndoChanged, undo, &QAction::setEnabled);
  connect(&steps, &QUndoStack::canRedoChanged, redo, &QAction::setEnabled);
  const auto name = [](QAction* action, const QString& word, const QString& step) {
    QString safe = step;
    safe.replace(QLatin1Char('&'), QLatin1String("&&"));
    action->setText(step.isEmpty() ? word : tr("%1: %2").arg(word, safe));
  };
  connect(&steps, &QUndoStack::undoTextChanged, undo,
          [=](const QString& step) { name(undo, tr("&Undo"), step); });
  connect(&steps, &QUndoStack::redoTextChanged, redo,
          [=](const QString& step) { name(redo, tr("&Redo"), step); });
}

void MainWindow::connectProjects() {
  connect(document_, &Document::workChanged, this, &MainWindow::followWork);
  connect(document_, &Document::opened, this, &MainWindow::showDocument);
  connect(document_, &Document::titleChanged, this, &MainWindow::showTitle);
  connect(viewport_, &Viewport::cameraMoved, this, [this] {
    if (session_)
      document_->setViewpoint({viewport_->cameraView(), playback_->time(), document_->viewpoint().layout});
  });

  connect(panels_.status->cancelButton(), &QAbstractButton::clicked, this, &MainWindow::cancelRequested);
  connect((*actions_)[ActionId::kNew], &QAction::triggered, this, [this] {
    if (commands_.projects->mayDiscard()) Q_EMIT closeRequested();
  });
  connect((*actions_)[ActionId::kReload], &QAction::triggered, this, &MainWindow::reloadRequested);
  connect((*actions_)[ActionId::kRecordingOptions], &QAction::triggered, this, [this] {
    if (const auto reading = askReading(document_->work().reading, this))
      document_->edit(tr("recording options"), [&](Work& work) { work.reading = *reading; });
  });
  connect((*actions_)[ActionId::kSave], &QAction::triggered, commands_.projects, &ProjectCommands::save);
  connect((*actions_)[ActionId::kSaveAs], &QAction::triggered, commands_.projects, &ProjectCommands::saveAs);
  connect(commands_.projects, &ProjectCommands::aboutToSave, this, [this] {
    if (session_)
      document_->setViewpoint({document_->viewpoint().camera, playback_->time(), docks_->layout()});
  });
  connect(commands_.projects, &ProjectCommands::openWanted, this, &MainWindow::openProjectRequested);
  connect(commands_.projects, &ProjectCommands::failed, this, &MainWindow::showProblem);
  connect(commands_.projects, &ProjectCommands::saved, this, [this](const QString& file) {
    rememberFile(file);
    commands_.files->showRecent();
    say(tr("Saved %1").arg(file));
  });
}

void MainWindow::connectBookmarks() {
  auto* bookmarks = new BookmarkCommands(*document_, *playback_, *viewport_, this);
  connect((*actions_)[ActionId::kAddBookmark], &QAction::triggered, bookmarks, &BookmarkCommands::add);
  connect((*actions_)[ActionId::kRemoveBookmark], &QAction::triggered, bookmarks,
          &BookmarkCommands::removeHere);
  connect((*actions_)[ActionId::kNextBookmark], &QAction::triggered, bookmarks, &BookmarkCommands::goToNext);
  connect((*actions_)[ActionId::kPreviousBookmark], &QAction::triggered, bookmarks,
          &BookmarkCommands::goToPrevious);
  connect(panels_.bookmarks, &BookmarkPanel::picked, bookmarks, &BookmarkCommands::goTo);
  connect(panels_.bookmarks, &BookmarkPanel::noteWanted, bookmarks, &BookmarkCommands::setNote);
  connect(panels_.bookmarks, &BookmarkPanel::removeWanted, bookmarks, &BookmarkCommands::remove);
  connect(bookmarks, &BookmarkCommands::said, this, &MainWindow::say);
}

void MainWindow::connectMargins() {
  connect(commands_.margins, &MarginCommands::failed, this, &MainWindow::showProblem);
  connect(commands_.margins, &MarginCommands::said, this, &MainWindow::say);
  connect(commands_.margins, &MarginCommands::picked, panels_.events, &EventPanel::picked);
  connect(commands_.margins, &MarginCommands::compared, panels_.timeline->compareLanes(),
          &CompareLanes::setCompared);
  connect(panels_.timeline->compareLanes(), &CompareLanes::closeWanted, this,
          [this] { commands_.margins->compare(false); });
  connect(panels_.curve, &MarginCurve::dragged, this, [this](int object, double metres) {
    // The curve shows the margin of the class where that has its own.
    if (SessionFollower::classMargin(document_->work(), view::PairClass::kPersonRobot))
      commands_.margins->setClass(view::PairClass::kPersonRobot, metres);
    else
      panels_.margins->hold(object, metres);
  });
  connect(panels_.curve, &MarginCurve::released, document_, &Document::endStep);
  connect(panels_.curve, &MarginCurve::released, panels_.margins, &MarginPanel::release);
  connect((*actions_)[ActionId::kReport], &QAction::triggered, this, [this] {
    const std::string margins = commands_.margins->presentSet();
    if (margins.empty()) return;
    const Work& work = document_->work();
    commands_.reports->ask(margins, work.scene.isEmpty() ? work.recording : work.scene, work.what_if);
  });
  connect((*actions_)[ActionId::kProposeSpeeds], &QAction::triggered, commands_.speeds, &SpeedCommands::open);
  connect(commands_.speeds, &SpeedCommands::picked, playback_, &Playback::seek);
  connect((*actions_)[ActionId::kWhatIf], &QAction::triggered, this, [this] {
    if (const auto what_if = askWhatIf(document_->work().what_if, this))
      document_->edit(tr("what-if assumptions"), [&](Work& work) { work.what_if = *what_if; });
  });
  connect(commands_.reports, &ReportCommands::failed, this, &MainWindow::showProblem);
  connect((*actions_)[ActionId::kFindMargin], &QAction::triggered, this, [this] {
    DockSet::raise(docks_->margins);
    panels_.margin_tools->search()->setFocus(Qt::ShortcutFocusReason);
  });
}

}  // namespace abstand::ui
