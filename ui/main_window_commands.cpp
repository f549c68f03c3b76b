// What the commands of the window do.
#include <QApplication>
#include <QClipboard>
#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QSlider>
#include <QStatusBar>

#include "ui/dock_set.hpp"
#include "ui/document/document.hpp"
#include "ui/main_window.hpp"
#include "ui/margin_commands.hpp"
#include "ui/model/play_rules.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recent_files.hpp"
#include "ui/model/recent_folder.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/run_history.hpp"
#include "ui/model/scene_tree_model.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/time_axis.hpp"
#include "ui/panels/command_palette.hpp"
#include "ui/panels/event_panel.hpp"
#include "ui/panels/help_dialogs.hpp"
#include "ui/panels/key_editor.hpp"
#include "ui/panels/lane_view.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/robot_panel.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/panels/time_strip.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/plots/cycle_panel.hpp"
#include "ui/plots/plot_export.hpp"
#include "ui/plots/plot_panel.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/file_kinds.hpp"
#include "ui/style/format.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/picture_file.hpp"
#include "ui/style/theme.hpp"
#include "ui/video_recorder.hpp"
#include "ui/viewport/viewport.hpp"
#include "ui/window_grab.hpp"

namespace abstand::ui {

namespace {
using Id = ActionId;
constexpr int kFeedbackMs = 4000;
constexpr double kKeyStep = 24.0;  // px that a key moves the camera
constexpr double kKeyZoom = 1.15;
}  // namespace

void MainWindow::connectFile() {
  connect((*actions_)[Id::kOpenScene], &QAction::triggered, this,
          [this] { openFile(QFileDialog::getOpenFileName(this, tr("Open"), recentFolder(), openFilter())); });
  connect((*actions_)[Id::kOpenRecording], &QAction::triggered, this, [this] {
    openFile(QFileDialog::getOpenFileName(this, tr("Open recording"), recentFolder(), recordingFilter()));
  });
  for (int i = 0; i < kRecentFiles; ++i) {
    QAction* action = (*actions_)[static_cast<Id>(static_cast<int>(Id::kRecent1) + i)];
    connect(action, &QAction::triggered, this, [this, action] { openFile(action->data().toString()); });
  }
  connect((*actions_)[Id::kSavePlots], &QAction::triggered, this, &MainWindow::savePlotsAs);
  connect((*actions_)[Id::kScreenshot], &QAction::triggered, this, &MainWindow::saveScreenshot);
  connect((*actions_)[Id::kCopyPicture], &QAction::triggered, this, [this] {
    QApplication::clipboard()->setImage(viewport_->picture());
    statusBar()->showMessage(tr("The picture is on the clipboard"), kFeedbackMs);
  });
  connect((*actions_)[Id::kQuit], &QAction::triggered, this, &QWidget::close);
  connect((*actions_)[Id::kPalette], &QAction::triggered, this,
          [this] { (new CommandPalette(*actions_, this))->open(); });
  connect((*actions_)[Id::kShortcuts], &QAction::triggered, this, [this] { showShortcuts(*actions_, this); });
  connect((*actions_)[Id::kEditKeys], &QAction::triggered, this,
          [this] { (new KeyEditor(*actions_, this))->open(); });
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
  const auto move = [this](Id id, auto&& camera) {
    connect((*actions_)[id], &QAction::triggered, this, camera);
  };
  move(Id::kOrbitLeft, [this] { viewport_->orbit(kKeyStep, 0.0); });
  move(Id::kOrbitRight, [this] { viewport_->orbit(-kKeyStep, 0.0); });
  move(Id::kOrbitUp, [this] { viewport_->orbit(0.0, kKeyStep); });
  move(Id::kOrbitDown, [this] { viewport_->orbit(0.0, -kKeyStep); });
  move(Id::kPanLeft, [this] { viewport_->pan(kKeyStep, 0.0); });
  move(Id::kPanRight, [this] { viewport_->pan(-kKeyStep, 0.0); });
  move(Id::kPanUp, [this] { viewport_->pan(0.0, kKeyStep); });
  move(Id::kPanDown, [this] { viewport_->pan(0.0, -kKeyStep); });
  move(Id::kZoomIn, [this] { viewport_->zoom(1.0 / kKeyZoom); });
  move(Id::kZoomOut, [this] { viewport_->zoom(kKeyZoom); });
  connect((*actions_)[Id::kFit], &QAction::triggered, viewport_, &Viewport::fit);
  connect((*actions_)[Id::kFitSelection], &QAction::triggered, viewport_, &Viewport::fitSelection);
  connect((*actions_)[Id::kClearSelection], &QAction::triggered, selection_, &Selection::clear);
  connect((*actions_)[Id::kFollowPlots], &QAction::toggled, panels_.plots, &PlotPanel::setFollow);
  connect(panels_.plots, &PlotPanel::followChanged, (*actions_)[Id::kFollowPlots], &QAction::setChecked);
  connect((*actions_)[Id::kFindPair], &QAction::triggered, this, [this] {
    DockSet::raise(docks_->pairs);
    panels_.pairs->filterBox()->setFocus(Qt::ShortcutFocusReason);
  });
  connect((*actions_)[Id::kDarkTheme], &QAction::toggled, this, [this](bool dark) {
    applyTheme(*qApp, dark ? Theme::kDark : Theme::kLight);
    tree_model_->setTheme(dark ? Theme::kDark : Theme::kLight);
  });
  connect((*actions_)[Id::kFullScreen], &QAction::toggled, this,
          [this](bool on) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, on)); });
  connect((*actions_)[Id::kResetLayout], &QAction::triggered, this, [this] { docks_->arrange(); });
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
  connect(panels_.robots, &RobotPanel::resetRequested, (*actions_)[Id::kResetStops], &QAction::trigger);
}

