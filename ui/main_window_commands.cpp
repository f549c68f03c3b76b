// What the commands of the window do.
#include <QApplication>
#include <QClipboard>
#include <QDateTime>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QSlider>
#include <QStatusBar>

#include "ui/main_window.hpp"
#include "ui/model/bookmarks.hpp"
#include "ui/model/play_rules.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recent_files.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/run_history.hpp"
#include "ui/model/scene_tree_model.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/time_axis.hpp"
#include "ui/panels/bookmark_panel.hpp"
#include "ui/panels/event_panel.hpp"
#include "ui/panels/group_panel.hpp"
#include "ui/panels/help_dialogs.hpp"
#include "ui/panels/lane_view.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/robot_panel.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/panels/time_strip.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/plots/plot_panel.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/file_kinds.hpp"
#include "ui/style/format.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/picture_file.hpp"
#include "ui/style/theme.hpp"
#include "ui/viewport/viewport.hpp"
#include "ui/window_grab.hpp"

namespace abstand::ui {

namespace {
using Id = ActionId;
}

void MainWindow::connectFile() {
  connect((*actions_)[Id::kOpenScene], &QAction::triggered, this,
          [this] { openFile(QFileDialog::getOpenFileName(this, tr("Open scene"), {}, sceneFilter())); });
  connect((*actions_)[Id::kOpenRecording], &QAction::triggered, this, [this] {
    const QString path = QFileDialog::getOpenFileName(this, tr("Open recording"), {}, recordingFilter());
    if (!path.isEmpty()) Q_EMIT openRecordingRequested(path);
  });
  for (int i = 0; i < kRecentFiles; ++i) {
    QAction* action = (*actions_)[static_cast<Id>(static_cast<int>(Id::kRecent1) + i)];
    connect(action, &QAction::triggered, this, [this, action] { openFile(action->data().toString()); });
  }
  connect((*actions_)[Id::kScreenshot], &QAction::triggered, this, &MainWindow::saveScreenshot);
  connect((*actions_)[Id::kCopyPicture], &QAction::triggered, this,
          [this] { QApplication::clipboard()->setImage(viewport_->picture()); });
  connect((*actions_)[Id::kQuit], &QAction::triggered, this, &QWidget::close);
  connect((*actions_)[Id::kShortcuts], &QAction::triggered, this, [this] { showShortcuts(*actions_, this); });
  connect((*actions_)[Id::kAbout], &QAction::triggered, this, [this] { showAbout(this); });
}

void MainWindow::connectView() {
  for (const Id id : {Id::kForces, Id::kTorques, Id::kVelocities, Id::kClosest, Id::kLabels, Id::kFloor,
                      Id::kShadows, Id::kTransparent, Id::kAutoScale})
    connect((*actions_)[id], &QAction::toggled, this, &MainWindow::applyOptions);
  connect(opacity_, &QSlider::valueChanged, this, &MainWindow::applyOptions);
  const std::pair<Id, CameraPreset> presets[] = {{Id::kFront, CameraPreset::kFront},
                                                 {Id::kSide, CameraPreset::kSide},
                                                 {Id::kTop, CameraPreset::kTop},
                                                 {Id::kIso, CameraPreset::kIso}};
  for (const auto& [id, preset] : presets)
    connect((*actions_)[id], &QAction::triggered, this, [this, p = preset] { viewport_->look(p); });
  connect((*actions_)[Id::kFit], &QAction::triggered, viewport_, &Viewport::fit);
  connect((*actions_)[Id::kFitSelection], &QAction::triggered, viewport_, &Viewport::fitSelection);
  connect((*actions_)[Id::kClearSelection], &QAction::triggered, selection_, &Selection::clear);
  connect((*actions_)[Id::kFollowPlots], &QAction::toggled, plots_, &PlotPanel::setFollow);
  connect(plots_, &PlotPanel::followChanged, (*actions_)[Id::kFollowPlots], &QAction::setChecked);
  connect((*actions_)[Id::kFindPair], &QAction::triggered, this, [this] {
    docks_[1]->show();
    pairs_->filterBox()->setFocus(Qt::ShortcutFocusReason);
  });
  connect((*actions_)[Id::kDarkTheme], &QAction::toggled, this, [this](bool dark) {
    applyTheme(*qApp, dark ? Theme::kDark : Theme::kLight);
    tree_model_->setTheme(dark ? Theme::kDark : Theme::kLight);
  });
  connect((*actions_)[Id::kFullScreen], &QAction::toggled, this,
          [this](bool on) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, on)); });
  connect((*actions_)[Id::kResetLayout], &QAction::triggered, this, &MainWindow::arrangeDocks);
}

