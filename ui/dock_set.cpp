#include "ui/dock_set.hpp"

#include <QAction>
#include <QDataStream>
#include <QDockWidget>
#include <QLayout>
#include <QMainWindow>
#include <QTabBar>
#include <algorithm>
#include <vector>

#include "ui/panel_set.hpp"
#include "ui/panels/bookmark_panel.hpp"
#include "ui/panels/depth_panel.hpp"
#include "ui/panels/event_panel.hpp"
#include "ui/panels/group_panel.hpp"
#include "ui/panels/history_panel.hpp"
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/log_panel.hpp"
#include "ui/panels/margin_curve.hpp"
#include "ui/panels/margin_tools.hpp"
#include "ui/panels/note_panel.hpp"
#include "ui/panels/pair_matrix.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/reaction_panel.hpp"
#include "ui/panels/recording_panel.hpp"
#include "ui/panels/robot_panel.hpp"
#include "ui/panels/scene_tree_panel.hpp"
#include "ui/panels/separation_panel.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/plots/cycle_panel.hpp"
#include "ui/plots/plot_panel.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {

namespace {

// Sizes of the first layout, px.
constexpr int kLeftWidth = 284, kRightWidth = 370, kTimelineHeight = 236, kTableHeight = 110,
              kPlotHeight = 560, kMarginHeight = 300, kLowWindow = 760, kLowTimelineHeight = 216,
              kTallWindow = 900, kWideWindow = 1920;
// Shares of what a larger window has beyond the two sizes above, and where they end (px): all lanes of a
// person are visible, tables show ten rows, and curves are as wide as they can be read.
constexpr double kTimelineShare = 0.3, kTableShare = 0.15, kPlotShare = 0.15;
constexpr int kMaxTimelineGrowth = 110, kMaxTableGrowth = 170, kMaxPlotGrowth = 300;

int growth(int beyond, double share, int max) { return std::clamp(static_cast<int>(share * beyond), 0, max); }

/// Not where it is hidden or covered by another tab.
bool isInFront(const QDockWidget* dock) { return dock->isVisible() && !dock->visibleRegion().isEmpty(); }

/// QMainWindow::saveState() writes of each dock its name, flags, position and size, and then the least and
/// the largest size of its content, which restoreState() ignores. They depend on what panels show: without
/// them the same layout gives the same bytes.
void forgetLimits(QByteArray& state, const QString& dock) {
  constexpr char kDockMarker = '\xfb', kFloats = 2;
  constexpr int kBefore = 1 + 2 * sizeof(qint32), kLimits = 2 * sizeof(qint32);  // flags, position, size
  QByteArray name;
  QDataStream writer(&name, QIODevice::WriteOnly);
  writer << dock;
  const int at = state.indexOf(kDockMarker + name);
  const int flags = at + 1 + name.size();
  if (at < 0 || flags + kBefore + kLimits > state.size() || (state[flags] & kFloats)) return;
  state.replace(flags + kBefore, kLimits, QByteArray(kLimits, '\0'));
}

}  // namespace