void MainWindow::connectPanels() {
  connect(tree_model_, &SceneTreeModel::visibilityChanged, viewport_, &Viewport::setObjectVisible);
  connect(panels_.plots, &PlotPanel::jointChosen, this, [this](int joint) {
    history_->torqueOf(joint);
    history_->add(snapshot_);
  });
  connect(panels_.plots, &PlotPanel::timePicked, playback_, &Playback::seek);
  connect(panels_.cycles, &CyclePanel::timePicked, playback_, &Playback::seek);
  connect(playback_, &Playback::timeChanged, panels_.plots, &PlotPanel::setTime);
  connect(playback_, &Playback::timeChanged, panels_.cycles, &CyclePanel::setTime);
}

void MainWindow::connectReview() {
  const auto on = [&](Id id, auto&& command) {
    connect((*actions_)[id], &QAction::triggered, this, command);
  };
  on(Id::kGoToTime, [this] {
    DockSet::raise(docks_->timeline);
    panels_.timeline->timeField()->setFocus(Qt::ShortcutFocusReason);
  });
  const auto keep_range = [this](const QString& text) {
    document_->edit(text, [this](Work& work) { work.range = axis_->range(); });
  };
  on(Id::kSetIn, [=, this] {
    axis_->setIn(playback_->time());
    keep_range(tr("set IN"));
  });
  on(Id::kSetOut, [=, this] {
    axis_->setOut(playback_->time());
    keep_range(tr("set OUT"));
  });
  on(Id::kClearRange, [=, this] {
    axis_->setRange({});
    keep_range(tr("clear IN and OUT"));
  });
  on(Id::kZoomTimeIn, [this] { axis_->zoomSteps(2.0, playback_->time()); });
  on(Id::kZoomTimeOut, [this] { axis_->zoomSteps(-2.0, playback_->time()); });
  on(Id::kZoomTimeAll, [this] { axis_->showAll(); });
  auto* rules = new PlayRules(*playback_, *axis_, *review_, this);
  connect((*actions_)[Id::kPauseOnEvent], &QAction::toggled, rules, &PlayRules::setPauseOnEvents);
  connect(rules, &PlayRules::pausedAt, this, [this](double t) {
    statusBar()->showMessage(tr("Paused at an event, %1").arg(secondsWithUnit(t)), 3000);
  });
  connect(playback_, &Playback::timeChanged, axis_, &TimeAxis::reveal);
  connect(panels_.timeline->laneView(), &LaneView::pairPicked, this, &MainWindow::choosePair);
  connect(panels_.events, &EventPanel::picked, this, [this](double t, int part, int link) {
    playback_->seek(t);
    choosePair(part, link);
  });
  connect(review_, &RecordingReview::changed, this, [this] { panels_.status->showAnalysis(*review_); });
}