void MainWindow::connectPlayback() {
  QAction* play = (*actions_)[Id::kPlay];
  connect(play, &QAction::triggered, this, [this] { playback_->setPlaying(!playback_->playing()); });
  connect(playback_, &Playback::playingChanged, this, [play](bool playing) {
    play->setIcon(icon(playing ? Glyph::kPause : Glyph::kPlay));
    play->setText(playing ? tr("&Pause") : tr("&Play"));
  });
  const auto on = [&](Id id, auto&& command) {
    connect((*actions_)[id], &QAction::triggered, this, command);
  };
  on(Id::kStepForward, [this] { playback_->stepFrames(1); });
  on(Id::kStepBack, [this] { playback_->stepFrames(-1); });
  on(Id::kForwardSecond, [this] { playback_->jump(1.0); });
  on(Id::kBackSecond, [this] { playback_->jump(-1.0); });
  on(Id::kToStart, [this] { playback_->toStart(); });
  on(Id::kToEnd, [this] { playback_->toEnd(); });
  on(Id::kFaster, [this] { playback_->faster(); });
  on(Id::kSlower, [this] { playback_->slower(); });
  on(Id::kNextContact, [this] { goToEvent(true); });
  on(Id::kPreviousContact, [this] { goToEvent(false); });
  on(Id::kResetMargins, [this] { margins_->reset(); });
  connect((*actions_)[Id::kLoop], &QAction::toggled, playback_, &Playback::setLoop);
  connect((*actions_)[Id::kReact], &QAction::toggled, this, [this](bool react) {
    if (session_) session_->setReact(react);
  });
  on(Id::kResetStops, [this] {
    if (session_) session_->resetStops();
  });
  connect((*actions_)[Id::kReactionTorques], &QAction::toggled, this, [this](bool torques) {
    if (session_) session_->setTorques(torques);
  });
  connect(robots_, &RobotPanel::resetRequested, (*actions_)[Id::kResetStops], &QAction::trigger);
}

void MainWindow::connectPanels() {
  connect(tree_model_, &SceneTreeModel::visibilityChanged, viewport_, &Viewport::setObjectVisible);
  connect(margins_, &MarginPanel::marginChanged, this, [this](int object, double metres) {
    if (session_) session_->setMargin(object, metres);
    review_->setMargin(object, metres);
  });
  connect(groups_, &GroupPanel::stateWanted, this, [this](int group, view::PairGroupState state) {
    if (session_) session_->setGroup(group, state);
  });
  connect(groups_, &GroupPanel::addWanted, this, [this](int group, int pair) {
    if (session_) session_->addPair(group, pair);
  });
  connect(groups_, &GroupPanel::removeWanted, this, [this](int pair) {
    if (session_) session_->removePair(pair);
  });
  connect(plots_, &PlotPanel::jointChosen, this, [this](int joint) {
    history_->torqueOf(joint);
    history_->add(snapshot_);
  });
  connect(plots_, &PlotPanel::timePicked, playback_, &Playback::seek);
  connect(playback_, &Playback::timeChanged, plots_, &PlotPanel::setTime);
}

