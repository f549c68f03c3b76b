// The window: builds the panels and connects them.
#include "ui/main_window.hpp"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QMessageBox>
#include <QScreen>
#include <QSlider>
#include <QStatusBar>
#include <QTimer>
#include <filesystem>
#include <utility>

#include "core/base/data_folder.hpp"
#include "ui/calibration_commands.hpp"
#include "ui/camera_commands.hpp"
#include "ui/cloud_commands.hpp"
#include "ui/coverage_commands.hpp"
#include "ui/dock_set.hpp"
#include "ui/document/autosave.hpp"
#include "ui/document/document.hpp"
#include "ui/document/left_overs.hpp"
#include "ui/exchange_commands.hpp"
#include "ui/file_commands.hpp"
#include "ui/import_commands.hpp"
#include "ui/kept_settings.hpp"
#include "ui/language_commands.hpp"
#include "ui/link_drag.hpp"
#include "ui/link_poke.hpp"
#include "ui/live_camera_commands.hpp"
#include "ui/live_commands.hpp"
#include "ui/margin_commands.hpp"
#include "ui/menus.hpp"
#include "ui/model/log_book.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recent_files.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/scene_tree_model.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/time_axis.hpp"
#include "ui/moment_feed.hpp"
#include "ui/panels/bookmark_panel.hpp"
#include "ui/panels/depth_panel.hpp"
#include "ui/panels/event_panel.hpp"
#include "ui/panels/focus_keys.hpp"
#include "ui/panels/group_panel.hpp"
#include "ui/panels/history_panel.hpp"
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/log_panel.hpp"
#include "ui/panels/margin_curve.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_tools.hpp"
#include "ui/panels/note_panel.hpp"
#include "ui/panels/pair_matrix.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/reaction_panel.hpp"
#include "ui/panels/recording_panel.hpp"
#include "ui/panels/robot_panel.hpp"
#include "ui/panels/scene_tree_panel.hpp"
#include "ui/panels/separation_panel.hpp"
#include "ui/panels/start_page.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/picture_commands.hpp"
#include "ui/plots/cycle_panel.hpp"
#include "ui/plots/plot_panel.hpp"
#include "ui/project_commands.hpp"
#include "ui/report_commands.hpp"
#include "ui/scene_edits.hpp"
#include "ui/speed_commands.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/kept_keys.hpp"
#include "ui/theme_commands.hpp"
#include "ui/thing_drag.hpp"
#include "ui/time_commands.hpp"
#include "ui/verification_commands.hpp"
#include "ui/video_recorder.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