DockSet::DockSet(QMainWindow& window, Actions& actions, const PanelSet& panels)
    : window_{&window}, actions_{&actions} {
  const auto key = [](const char* text) { return QString::fromLatin1(text); };
  scene = add("scene", tr("Scene"), tr("Show or hide the scene tree"), key("Ctrl+1"), panels.tree);
  pairs = add("pairs", tr("Pairs"), tr("Show or hide the pair table"), key("Ctrl+2"), panels.pairs);
  timeline = add("timeline", tr("Timeline"), tr("Show or hide the timeline"), key("Ctrl+3"), panels.timeline);
  plots = add("plots", tr("Plots"), tr("Show or hide the plots"), key("Ctrl+4"), panels.plots);
  margins = add("margins", tr("Margins"), tr("Show or hide the margins"), key("Ctrl+5"), panels.margin_tools);
  robots =
      add("robots", tr("Robots"), tr("Show or hide the robots that react"), key("Ctrl+6"), panels.robots);
  reactions = add("reactions", tr("Laws"), tr("Show or hide the laws of the robots that react"),
                  key("Ctrl+Alt+6"), panels.reactions);
  groups = add("groups", tr("Groups"), tr("Show or hide the groups of pairs"), key("Ctrl+7"), panels.groups);
  notes = add("notes", tr("Reservations"), tr("Show or hide what to know of the scene before believing it"),
              key("Ctrl+8"), panels.notes);
  events = add("events", tr("Events"), tr("Show or hide the events of the recording"), key("Ctrl+9"),
               panels.events);
  bookmarks = add("bookmarks", tr("Bookmarks"), tr("Show or hide the bookmarks"), key("Ctrl+Shift+9"),
                  panels.bookmarks);
  recordings = add("recordings", tr("Recording"), tr("Show or hide what was read of the recordings"),
                   key("Ctrl+Shift+8"), panels.recordings);
  curve = add("curve", tr("Margin curve"), tr("Show or hide what the margin of a body part costs"),
              key("Ctrl+Shift+5"), panels.curve);
  cycles = add("cycles", tr("Cycle times"), tr("Show or hide how long the cycles of the loop take"),
               key("Ctrl+Shift+4"), panels.cycles);
  inspector = add("inspector", tr("Inspector"), tr("Show or hide what is known of the selection"),
                  key("Ctrl+Shift+7"), panels.inspector);
  matrix = add("matrix", tr("Pair matrix"), tr("Show or hide the matrix of pairs"), key("Ctrl+Shift+6"),
               panels.matrix);
  separation = add("separation", tr("Separation"),
                   tr("Show or hide protective distances and contact limits of the body parts"),
                   key("Ctrl+Shift+3"), panels.separation);
  log = add("log", tr("Log"), tr("Show or hide the messages of the window"), key("Ctrl+Shift+2"), panels.log);
  depth = add("depth", tr("Depth image"), tr("Show or hide the depth image with the fitted body"),
              key("Ctrl+Shift+0"), panels.depth);
  history = add("history", tr("History"), tr("Show or hide the edits of the project"), key("Ctrl+Shift+1"),
                panels.history);
}

QDockWidget* DockSet::add(const char* name, const QString& title, const QString& tip, const QString& key,
                          QWidget* content) {
  auto* dock = new QDockWidget(title, window_);
  dock->setObjectName(QString::fromLatin1(name));
  dock->setWidget(content);
  auto* action = new QAction(title, window_);
  action->setObjectName(QStringLiteral("panel_") + dock->objectName());
  action->setCheckable(true);
  QObject::connect(action, &QAction::triggered, dock, [dock, action] {
    isInFront(dock) ? dock->hide() : raise(dock);
    action->setChecked(!dock->isHidden());
  });
  // As Qt's own action of the dock, which hides one that stands behind another.
  QObject::connect(dock->toggleViewAction(), &QAction::toggled, action, &QAction::setChecked);
  QObject::connect(dock, &QDockWidget::windowTitleChanged, action, &QAction::setText);
  actions_->adopt(action, ActionGroup::kPanels, tip, QKeySequence(key));
  return dock;
}

