// The window: builds the panels and connects them.
#include "ui/main_window.hpp"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QSlider>
#include <QStatusBar>
#include <QTabBar>
#include <QTimer>

#include "ui/document/autosave.hpp"
#include "ui/document/document.hpp"
#include "ui/document/left_overs.hpp"
#include "ui/margin_commands.hpp"
#include "ui/menus.hpp"
#include "ui/model/moment_sample.hpp"
#include "ui/model/nearest_classes.hpp"
#include "ui/model/play_rules.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/run_history.hpp"
#include "ui/model/scene_tree_model.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/time_axis.hpp"
#include "ui/panels/bookmark_panel.hpp"
#include "ui/panels/event_panel.hpp"
#include "ui/panels/focus_keys.hpp"
#include "ui/panels/group_panel.hpp"
#include "ui/panels/margin_curve.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_tools.hpp"
#include "ui/panels/note_panel.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/recording_panel.hpp"
#include "ui/panels/robot_panel.hpp"
#include "ui/panels/scene_tree_panel.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/panels/time_strip.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/plots/plot_panel.hpp"
#include "ui/project_commands.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/file_kinds.hpp"
#include "ui/style/format.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/theme.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

namespace {

constexpr int kSlowMs = 100;
constexpr int kMessageMs = 3000;
constexpr int kPlotWidth = 280;  // px, at least
// Grows when panels come or go, so that an old layout is not applied to a new window.
constexpr int kLayoutVersion = 7;

using Id = ActionId;

/// Those whose state is the user's taste and outlives the program.
struct Remembered {
  Id id;
  const char* key;
};
constexpr Remembered kRemembered[] = {
    {Id::kForces, "view/forces"},           {Id::kTorques, "view/torques"},
    {Id::kVelocities, "view/velocities"},   {Id::kClosest, "view/closest"},
    {Id::kLabels, "view/labels"},           {Id::kFloor, "view/floor"},
    {Id::kShadows, "view/shadows"},         {Id::kLoop, "playback/loop"},
    {Id::kTransparent, "view/transparent"}, {Id::kAutoScale, "view/auto_scale"}};

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      history_{std::make_unique<RunHistory>()},
      document_{new Document(this)},
      projects_{new ProjectCommands(*document_, this)},
      actions_{new Actions(this)},
      playback_{new Playback(this)},
      review_{new RecordingReview(this)},
      axis_{new TimeAxis(this)},
      rules_{new PlayRules(*playback_, *axis_, *review_, this)},
      selection_{new Selection(this)},
      tree_model_{new SceneTreeModel(this)} {
  const QVariant dark = QSettings().value(QStringLiteral("window/dark"));
  const bool is_dark = dark.isValid() ? dark.toBool() : themeOf(QApplication::palette()) == Theme::kDark;
  applyTheme(*qApp, is_dark ? Theme::kDark : Theme::kLight);
  (*actions_)[Id::kDarkTheme]->setChecked(is_dark);
  tree_model_->setTheme(is_dark ? Theme::kDark : Theme::kLight);

  setWindowIcon(programIcon());
  setAcceptDrops(true);
  setDockNestingEnabled(true);
  viewport_ = new Viewport(*selection_, this);
  setCentralWidget(viewport_);
  status_ = new StatusPanel(statusBar());
  new FocusKeys(this);
  buildDocks();
  opacity_ = buildMenus(*this, *actions_);
  connectFile();
  connectView();
  connectPlayback();
  connectPanels();
  connectReview();
  connectDocument();
  resize(1440, 900);
  arrangeDocks();
  restore();
  Project first;
  first.work.view = document_->work().view;
  document_->open(first, QString(), false);

  pull_timer_ = new QTimer(this);
  pull_timer_->setTimerType(Qt::PreciseTimer);
  pull_timer_->setInterval(viewport_->interval());
  connect(pull_timer_, &QTimer::timeout, this, &MainWindow::pull);
  slow_timer_ = new QTimer(this);
  slow_timer_->setInterval(kSlowMs);
  connect(slow_timer_, &QTimer::timeout, this, &MainWindow::refreshSlow);
  setSession(nullptr);
}

MainWindow::~MainWindow() = default;

void MainWindow::buildDocks() {
  tree_ = new SceneTreePanel(*tree_model_, *selection_, this);
  margins_ = new MarginPanel(this);
  robots_ = new RobotPanel(this);
  groups_ = new GroupPanel(this);
  notes_ = new NotePanel(this);
  recordings_ = new RecordingPanel((*actions_)[Id::kRecordingOptions], this);
  plots_ = new PlotPanel(this);
  plots_->setMinimumWidth(kPlotWidth);
  pairs_ = new PairPanel(*selection_, this);
  timeline_ = new TimelinePanel(*actions_, *playback_, *review_, *axis_, this);
  events_ = new EventPanel(*review_, this);
  bookmark_panel_ = new BookmarkPanel(this);
  curve_ = new MarginCurve(*review_, *selection_, this);
  docks_ = {
      addDock("scene", tr("Scene"), tr("Show or hide the scene tree"), QStringLiteral("Ctrl+1"), tree_),
      addDock("pairs", tr("Pairs"), tr("Show or hide the pair table"), QStringLiteral("Ctrl+2"), pairs_),
      addDock("timeline", tr("Timeline"), tr("Show or hide the timeline"), QStringLiteral("Ctrl+3"),
              timeline_),
      addDock("plots", tr("Plots"), tr("Show or hide the plots"), QStringLiteral("Ctrl+4"), plots_),
      addDock("margins", tr("Safety margins"), tr("Show or hide the margins"), QStringLiteral("Ctrl+5"),
              new MarginTools(margins_, *actions_, this)),
      addDock("robots", tr("Robots"), tr("Show or hide the robots that react"), QStringLiteral("Ctrl+6"),
              robots_),
      addDock("groups", tr("Pair groups"), tr("Show or hide the groups of pairs"), QStringLiteral("Ctrl+7"),
              groups_),
      addDock("notes", tr("Reservations"), tr("Show or hide what to know of the scene before believing it"),
              QStringLiteral("Ctrl+8"), notes_),
      addDock("events", tr("Events"), tr("Show or hide the events of the recording"),
              QStringLiteral("Ctrl+9"), events_),
      addDock("bookmarks", tr("Bookmarks"), tr("Show or hide the bookmarks"), QStringLiteral("Ctrl+Shift+9"),
              bookmark_panel_),
      addDock("recordings", tr("Recording"), tr("Show or hide what was read of the recordings"),
              QStringLiteral("Ctrl+Shift+8"), recordings_),
      addDock("curve", tr("Margin curve"), tr("Show or hide what the margin of a body part costs"),
              QStringLiteral("Ctrl+Shift+5"), curve_)};
}

QDockWidget* MainWindow::addDock(const char* name, const QString& title, const QString& tip,
                                 const QString& key, QWidget* content) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(QString::fromLatin1(name));
  dock->setWidget(content);
  // What was hidden may show an older moment.
  connect(dock, &QDockWidget::visibilityChanged, this, [this](bool visible) {
    if (visible) showMoment();
  });
  actions_->adopt(dock->toggleViewAction(), ActionGroup::kPanels, tip, QKeySequence(key));
  return dock;
}

