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
#include <QTimer>

#include "ui/dock_set.hpp"
#include "ui/document/autosave.hpp"
#include "ui/document/document.hpp"
#include "ui/document/left_overs.hpp"
#include "ui/language_commands.hpp"
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
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/margin_curve.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_tools.hpp"
#include "ui/panels/note_panel.hpp"
#include "ui/panels/pair_matrix.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/recording_panel.hpp"
#include "ui/panels/robot_panel.hpp"
#include "ui/panels/scene_tree_panel.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/panels/time_strip.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/plots/cycle_panel.hpp"
#include "ui/plots/plot_panel.hpp"
#include "ui/project_commands.hpp"
#include "ui/report_commands.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/file_kinds.hpp"
#include "ui/style/format.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/kept_keys.hpp"
#include "ui/style/theme.hpp"
#include "ui/video_recorder.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

namespace {

constexpr int kSlowMs = 100;
constexpr int kMessageMs = 3000;
constexpr int kPlotWidth = 280;  // px, at least

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
  outputs_ = {new ReportCommands(this), new VideoRecorder(*playback_, *viewport_, this)};
  setCentralWidget(viewport_);
  new FocusKeys(this);
  buildPanels();
  opacity_ = buildMenus(*this, *actions_);
  connectFile();
  connectView();
  connectLanguages(*this, *actions_);
  connectPlayback();
  connectPanels();
  connectReview();
  connectVideo();
  connectDocument();
  resize(1440, 900);
  docks_->arrange();
  restore();
  loadKeys(*actions_);
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

void MainWindow::buildPanels() {
  panels_.tree = new SceneTreePanel(*tree_model_, *selection_, this);
  panels_.pairs = new PairPanel(*selection_, this);
  panels_.timeline = new TimelinePanel(*actions_, *playback_, *review_, *axis_, this);
  panels_.plots = new PlotPanel(this);
  panels_.plots->setMinimumWidth(kPlotWidth);
  panels_.margins = new MarginPanel(this);
  panels_.margin_tools = new MarginTools(panels_.margins, *actions_, this);
  panels_.robots = new RobotPanel(this);
  panels_.groups = new GroupPanel(this);
  panels_.notes = new NotePanel(this);
  panels_.events = new EventPanel(*review_, this);
  panels_.bookmarks = new BookmarkPanel(this);
  panels_.recordings = new RecordingPanel((*actions_)[Id::kRecordingOptions], this);
  panels_.curve = new MarginCurve(*review_, *selection_, this);
  panels_.cycles = new CyclePanel(this);
  panels_.inspector = new InspectorPanel(this);
  panels_.matrix = new PairMatrix(*selection_, this);
  panels_.status = new StatusPanel(statusBar());
  docks_ = std::make_unique<DockSet>(*this, *actions_, panels_);
  // What was hidden may show an older moment.
  for (QDockWidget* dock : docks_->all())
    connect(dock, &QDockWidget::visibilityChanged, this, [this](bool visible) {
      if (visible) showMoment();
    });
}

void MainWindow::setSession(SessionPort* session) {
  outputs_.videos->cancel();
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
  panels_.pairs->open(outline);
  panels_.margins->open(outline, follower_.margins(document_->work()));
  margin_commands_->open(session_ ? &outline : nullptr);
  panels_.robots->open(outline);
  shown_.loops = snapshot_.loops;
  (outline.reacting.empty() ? docks_->margins : docks_->robots)->raise();
  panels_.timeline->strip()->setSeries(&history_->distance(), &history_->force(), outline.start, outline.end);
  // What robots that react do differs from what was recorded.
  shown_.whole_plot = review_->available() && outline.reacting.empty() && !outline.falls;
  panels_.plots->setDistanceName(shown_.whole_plot ? tr("Clearance person – robot")
                                                   : tr("Smallest distance"));
  panels_.plots->setSeries(shown_.whole_plot ? &review_->nearest() : &history_->distance(),
                           &history_->force(), &history_->torques(), outline.start, outline.end);
  panels_.plots->setJoints(outline.joints);
  panels_.groups->open(outline);
  static const std::vector<scene::SceneNote> kNoNotes;
  panels_.notes->open(session_ ? session_->notes() : kNoNotes);
  docks_->notes->setWindowTitle(panels_.notes->title());
  panels_.recordings->open(outline.recordings);
  panels_.cycles->open(outline);
  panels_.inspector->open(outline);
  panels_.matrix->open(outline);
  panels_.inspector->setWork(document_->work());
  playback_->setPort(session_);
  if (session_) playback_->onSnapshot(snapshot_);
  panels_.status->clear();
  for (const auto& entry : actions_->all())
    if (entry.group == ActionGroup::kPlayback) entry.action->setEnabled(session_ != nullptr);
  const bool can = outline.cannot_react.empty();
  (*actions_)[Id::kReact]->setEnabled(can && (outline.falls || !outline.reacting.empty()));
  for (const Id id : {Id::kRecordingOptions, Id::kReload, Id::kReport, Id::kSavePlots})
    (*actions_)[id]->setEnabled(session_ != nullptr);
  (*actions_)[Id::kVideo]->setEnabled(session_ != nullptr && outputs_.videos->canRecord());
  (*actions_)[Id::kResetStops]->setEnabled(can && !outline.reacting.empty());
  (*actions_)[Id::kReactionTorques]->setEnabled(can && !outline.reacting.empty());
  if (session_ && !(*actions_)[Id::kReact]->isChecked()) session_->setReact(false);
  if (session_ && !(*actions_)[Id::kReactionTorques]->isChecked()) session_->setTorques(false);

  if (session_) {
    viewport_->open(outline, snapshot_, session_->meshes());
    attachDocument();
    shown_.is_stale = true;
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
  panels_.cycles->add(samples_);
  if (!session_->takeSnapshot(snapshot_)) return;
  history_->add(snapshot_);
  shown_.is_stale = true;
  playback_->onSnapshot(snapshot_);
  showMoment();
}

void MainWindow::showMoment() {
  if (!session_) return;
  const view::SceneOutline& outline = session_->outline();
  viewport_->refresh(snapshot_);
  panels_.pairs->refresh(snapshot_);
  tree_model_->refresh(outline, snapshot_);
  panels_.status->refresh(outline, snapshot_);
  panels_.timeline->refresh(snapshot_);
  if (panels_.robots->isVisible()) panels_.robots->refresh(outline, snapshot_);
  if (panels_.groups->isVisible()) panels_.groups->refresh(snapshot_);
  panels_.inspector->refresh(snapshot_);
  panels_.matrix->refresh(snapshot_);
  view::PlotSample sample = momentSample(snapshot_, panels_.plots->joint());
  if (shown_.whole_plot) sample.min_distance = nearestPersonRobot(outline, snapshot_);
  panels_.plots->setMoment(snapshot_.step, sample);
  panels_.plots->refresh();
  if (std::exchange(shown_.loops, snapshot_.loops) != snapshot_.loops && !snapshot_.robots.empty())
    statusBar()->showMessage(
        tr("Robots were restarted on their planned motion at %1").arg(secondsWithUnit(snapshot_.loop_start)),
        kMessageMs);
  outputs_.videos->onMoment(snapshot_.t);
  Q_EMIT momentShown();
}

void MainWindow::refreshSlow() {
  if (!session_) return;
  review_->pull();
  if (std::exchange(shown_.is_stale, false)) {
    panels_.pairs->sortAgain();
    panels_.status->refreshFigures(snapshot_);
    if (shown_.whole_plot) panels_.plots->setMargin(review_->commonMargin().value_or(0.0));
    const auto nearest = static_cast<std::size_t>(snapshot_.nearest_pair);
    if (!shown_.whole_plot)
      panels_.plots->setMargin(snapshot_.nearest_pair >= 0 && nearest < snapshot_.pairs.size()
                                   ? snapshot_.pairs[nearest].margin
                                   : 0.0);
  }
  panels_.timeline->strip()->refresh();
  panels_.plots->refresh();
  if (panels_.cycles->isVisible()) panels_.cycles->refresh();
}

std::vector<std::pair<const char*, long>> MainWindow::shownSteps() const {
  return {{"3D view", viewport_->shownStep()},
          {"scene tree", tree_model_->shownStep()},
          {"pairs", panels_.pairs->shownStep()},
          {"plots", panels_.plots->shownStep()},
          {"status", panels_.status->shownStep()}};
}

void MainWindow::showProblem(const QString& title, const QString& text) {
  auto* box = new QMessageBox(QMessageBox::Warning, title, text, QMessageBox::Close, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextFormat(Qt::PlainText);
  box->setTextInteractionFlags(Qt::TextSelectableByMouse);
  box->open();
}

void MainWindow::showOpening(const Opening& opening) {
  panels_.status->showOpening(opening);
  if (!session_) viewport_->setMessage(tr("Opening…"));
}

void MainWindow::hideOpening() {
  panels_.status->hideOpening();
  if (!session_) showStart();
}

void MainWindow::showStart() {
  viewport_->setMessage(
      tr("Open a project or a scene (Ctrl+O),\nor drop a project, a scene, a robot or a recording here"));
}

void MainWindow::restore() {
  QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
  restoreState(settings.value(QStringLiteral("window/state")).toByteArray(), DockSet::kLayoutVersion);
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
  settings.setValue(QStringLiteral("window/state"), saveState(DockSet::kLayoutVersion));
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
  if (kept_.autosave) kept_.autosave->finish();
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
  for (const FileKind kind : {FileKind::kProject, FileKind::kScene, FileKind::kRecording, FileKind::kMargins})
    for (const QUrl& url : event->mimeData()->urls())
      if (kindOf(url.toLocalFile()) == kind) paths << url.toLocalFile();
  // Later: whoever drops them waits for this event, and a question may take long.
  QTimer::singleShot(0, this, [this, paths] { openFiles(paths); });
}

}  // namespace abstand::ui