void DockSet::arrange() const {
  const QSize size = window_->size();
  for (QDockWidget* dock : all()) {
    dock->setFloating(false);
    dock->show();
  }
  window_->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  window_->setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  window_->addDockWidget(Qt::LeftDockWidgetArea, scene);
  window_->tabifyDockWidget(scene, reactions);
  scene->raise();
  window_->addDockWidget(Qt::RightDockWidgetArea, plots);
  window_->addDockWidget(Qt::RightDockWidgetArea, margins);
  window_->splitDockWidget(plots, margins, Qt::Vertical);
  window_->tabifyDockWidget(plots, inspector);
  window_->tabifyDockWidget(inspector, matrix);
  plots->raise();
  window_->tabifyDockWidget(margins, robots);
  window_->tabifyDockWidget(robots, groups);
  window_->tabifyDockWidget(groups, notes);
  margins->raise();
  window_->addDockWidget(Qt::BottomDockWidgetArea, timeline);
  window_->addDockWidget(Qt::BottomDockWidgetArea, pairs);
  window_->splitDockWidget(timeline, pairs, Qt::Vertical);
  window_->tabifyDockWidget(pairs, separation);
  window_->tabifyDockWidget(separation, events);
  window_->tabifyDockWidget(events, bookmarks);
  window_->tabifyDockWidget(bookmarks, recordings);
  window_->tabifyDockWidget(recordings, curve);
  window_->tabifyDockWidget(curve, cycles);
  window_->tabifyDockWidget(cycles, log);
  window_->tabifyDockWidget(matrix, depth);
  window_->tabifyDockWidget(depth, history);
  for (QDockWidget* dock : {cycles, log, history, depth}) dock->hide();
  // Docks that were hidden take the front from those that stay.
  for (QDockWidget* dock : {scene, pairs, plots, margins}) dock->raise();
  for (QTabBar* tabs : window_->findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
    tabs->setAccessibleName(tr("Panels"));
  window_->resizeDocks({plots, margins}, {kPlotHeight, kMarginHeight}, Qt::Vertical);
  keepSize(size);
  fitSize();
}

void DockSet::fitSize() const {
  const int taller = window_->height() - kTallWindow, wider = window_->width() - kWideWindow;
  window_->resizeDocks({scene, plots}, {kLeftWidth, kRightWidth + growth(wider, kPlotShare, kMaxPlotGrowth)},
                       Qt::Horizontal);
  window_->resizeDocks({timeline, pairs},
                       {kTimelineHeight + growth(taller, kTimelineShare, kMaxTimelineGrowth),
                        kTableHeight + growth(taller, kTableShare, kMaxTableGrowth)},
                       Qt::Vertical);
  if (window_->height() < kLowWindow) fitLowWindow();
}

void DockSet::fitLowWindow() const {
  QDockWidget* before = timeline;
  for (QDockWidget* dock : {pairs, separation, events, bookmarks, recordings, curve, cycles, log}) {
    window_->tabifyDockWidget(before, dock);
    before = dock;
  }
  // The tabs of the others fit beside each other.
  for (QDockWidget* dock : {bookmarks, curve, cycles, log}) dock->hide();
  timeline->raise();
  window_->resizeDocks({timeline}, {kLowTimelineHeight}, Qt::Vertical);
}

void DockSet::arrangeFor(Task task) const {
  const QSize size = window_->size();
  arrange();
  keepOnly(task);
  keepSize(size);
}

/// Before docks share places, the window grows to hold all of them.
void DockSet::keepSize(const QSize& size) const {
  window_->layout()->activate();
  if (!window_->isMaximized() && !window_->isFullScreen()) window_->resize(size);
}

void DockSet::keepOnly(Task task) const {
  const auto keep = [this](const std::vector<QDockWidget*>& wanted) {
    for (QDockWidget* dock : all())
      dock->setVisible(std::find(wanted.begin(), wanted.end(), dock) != wanted.end());
  };
  switch (task) {
    case Task::kReplay:
      return keep({scene, timeline, inspector});
    case Task::kTuning:
      keep({timeline, margins, plots, pairs, events, curve, separation});
      return curve->raise();
    case Task::kReview:
      keep({scene, timeline, plots, inspector, events, bookmarks, recordings, notes, separation, depth});
      notes->raise();
      return events->raise();
  }
}

QByteArray DockSet::layout() const {
  QByteArray state = window_->saveState(kLayoutVersion);
  for (const QDockWidget* dock : all()) forgetLimits(state, dock->objectName());
  return state;
}

void DockSet::restore(const QByteArray& layout) const {
  const QSize size = window_->size();
  if (window_->restoreState(layout, kLayoutVersion)) keepSize(size);
}

void DockSet::raise(QDockWidget* dock) {
  dock->show();
  dock->raise();
}

}  // namespace abstand::ui
