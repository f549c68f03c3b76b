// How the window edits its document: commands and panels.
#include <QAbstractButton>
#include <QDockWidget>
#include <QLineEdit>
#include <QSlider>
#include <QStatusBar>

#include "ui/bookmark_commands.hpp"
#include "ui/dock_set.hpp"
#include "ui/document/document.hpp"
#include "ui/main_window.hpp"
#include "ui/margin_commands.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recent_files.hpp"
#include "ui/model/scene_tree_model.hpp"
#include "ui/panels/bookmark_panel.hpp"
#include "ui/panels/compare_lanes.hpp"
#include "ui/panels/event_panel.hpp"
#include "ui/panels/group_panel.hpp"
#include "ui/panels/margin_curve.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_tools.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/project_commands.hpp"
#include "ui/reading_dialog.hpp"
#include "ui/report_commands.hpp"
#include "ui/style/actions.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

namespace {
constexpr int kNoticeMs = 4000;
}

QString MainWindow::nameOf(int object) const {
  return QString::fromStdString(session_->outline().objects[static_cast<std::size_t>(object)].name);
}

void MainWindow::connectDocument() {
  connectUndo();
  connectProjects();
  connectBookmarks();
  connectEdits();
  connectGroups();
  connectInspector();
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
    if (session_) document_->setViewpoint({viewport_->cameraView(), playback_->time()});
  });

  connect(panels_.status->cancelButton(), &QAbstractButton::clicked, this, &MainWindow::cancelRequested);
  connect((*actions_)[ActionId::kNew], &QAction::triggered, this, [this] {
    if (projects_->mayDiscard()) Q_EMIT closeRequested();
  });
  connect((*actions_)[ActionId::kReload], &QAction::triggered, this, &MainWindow::reloadRequested);
  connect((*actions_)[ActionId::kRecordingOptions], &QAction::triggered, this, [this] {
    if (const auto reading = askReading(document_->work().reading, this))
      document_->edit(tr("recording options"), [&](Work& work) { work.reading = *reading; });
  });
  connect(opacity_, &QSlider::sliderReleased, document_, &Document::endStep);
  connect((*actions_)[ActionId::kSave], &QAction::triggered, projects_, &ProjectCommands::save);
  connect((*actions_)[ActionId::kSaveAs], &QAction::triggered, projects_, &ProjectCommands::saveAs);
  connect(projects_, &ProjectCommands::aboutToSave, this, [this] {
    if (session_) document_->setViewpoint({document_->viewpoint().camera, playback_->time()});
  });
  connect(projects_, &ProjectCommands::openWanted, this, &MainWindow::openProjectRequested);
  connect(projects_, &ProjectCommands::failed, this, &MainWindow::showProblem);
  connect(projects_, &ProjectCommands::saved, this, [this](const QString& file) {
    rememberFile(file);
    showRecent();
    statusBar()->showMessage(tr("Saved %1").arg(file), kNoticeMs);
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
  connect(bookmarks, &BookmarkCommands::said, this,
          [this](const QString& text) { statusBar()->showMessage(text, kNoticeMs); });
}

void MainWindow::connectEdits() {
  connect(tree_model_, &SceneTreeModel::visibilityEdited, this,
          [this](const std::vector<int>& objects, bool visible) {
            const QString what = objects.size() == 1
                                     ? nameOf(objects.front())
                                     : tr("%n objects", nullptr, static_cast<int>(objects.size()));
            document_->edit(visible ? tr("show %1").arg(what) : tr("hide %1").arg(what), [&](Work& work) {
              for (const int object : objects)
                if (visible)
                  work.hidden.remove(nameOf(object));
                else
                  work.hidden.insert(nameOf(object));
            });
          });
  margin_commands_ = new MarginCommands(*document_, follower_, *review_, *panels_.margins, *actions_, this);
  connect(margin_commands_, &MarginCommands::failed, this, &MainWindow::showProblem);
  connect(margin_commands_, &MarginCommands::said, this,
          [this](const QString& text) { statusBar()->showMessage(text, kNoticeMs); });
  connect(margin_commands_, &MarginCommands::picked, panels_.events, &EventPanel::picked);
  connect(margin_commands_, &MarginCommands::compared, panels_.timeline->compareLanes(),
          &CompareLanes::setCompared);
  connect(panels_.timeline->compareLanes(), &CompareLanes::closeWanted, this,
          [this] { margin_commands_->compare(false); });
  connect(panels_.curve, &MarginCurve::dragged, panels_.margins, &MarginPanel::hold);
  connect(panels_.curve, &MarginCurve::released, panels_.margins, &MarginPanel::release);
  connect((*actions_)[ActionId::kReport], &QAction::triggered, this, [this] {
    const std::string margins = margin_commands_->presentSet();
    if (!margins.empty()) outputs_.reports->ask(margins, document_->work().scene);
  });
  connect(outputs_.reports, &ReportCommands::failed, this, &MainWindow::showProblem);
  connect((*actions_)[ActionId::kFindMargin], &QAction::triggered, this, [this] {
    DockSet::raise(docks_->margins);
    panels_.margin_tools->search()->setFocus(Qt::ShortcutFocusReason);
  });
}

void MainWindow::connectGroups() {
  const auto group_name = [this](int group) {
    return QString::fromStdString(session_->outline().pair_groups[static_cast<std::size_t>(group)]);
  };
  const auto pair_name = [this](int pair) {
    const auto [a, b] = session_->outline().pairs[static_cast<std::size_t>(pair)];
    return QPair<QString, QString>(nameOf(a), nameOf(b));
  };
  connect(panels_.groups, &GroupPanel::stateWanted, this, [=, this](int group, view::PairGroupState state) {
    const QString what = state == view::PairGroupState::kRunning  ? tr("run pair group %1")
                         : state == view::PairGroupState::kPaused ? tr("pause pair group %1")
                                                                  : tr("stop pair group %1");
    document_->edit(what.arg(group_name(group)), [&](Work& work) {
      if (state == view::PairGroupState::kRunning)
        work.groups.remove(group_name(group));
      else
        work.groups[group_name(group)] = state;
    });
  });
  const auto move = [=, this](int pair, const QString& group) {
    const auto names = pair_name(pair);
    const QString what = group.isEmpty() ? tr("remove %1 – %2 from its group") : tr("add %1 – %2 to a group");
    document_->edit(what.arg(names.first, names.second), [&](Work& work) { work.moved[names] = group; });
  };
  connect(panels_.groups, &GroupPanel::addWanted, this,
          [=](int group, int pair) { move(pair, group_name(group)); });
  connect(panels_.groups, &GroupPanel::removeWanted, this, [=](int pair) { move(pair, QString()); });
}

}  // namespace abstand::ui
