// Menus and toolbar from the table of actions.
#include "ui/menus.hpp"

#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSlider>
#include <QToolBar>

#include "ui/style/actions.hpp"

namespace abstand::ui {

namespace {

using Id = ActionId;

/// The actions of a group from `first` to `last` in the table, as they come.
void addRange(QWidget* menu, const Actions& actions, Id first, Id last) {
  bool inside = false;
  for (const auto& entry : actions.all()) {
    inside |= entry.action == actions[first];
    if (inside) menu->addAction(entry.action);
    if (entry.action == actions[last]) return;
  }
}

QMenu* addGroup(QWidget* parent, const Actions& actions, ActionGroup group) {
  auto* menu = new QMenu(Actions::groupName(group), parent);
  for (const auto& entry : actions.all())
    if (entry.group == group) menu->addAction(entry.action);
  return menu;
}

}  // namespace

QSlider* buildMenus(QMainWindow& window, const Actions& actions) {
  QMenuBar* bar = window.menuBar();
  QMenu* file = bar->addMenu(Actions::groupName(ActionGroup::kFile));
  addRange(file, actions, Id::kNew, Id::kReload);
  QMenu* recent = file->addMenu(Actions::tr("Open re&cent"));
  addRange(recent, actions, Id::kRecent1, Id::kRecent5);
  file->addSeparator();
  addRange(file, actions, Id::kConnect, Id::kSaveMoments);
  file->addSeparator();
  addRange(file, actions, Id::kSave, Id::kSaveAs);
  file->addSeparator();
  addRange(file, actions, Id::kReport, Id::kCopyPicture);
  file->addSeparator();
  file->addAction(actions[Id::kQuit]);

  bar->addMenu(addGroup(bar, actions, ActionGroup::kEdit));

  QMenu* view = bar->addMenu(Actions::groupName(ActionGroup::kView));
  addRange(view, actions, Id::kForces, Id::kCalibrate);
  view->addSeparator();
  view->addMenu(addGroup(view, actions, ActionGroup::kCamera));
  view->addMenu(addGroup(view, actions, ActionGroup::kPanels));
  view->addSeparator();
  addRange(view, actions, Id::kFollowPlots, Id::kClearSelection);
  view->addSeparator();
  addRange(view, actions, Id::kDarkTheme, Id::kLayoutReview);
  QMenu* language = view->addMenu(Actions::tr("Lan&guage"));
  addRange(language, actions, Id::kLanguageSystem, Id::kLanguageGerman);

  bar->addMenu(addGroup(bar, actions, ActionGroup::kMargins));
  QMenu* playback = addGroup(bar, actions, ActionGroup::kPlayback);
  auto* kinds = new QMenu(Actions::tr("Event of a &kind"), playback);
  addRange(kinds, actions, Id::kNextTouch, Id::kPreviousLoss);
  for (QAction* action : kinds->actions()) playback->removeAction(action);
  playback->insertMenu(actions[Id::kPauseOnEvent], kinds);
  bar->addMenu(playback);
  bar->addMenu(addGroup(bar, actions, ActionGroup::kHelp));
  // Shortcuts work wherever the keys go, also while the menu bar is hidden.
  for (const auto& entry : actions.all()) window.addAction(entry.action);

  QToolBar* tools = window.addToolBar(Actions::tr("Tools"));
  tools->setObjectName(QStringLiteral("tools"));
  tools->setMovable(false);
  tools->setIconSize(QSize(20, 20));
  tools->toggleViewAction()->setVisible(false);
  for (const Id id : {Id::kOpenScene, Id::kOpenRecording, Id::kScreenshot}) tools->addAction(actions[id]);
  tools->addSeparator();
  for (const Id id :
       {Id::kForces, Id::kTorques, Id::kVelocities, Id::kClosest, Id::kLabels, Id::kFloor, Id::kShadows})
    tools->addAction(actions[id]);
  tools->addSeparator();
  tools->addAction(actions[Id::kTransparent]);
  auto* opacity = new QSlider(Qt::Horizontal, tools);
  opacity->setRange(10, 100);
  opacity->setValue(70);
  opacity->setPageStep(10);
  opacity->setFixedWidth(96);
  opacity->setAccessibleName(Actions::tr("Opacity of people"));
  opacity->setToolTip(Actions::tr("How solid people are drawn"));
  tools->addWidget(opacity);
  tools->addSeparator();
  tools->addAction(actions[Id::kReact]);
  tools->addSeparator();
  for (const Id id : {Id::kIso, Id::kFront, Id::kSide, Id::kTop, Id::kFit}) tools->addAction(actions[id]);
  auto* space = new QWidget(tools);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  tools->addWidget(space);
  for (const Id id : {Id::kDarkTheme, Id::kShortcuts}) tools->addAction(actions[id]);
  return opacity;
}

}  // namespace abstand::ui