namespace {

constexpr int kNoticeMs = 4000;
constexpr int kPlotWidth = 280;                     // px, at least
const QSize kFirstSize(1440, 900), kFrame(16, 48);  // px, of a first start; of what surrounds the window
constexpr char kDemonstration[] = "scenes/hug_boxing.yaml";

using Id = ActionId;

/// The scene that the start page offers; empty: it is not installed.
QString demonstration() {
  const std::filesystem::path file = dataFolder() / kDemonstration;
  std::error_code unknown;
  return std::filesystem::exists(file, unknown) ? QString::fromStdString(file.string()) : QString();
}

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      document_{new Document(this)},
      actions_{new Actions(this)},
      playback_{new Playback(this)},
      review_{new RecordingReview(this)},
      axis_{new TimeAxis(this)},
      selection_{new Selection(this)},
      tree_model_{new SceneTreeModel(this)},
      log_{new LogBook(this)} {
  new ThemeCommands(*actions_, *tree_model_, this);
  setWindowIcon(programIcon());
  setAcceptDrops(true);
  setDockNestingEnabled(true);
  viewport_ = new Viewport(*selection_, this);
  setCentralWidget(viewport_);
  start_ = new StartPage(*actions_, demonstration(), viewport_);
  new FocusKeys(this);
  buildPanels();
  opacity_ = buildMenus(*this, *actions_);
  buildCommands();
  connectView();
  connectLanguages(*this, *actions_);
  connectTime();
  connectSession();
  connectPicks();
  connectSelection();
  connectInspector();
  connectHelp();
  connectDocument();
  resize(kFirstSize.boundedTo(screen()->availableSize() - kFrame));
  docks_->arrange();
  arrange_at_first_show_ = !restoreSettings(*this, *actions_, *opacity_);
  applyOptions();
  commands_.files->showRecent();
  loadKeys(*actions_);
  Project first;
  first.work.view = document_->work().view;
  document_->open(first, QString(), false);
  setSession(nullptr);
}

MainWindow::~MainWindow() {
  // Docks report that they are hidden, and a document that it is unchanged: to a window that is still there.
  hide();
  for (QObject* child : findChildren<QObject*>()) child->disconnect(this);
}

void MainWindow::buildPanels() {
  panels_.tree = new SceneTreePanel(*tree_model_, *selection_, this);
  panels_.pairs = new PairPanel(*selection_, this);
  panels_.timeline = new TimelinePanel(*actions_, *playback_, *review_, *axis_, this);
  panels_.plots = new PlotPanel(this);
  panels_.plots->setMinimumWidth(kPlotWidth);
  panels_.margins = new MarginPanel(this);
  panels_.margin_tools = new MarginTools(panels_.margins, *actions_, this);
  panels_.robots = new RobotPanel(this);
  panels_.reactions = new ReactionPanel(this);
  panels_.groups = new GroupPanel(this);
  panels_.notes = new NotePanel(this);
  panels_.events = new EventPanel(*review_, this);
  panels_.bookmarks = new BookmarkPanel(this);
  panels_.recordings = new RecordingPanel((*actions_)[Id::kRecordingOptions], this);
  panels_.curve = new MarginCurve(*review_, *selection_, this);
  panels_.cycles = new CyclePanel(this);
  panels_.depth = new DepthPanel((*actions_)[Id::kDepthBody], this);
  panels_.inspector = new InspectorPanel(this);
  panels_.matrix = new PairMatrix(*selection_, this);
  panels_.separation = new SeparationPanel(this);
  panels_.log = new LogPanel(*log_, this);
  panels_.history = new HistoryPanel(document_->steps(), this);
  panels_.status = new StatusPanel(statusBar());
  docks_ = std::make_unique<DockSet>(*this, *actions_, panels_);
  feed_ = new MomentFeed({panels_, *viewport_, *tree_model_, *review_, *playback_}, this);
  connect(feed_, &MomentFeed::shown, this, &MainWindow::momentShown);
  // What was hidden may show an older moment.
  for (QDockWidget* dock : docks_->all())
    connect(dock, &QDockWidget::visibilityChanged, this, [this](bool visible) {
      if (visible) feed_->show();
    });
}

void MainWindow::buildCommands() {
  commands_.projects = new ProjectCommands(*document_, this);
  commands_.files = new FileCommands(*actions_, *document_, *commands_.projects, this);
  commands_.reports = new ReportCommands(this);
  commands_.speeds = new SpeedCommands(this);
  commands_.verification = new VerificationCommands(this);
  commands_.videos = new VideoRecorder(*playback_, *viewport_, this);
  commands_.margins = new MarginCommands(*document_, follower_, *review_, *panels_.margins, *actions_, this);
  commands_.scene = new SceneEdits({*document_, follower_, *tree_model_, feed_->moment()}, panels_, this);
  commands_.exchange = new ExchangeCommands(*actions_, *selection_, *axis_, this);
  commands_.imports = new ImportCommands(*actions_, *document_, this);
  connect(commands_.imports, &ImportCommands::failed, this, &MainWindow::showProblem);
  commands_.drag =
      new LinkDrag({*document_, follower_, *selection_, *viewport_, feed_->moment()}, *actions_, this);
  commands_.things = new ThingDrag({*document_, *selection_, *viewport_, feed_->moment()}, this);
  commands_.clouds = new CloudCommands({*actions_, *panels_.depth, *viewport_, feed_->moment()}, this);
  commands_.coverage = new CoverageCommands({*document_, *viewport_, *playback_}, this);
  connect((*actions_)[Id::kPlanSensor], &QAction::triggered, commands_.coverage, &CoverageCommands::plan);
  commands_.calibration = new CalibrationCommands(this);
  connect((*actions_)[Id::kCalibrate], &QAction::triggered, commands_.calibration,
          &CalibrationCommands::open);
  connect(commands_.calibration, &CalibrationCommands::said, this, &MainWindow::say);
  connect(commands_.calibration, &CalibrationCommands::failed, this, &MainWindow::showProblem);
  commands_.live_camera = new LiveCameraCommands(this);
  connect((*actions_)[Id::kLiveCamera], &QAction::triggered, commands_.live_camera,
          &LiveCameraCommands::open);
  connect(commands_.clouds, &CloudCommands::said, this, &MainWindow::say);
  connect(feed_, &MomentFeed::shown, commands_.clouds, &CloudCommands::refresh);
  commands_.live = new LiveCommands(*actions_, panels_, this);
  connect(commands_.live, &LiveCommands::said, this, &MainWindow::say);
  connect(commands_.drag, &LinkDrag::thingWanted, commands_.things, &ThingDrag::step);
  connect(commands_.drag, &LinkDrag::said, this, &MainWindow::say);
  commands_.poke = new LinkPoke({*document_, follower_, *selection_, *viewport_, feed_->moment()},
                                (*actions_)[Id::kPoke], this);
  connect(commands_.poke, &LinkPoke::said, this, &MainWindow::say);
  connect(commands_.scene, &SceneEdits::said, this, &MainWindow::say);
  const auto* pictures =
      new PictureCommands(*actions_, {*viewport_, *panels_.plots, *commands_.videos, *axis_}, this);
  connect(pictures, &PictureCommands::said, this, &MainWindow::say);
  connect(pictures, &PictureCommands::failed, this, &MainWindow::showProblem);
  connect(commands_.files, &FileCommands::sceneWanted, this, &MainWindow::openSceneRequested);
  connect(commands_.files, &FileCommands::recordingWanted, this, &MainWindow::openRecordingRequested);
  connect(commands_.files, &FileCommands::momentsWanted, this, &MainWindow::openMomentsRequested);
  connect(commands_.files, &FileCommands::marginsWanted, commands_.margins, &MarginCommands::openFile);
  connect(commands_.files, &FileCommands::failed, this, &MainWindow::showProblem);
}

void MainWindow::setSession(SessionPort* session) {
  commands_.videos->cancel();
  commands_.speeds->close();
  if (session_) kept_selection_.keep(*selection_, session_->outline());
  commands_.live->open(nullptr);  // before others enable the actions that it took
  session_ = session;
  selection_->clear();
  feed_->attach(session_);
  static const view::SceneOutline kNothing;
  const view::SceneOutline& outline = session_ ? session_->outline() : kNothing;
  axis_->open(outline.start, outline.end, outline.frame_period);
  axis_->setRange(document_->work().range);
  follower_.attach(session_, feed_->moment(), document_->work());
  openPanels(outline);
  commands_.drag->open(session_ && !session_->live() ? session_ : nullptr);
  commands_.poke->open(session_ && !session_->live() ? session_ : nullptr);
  commands_.clouds->open(session_ ? session_->clouds() : nullptr);
  commands_.things->open(session_ && !session_->live() ? session_ : nullptr);
  playback_->setPort(session_);
  if (session_) playback_->onSnapshot(feed_->moment());
  enableActions(outline);
  commands_.live->open(session_);
  commands_.coverage->open(session_ && !session_->live());
  QStringList robots;
  for (const view::RobotCard& robot : outline.robots) robots << QString::fromStdString(robot.name);
  commands_.calibration->setRobots(robots);
  commands_.live_camera->setScene(document_->work().scene, outline);
  if (session_ && !(*actions_)[Id::kReact]->isChecked()) session_->setReact(false);
  if (session_ && !(*actions_)[Id::kReactionTorques]->isChecked()) session_->setTorques(false);
  if (session_) {
    start_->hide();
    viewport_->open(outline, feed_->moment(), session_->meshes());
    viewport_->setInsideSource([this](int object) { return session_->inside(object); });
    attachDocument();
    commands_.camera->forget();
    feed_->show();
    feed_->refreshSlow();
    timers_.pull->start();
    timers_.slow->start();
  } else {
    timers_.pull->stop();
    timers_.slow->stop();
    viewport_->close();
    showStart();
  }
  showTitle();
  if (session_)
    log_->add(LogLevel::kNote, tr("Opened %1: %2 bodies, %3 pairs")
                                   .arg(QString::fromStdString(outline.title))
                                   .arg(outline.objects.size())
                                   .arg(outline.pairs.size()));
}

void MainWindow::openPanels(const view::SceneOutline& outline) {
  const std::vector<double> margins = follower_.margins(document_->work());
  review_->setSettings(document_->work().what_if);
  review_->open(session_ ? session_->analysis() : nullptr, outline,
                follower_.reviewMargins(document_->work()));
  feed_->open(outline, margins);
  commands_.margins->open(session_ ? &outline : nullptr);
  commands_.exchange->open(session_ ? &outline : nullptr);
  commands_.scene->open(outline, session_ && session_->live());
  // What is read again finds the panels as the user has them.
  if (fresh_document_) (outline.reacting.empty() ? docks_->margins : docks_->robots)->raise();
  static const std::vector<scene::SceneNote> kNoNotes;
  panels_.notes->open(session_ ? session_->notes() : kNoNotes);
  docks_->notes->setWindowTitle(panels_.notes->title());
  panels_.recordings->showChoice(document_->work().recordings, document_->work().recording);
  panels_.timeline->setRecordings(outline.recordings);
  panels_.inspector->setWork(document_->work());
  panels_.separation->setSettings(document_->work().separation);
  panels_.reactions->setReactions(document_->work().reactions);
  panels_.reactions->open(outline);
}

/// IN and OUT stay, as far as they are still there.
void MainWindow::followSpan() {
  const view::SceneOutline& outline = session_->outline();
  axis_->open(outline.start, outline.end, outline.frame_period);
  axis_->setRange(document_->work().range);
  review_->setSpan(outline.start, outline.end);
  playback_->setSpan(outline.start, outline.end);
}

void MainWindow::enableActions(const view::SceneOutline& outline) {
  const bool open = session_ != nullptr;
  for (const auto& entry : actions_->all())
    if (entry.group == ActionGroup::kPlayback) entry.action->setEnabled(open);
  for (const Id id : {Id::kRecordingOptions, Id::kReload, Id::kReport, Id::kSavePlots, Id::kPlanSensor})
    (*actions_)[id]->setEnabled(open);
  (*actions_)[Id::kVideo]->setEnabled(open && commands_.videos->canRecord());
  const bool can = outline.cannot_react.empty();
  (*actions_)[Id::kReact]->setEnabled(can && (outline.falls || !outline.reacting.empty()));
  (*actions_)[Id::kResetStops]->setEnabled(can && !outline.reacting.empty());
  (*actions_)[Id::kReactionTorques]->setEnabled(can && !outline.reacting.empty());
}

void MainWindow::pull() {
  // From the start of this frame: after a late one, the next must not follow without events in between.
  if (timers_.pull->isActive()) timers_.pull->start();
  feed_->pull();
}

const view::SceneSnapshot& MainWindow::moment() const { return feed_->moment(); }

std::vector<std::pair<const char*, long>> MainWindow::shownSteps() const { return feed_->shownSteps(); }

void MainWindow::openFile(const QString& path) { commands_.files->open({path}); }

void MainWindow::say(const QString& text) {
  statusBar()->showMessage(text, kNoticeMs);
  log_->add(LogLevel::kNote, text);
}

/// The first layout is for the size that the window then has.
void MainWindow::setVisible(bool visible) {
  if (visible && std::exchange(arrange_at_first_show_, false)) docks_->fitSize();
  QMainWindow::setVisible(visible);
}

void MainWindow::showProblem(const QString& title, const QString& text) {
  auto* box = new QMessageBox(QMessageBox::Warning, title, text, QMessageBox::Close, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextFormat(Qt::PlainText);
  box->setTextInteractionFlags(Qt::TextSelectableByMouse);
  box->open();
  log_->add(LogLevel::kProblem, tr("%1: %2").arg(title, text));
}

void MainWindow::showOpening(const Opening& opening) {
  panels_.status->showOpening(opening);
  if (session_) return;
  start_->hide();
  viewport_->setMessage(tr("Opening…"));
}

void MainWindow::hideOpening() {
  panels_.status->hideOpening();
  if (!session_) showStart();
}

void MainWindow::showStart() {
  viewport_->setMessage(QString());
  QStringList recent;
  for (const QString& file : recentFiles())
    if (QFileInfo::exists(file)) recent << file;
  start_->open(recent);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!commands_.projects->mayDiscard()) {
    event->ignore();
    return;
  }
  if (kept_.autosave) kept_.autosave->finish();
  saveSettings(*this, *actions_, *opacity_);
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (FileCommands::canOpen(*event->mimeData())) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  commands_.files->openDropped(*event->mimeData());
}

}  // namespace abstand::ui