void MainWindow::choosePair(int part, int link) {
  const int pair = review_->pairOf(static_cast<std::size_t>(part), static_cast<std::size_t>(link));
  if (!session_ || pair < 0) return;
  const auto [a, b] = session_->outline().pairs[static_cast<std::size_t>(pair)];
  selection_->setPair(pair, a, b);
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
  if (!path.isEmpty()) openFiles({path});
}

void MainWindow::openFiles(const QStringList& paths) {
  for (const QString& path : paths) {
    if (QFileInfo::exists(path)) {
      rememberFolder(path);
      if (kindOf(path) != FileKind::kUnknown) rememberFile(path);
    }
    switch (kindOf(path)) {
      case FileKind::kProject:
        projects_->open(path);
        break;
      case FileKind::kScene:
        // The same scene is read anew, and the document stays.
        if (QFileInfo(path).absoluteFilePath() == document_->work().scene || projects_->mayDiscard())
          Q_EMIT openSceneRequested(path);
        break;
      case FileKind::kRecording:
        Q_EMIT openRecordingRequested(path);
        break;
      case FileKind::kMargins:
        margin_commands_->openFile(path);
        break;
      case FileKind::kUnknown:
        showProblem(tr("Cannot open"),
                    tr("%1 is no file that this program opens.\n\nIt opens projects (.abstand), scenes and "
                       "margins (.yaml), "
                       "robots (.urdf, .mech) and recordings: folders of depth images and the files %2.")
                        .arg(path, recordingEndings()));
    }
  }
  showRecent();
}

void MainWindow::showRecent() {
  QStringList files;
  for (const QString& file : recentFiles())
    if (QFileInfo::exists(file)) files << file;
  for (int i = 0; i < kRecentFiles; ++i) {
    QAction* action = (*actions_)[static_cast<Id>(static_cast<int>(Id::kRecent1) + i)];
    action->setVisible(i < files.size());
    if (i >= files.size()) continue;
    action->setData(files[i]);
    // Files of the same name differ by their folders.
    const QFileInfo info(files[i]);
    action->setText(tr("%1  (%2)")
                        .arg(info.fileName(), QDir::toNativeSeparators(info.absolutePath()))
                        .replace(QLatin1Char('&'), QLatin1String("&&")));
    action->setStatusTip(files[i]);
  }
}

void MainWindow::connectVideo() {
  connect((*actions_)[Id::kVideo], &QAction::triggered, this, [this] {
    QFileDialog dialog(this, tr("Save video"), recentFolder(), tr("Videos (*.avi)"));
    dialog.setObjectName(QStringLiteral("save_video"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("avi"));
    dialog.selectFile(QStringLiteral("abstand.avi"));
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
    rememberFolder(dialog.selectedFiles().constFirst());
    outputs_.videos->start(dialog.selectedFiles().constFirst(), axis_->range().value_or(axis_->whole()));
  });
  connect(outputs_.videos, &VideoRecorder::failed, this, &MainWindow::showProblem);
  connect(outputs_.videos, &VideoRecorder::done, this,
          [this](const QString& file) { statusBar()->showMessage(tr("Saved %1").arg(file), kFeedbackMs); });
}

void MainWindow::savePlotsAs() {
  QFileDialog dialog(this, tr("Save plots"), recentFolder(),
                     tr("Table (*.csv);;Drawing (*.svg);;Picture (*.png)"));
  dialog.setObjectName(QStringLiteral("save_plots"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("csv"));
  connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
    dialog.setDefaultSuffix(filter.section(QLatin1String("*."), 1).chopped(1));
  });
  dialog.selectFile(QStringLiteral("plots"));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  const QString path = dialog.selectedFiles().constFirst();
  rememberFolder(path);
  try {
    savePlots(panels_.plots->charts(), path);
    statusBar()->showMessage(tr("Saved %1").arg(path), kFeedbackMs);
  } catch (const std::exception& e) {
    showProblem(tr("Save plots"), QString::fromUtf8(e.what()));
  }
}

void MainWindow::saveScreenshot() {
  const QImage picture = grabWindow(*this);
  const QString name = QStringLiteral("abstand-%1.png")
                           .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")));
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Save screenshot"), QDir(recentFolder()).filePath(name), tr("Pictures (*.png)"));
  if (path.isEmpty()) return;
  try {
    savePicture(picture, path);
    statusBar()->showMessage(tr("Saved %1").arg(path), 4000);
  } catch (const std::exception& e) {
    showProblem(tr("Screenshot"), QString::fromUtf8(e.what()));
  }
}

}  // namespace abstand::ui