void MainWindow::arrangeDocks() {
  auto [scene, pairs, timeline, plots, margins, robots, groups, notes, events, bookmarks, recordings, curve] =
      std::tie(docks_[0], docks_[1], docks_[2], docks_[3], docks_[4], docks_[5], docks_[6], docks_[7],
               docks_[8], docks_[9], docks_[10], docks_[11]);
  for (QDockWidget* dock : docks_) {
    dock->setFloating(false);
    dock->show();
  }
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  addDockWidget(Qt::LeftDockWidgetArea, scene);
  addDockWidget(Qt::RightDockWidgetArea, plots);
  addDockWidget(Qt::RightDockWidgetArea, margins);
  splitDockWidget(plots, margins, Qt::Vertical);
  tabifyDockWidget(margins, robots);
  tabifyDockWidget(robots, groups);
  tabifyDockWidget(groups, notes);
  margins->raise();
  addDockWidget(Qt::BottomDockWidgetArea, timeline);
  addDockWidget(Qt::BottomDockWidgetArea, pairs);
  splitDockWidget(timeline, pairs, Qt::Vertical);
  tabifyDockWidget(pairs, events);
  tabifyDockWidget(events, bookmarks);
  tabifyDockWidget(bookmarks, recordings);
  tabifyDockWidget(recordings, curve);
  pairs->raise();
  for (QTabBar* tabs : findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
    tabs->setAccessibleName(tr("Panels"));
  resizeDocks({scene, plots}, {284, 370}, Qt::Horizontal);
  resizeDocks({timeline, pairs}, {236, 110}, Qt::Vertical);
  resizeDocks({plots, margins}, {560, 300}, Qt::Vertical);
}

void MainWindow::setSession(SessionPort* session) {
  if (session_) kept_selection_.keep(*selection_, session_->outline());
  session_ = session;
  selection_->clear();
  snapshot_ = {};
  samples_.clear();
  static const view::SceneOutline kNothing;
  const view::SceneOutline& outline = session_ ? session_->outline() : kNothing;
  if (session_) session_->takeSnapshot(snapshot_);

  history_->open(outline);
  axis_->open(outline.start, outline.end, outline.frame_period);
  axis_->setRange(document_->work().range);
  follower_.attach(session_, snapshot_, document_->work());
  review_->open(session_ ? session_->analysis() : nullptr, outline, follower_.margins(document_->work()));
  tree_model_->open(outline);
  pairs_->open(outline);
  margins_->open(outline, follower_.margins(document_->work()));
  margin_commands_->open(session_ ? &outline : nullptr);
  robots_->open(outline);
  loops_ = snapshot_.loops;
  docks_[outline.reacting.empty() ? 4 : 5]->raise();
  timeline_->strip()->setSeries(&history_->distance(), &history_->force(), outline.start, outline.end);
  // What robots that react do differs from what was recorded.
  whole_plot_ = review_->available() && outline.reacting.empty() && !outline.falls;
  plots_->setDistanceName(whole_plot_ ? tr("Smallest clearance person – robot") : tr("Smallest distance"));
  plots_->setSeries(whole_plot_ ? &review_->nearest() : &history_->distance(), &history_->force(),
                    &history_->torques(), outline.start, outline.end);
  plots_->setJoints(outline.joints);
  groups_->open(outline);
  static const std::vector<scene::SceneNote> kNoNotes;
  notes_->open(session_ ? session_->notes() : kNoNotes);
  docks_[7]->setWindowTitle(notes_->title());
  recordings_->open(outline.recordings);
  playback_->setPort(session_);
  if (session_) playback_->onSnapshot(snapshot_);
  status_->clear();
  for (const auto& entry : actions_->all())
    if (entry.group == ActionGroup::kPlayback) entry.action->setEnabled(session_ != nullptr);
  const bool can = outline.cannot_react.empty();
  (*actions_)[Id::kReact]->setEnabled(can && (outline.falls || !outline.reacting.empty()));
  (*actions_)[Id::kRecordingOptions]->setEnabled(session_ != nullptr);
  (*actions_)[Id::kResetStops]->setEnabled(can && !outline.reacting.empty());
  (*actions_)[Id::kReactionTorques]->setEnabled(can && !outline.reacting.empty());
  if (session_ && !(*actions_)[Id::kReact]->isChecked()) session_->setReact(false);
  if (session_ && !(*actions_)[Id::kReactionTorques]->isChecked()) session_->setTorques(false);

  if (session_) {
    viewport_->open(outline, snapshot_, session_->meshes());
    attachDocument();
    news_ = true;
    showMoment();
    refreshSlow();
    pull_timer_->start();
    slow_timer_->start();
  } else {
    pull_timer_->stop();
    slow_timer_->stop();
    viewport_->close();
    showStart();
  }
  showTitle();
}

void MainWindow::pull() {
  if (!session_) return;
  samples_.clear();
  session_->drainPlot(samples_);
  history_->add(samples_);
  if (!session_->takeSnapshot(snapshot_)) return;
  history_->add(snapshot_);
  news_ = true;
  playback_->onSnapshot(snapshot_);
  showMoment();
}

void MainWindow::showMoment() {
  if (!session_) return;
  const view::SceneOutline& outline = session_->outline();
  viewport_->refresh(snapshot_);
  pairs_->refresh(snapshot_);
  tree_model_->refresh(outline, snapshot_);
  status_->refresh(outline, snapshot_);
  timeline_->refresh(snapshot_);
  if (robots_->isVisible()) robots_->refresh(outline, snapshot_);
  if (groups_->isVisible()) groups_->refresh(snapshot_);
  view::PlotSample sample = momentSample(snapshot_, plots_->joint());
  if (whole_plot_) sample.min_distance = nearestPersonRobot(outline, snapshot_);
  plots_->setMoment(snapshot_.step, sample);
  plots_->refresh();
  if (std::exchange(loops_, snapshot_.loops) != snapshot_.loops && !snapshot_.robots.empty())
    statusBar()->showMessage(
        tr("Robots were restarted on their planned motion at %1").arg(secondsWithUnit(snapshot_.loop_start)),
        kMessageMs);
  Q_EMIT momentShown();
}

void MainWindow::refreshSlow() {
  if (!session_) return;
  review_->pull();
  if (std::exchange(news_, false)) {
    pairs_->sortAgain();
    status_->refreshFigures(snapshot_);
    if (whole_plot_) plots_->setMargin(review_->commonMargin().value_or(0.0));
    const auto nearest = static_cast<std::size_t>(snapshot_.nearest_pair);
    if (!whole_plot_)
      plots_->setMargin(snapshot_.nearest_pair >= 0 && nearest < snapshot_.pairs.size()
                            ? snapshot_.pairs[nearest].margin
                            : 0.0);
  }
  timeline_->strip()->refresh();
  plots_->refresh();
}

std::vector<std::pair<const char*, long>> MainWindow::shownSteps() const {
  return {{"3D view", viewport_->shownStep()},
          {"scene tree", tree_model_->shownStep()},
          {"pairs", pairs_->shownStep()},
          {"plots", plots_->shownStep()},
          {"status", status_->shownStep()}};
}

void MainWindow::showProblem(const QString& title, const QString& text) {
  auto* box = new QMessageBox(QMessageBox::Warning, title, text, QMessageBox::Close, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextFormat(Qt::PlainText);
  box->setTextInteractionFlags(Qt::TextSelectableByMouse);
  box->open();
}

void MainWindow::showOpening(const Opening& opening) {
  status_->showOpening(opening);
  if (!session_) viewport_->setMessage(tr("Opening…"));
}

void MainWindow::hideOpening() {
  status_->hideOpening();
  if (!session_) showStart();
}

void MainWindow::showStart() {
  viewport_->setMessage(
      tr("Open a project or a scene (Ctrl+O),\nor drop a project, a scene, a robot or a recording here"));
}

void MainWindow::restore() {
  QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
  restoreState(settings.value(QStringLiteral("window/state")).toByteArray(), kLayoutVersion);
  for (const auto& [id, key] : kRemembered) {
    QAction* action = (*actions_)[id];
    action->setChecked(settings.value(QString::fromLatin1(key), action->isChecked()).toBool());
  }
  opacity_->setValue(settings.value(QStringLiteral("view/opacity"), opacity_->value()).toInt());
  applyOptions();
  showRecent();
}

void MainWindow::save() const {
  QSettings settings;
  settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
  settings.setValue(QStringLiteral("window/state"), saveState(kLayoutVersion));
  settings.setValue(QStringLiteral("window/dark"), (*actions_)[Id::kDarkTheme]->isChecked());
  for (const auto& [id, key] : kRemembered)
    settings.setValue(QString::fromLatin1(key), (*actions_)[id]->isChecked());
  settings.setValue(QStringLiteral("view/opacity"), opacity_->value());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!projects_->mayDiscard()) {
    event->ignore();
    return;
  }
  if (autosave_) autosave_->finish();
  save();
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  for (const QUrl& url : event->mimeData()->urls())
    if (kindOf(url.toLocalFile()) != FileKind::kUnknown) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  // A scene before the recordings that shall run in it.
  QStringList paths;
  for (const FileKind kind : {FileKind::kProject, FileKind::kScene, FileKind::kRecording})
    for (const QUrl& url : event->mimeData()->urls())
      if (kindOf(url.toLocalFile()) == kind) paths << url.toLocalFile();
  // Later: whoever drops them waits for this event, and a question may take long.
  QTimer::singleShot(0, this, [this, paths] { openFiles(paths); });
}

}  // namespace abstand::ui