void MainWindow::connectReview() {
  const auto on = [&](Id id, auto&& command) {
    connect((*actions_)[id], &QAction::triggered, this, command);
  };
  on(Id::kGoToTime, [this] {
    docks_[2]->show();
    timeline_->timeField()->setFocus(Qt::ShortcutFocusReason);
  });
  on(Id::kSetIn, [this] { axis_->setIn(playback_->time()); });
  on(Id::kSetOut, [this] { axis_->setOut(playback_->time()); });
  on(Id::kClearRange, [this] { axis_->setRange({}); });
  on(Id::kZoomTimeIn, [this] { axis_->zoomSteps(2.0, playback_->time()); });
  on(Id::kZoomTimeOut, [this] { axis_->zoomSteps(-2.0, playback_->time()); });
  on(Id::kZoomTimeAll, [this] { axis_->showAll(); });
  connect((*actions_)[Id::kPauseOnEvent], &QAction::toggled, rules_, &PlayRules::setPauseOnEvents);
  connect(rules_, &PlayRules::pausedAt, this, [this](double t) {
    statusBar()->showMessage(tr("Paused at an event, %1").arg(secondsWithUnit(t)), 3000);
  });
  on(Id::kAddBookmark, [this] {
    bookmarks_->add(playback_->time());
    statusBar()->showMessage(tr("Bookmark at %1").arg(secondsWithUnit(playback_->time())), 3000);
  });
  connect(bookmark_panel_, &BookmarkPanel::picked, playback_, &Playback::seek);
  connect(bookmarks_, &Bookmarks::changed, this, [this] {
    std::vector<double> times;
    for (const Bookmark& bookmark : bookmarks_->all()) times.push_back(bookmark.t);
    timeline_->strip()->setBookmarks(std::move(times));
  });
  connect(playback_, &Playback::timeChanged, axis_, &TimeAxis::reveal);
  connect(timeline_->laneView(), &LaneView::pairPicked, this, &MainWindow::choosePair);
  connect(events_, &EventPanel::picked, this, [this](double t, int part, int link) {
    playback_->seek(t);
    choosePair(part, link);
  });
  connect(review_, &RecordingReview::changed, this, [this] { status_->showAnalysis(*review_); });
}

void MainWindow::choosePair(int part, int link) {
  const int pair = review_->pairOf(static_cast<std::size_t>(part), static_cast<std::size_t>(link));
  if (!session_ || pair < 0) return;
  const auto [a, b] = session_->outline().pairs[static_cast<std::size_t>(pair)];
  selection_->setPair(pair, a, b);
}

void MainWindow::applyOptions() {
  const auto checked = [this](Id id) { return (*actions_)[id]->isChecked(); };
  ViewOptions options = viewport_->options();
  options.forces = checked(Id::kForces);
  options.torques = checked(Id::kTorques);
  options.velocities = checked(Id::kVelocities);
  options.closest = checked(Id::kClosest);
  options.labels = checked(Id::kLabels);
  options.floor = checked(Id::kFloor);
  options.shadows = checked(Id::kShadows);
  options.auto_scale = checked(Id::kAutoScale);
  options.human_opacity = checked(Id::kTransparent) ? opacity_->value() / 100.0 : 1.0;
  opacity_->setEnabled(checked(Id::kTransparent));
  viewport_->setOptions(options);
}

void MainWindow::goToEvent(bool next) {
  const double now = playback_->time();
  std::optional<double> t;
  if (review_->available())
    t = next ? review_->nextEvent(now) : review_->previousEvent(now);
  else
    t = next ? history_->nextContact(now) : history_->previousContact(now);
  if (t)
    playback_->seek(*t);
  else
    statusBar()->showMessage(next ? tr("No later event known") : tr("No earlier event known"), 3000);
}

void MainWindow::openFile(const QString& path) {
  switch (path.isEmpty() ? FileKind::kUnknown : kindOf(path)) {
    case FileKind::kScene:
      if (QFileInfo::exists(path)) {
        rememberFile(path);
        showRecent();
      }
      Q_EMIT openSceneRequested(path);
      break;
    case FileKind::kRecording:
      Q_EMIT openRecordingRequested(path);
      break;
    case FileKind::kUnknown:
      break;
  }
}

void MainWindow::showRecent() {
  const QStringList files = recentFiles();
  for (int i = 0; i < kRecentFiles; ++i) {
    QAction* action = (*actions_)[static_cast<Id>(static_cast<int>(Id::kRecent1) + i)];
    action->setVisible(i < files.size());
    if (i >= files.size()) continue;
    action->setData(files[i]);
    action->setText(QFileInfo(files[i]).fileName().replace(QLatin1Char('&'), QLatin1String("&&")));
    action->setStatusTip(files[i]);
  }
}

void MainWindow::saveScreenshot() {
  const QImage picture = grabWindow(*this);
  const QString name = QStringLiteral("abstand-%1.png")
                           .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")));
  const QString path =
      QFileDialog::getSaveFileName(this, tr("Save screenshot"), name, tr("Pictures (*.png)"));
  if (path.isEmpty()) return;
  try {
    savePicture(picture, path);
    statusBar()->showMessage(tr("Saved %1").arg(path), 4000);
  } catch (const std::exception& e) {
    showProblem(tr("Screenshot"), QString::fromUtf8(e.what()));
  }
}

}  // namespace abstand::ui
