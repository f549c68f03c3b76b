// How the window follows its document.
#include <QFileInfo>
#include <QSlider>

#include "ui/dock_set.hpp"
#include "ui/document/autosave.hpp"
#include "ui/document/document.hpp"
#include "ui/document/left_overs.hpp"
#include "ui/main_window.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/scene_tree_model.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/time_axis.hpp"
#include "ui/moment_feed.hpp"
#include "ui/panels/bookmark_panel.hpp"
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/reaction_panel.hpp"
#include "ui/panels/recording_panel.hpp"
#include "ui/panels/separation_panel.hpp"
#include "ui/panels/time_strip.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/project_commands.hpp"
#include "ui/recovery.hpp"
#include "ui/style/actions.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

namespace {

constexpr int kNamesInMessage = 10;

/// The switches of the view menu.
struct ViewSwitch {
  ActionId id;
  bool ViewOptions::*member;
};
constexpr ViewSwitch kViewSwitches[] = {{ActionId::kForces, &ViewOptions::forces},
                                        {ActionId::kTorques, &ViewOptions::torques},
                                        {ActionId::kJointTorques, &ViewOptions::joint_torques},
                                        {ActionId::kVelocities, &ViewOptions::velocities},
                                        {ActionId::kClosest, &ViewOptions::closest},
                                        {ActionId::kLabels, &ViewOptions::labels},
                                        {ActionId::kFloor, &ViewOptions::floor},
                                        {ActionId::kShadows, &ViewOptions::shadows},
                                        {ActionId::kAutoScale, &ViewOptions::auto_scale},
                                        {ActionId::kTransparent, &ViewOptions::transparent}};

}  // namespace

QString MainWindow::nameOf(int object) const {
  return QString::fromStdString(session_->outline().objects[static_cast<std::size_t>(object)].name);
}

void MainWindow::followWork(const Work& before, const Work& after) {
  follower_.follow(before, after);
  if (session_ && (before.margins != after.margins || before.classes != after.classes)) {
    panels_.margins->show(follower_.margins(after));
    const std::vector<double> margins = follower_.reviewMargins(after);
    for (std::size_t i = 0; i < margins.size(); ++i) review_->setMargin(static_cast<int>(i), margins[i]);
  }
  if (!(before.separation == after.separation)) {
    panels_.separation->setSettings(after.separation);
    panels_.separation->refresh(feed_->moment());
  }
  if (!(before.what_if == after.what_if)) review_->setSettings(after.what_if);
  if (before.range != after.range) axis_->setRange(after.range);
  if (before.bookmarks != after.bookmarks) showBookmarks();
  if (before.hidden != after.hidden) showHidden(before.hidden, after.hidden);
  if (before.view != after.view) showView();
  if (before.posed != after.posed || before.people != after.people || before.placed != after.placed ||
      before.things != after.things)
    panels_.inspector->setWork(after);
  if (before.reactions != after.reactions) panels_.reactions->setReactions(after.reactions);
  if (before.recordings != after.recordings || before.recording != after.recording)
    panels_.recordings->showChoice(after.recordings, after.recording);
  if (before.posed.keys() != after.posed.keys()) showTitle();
}

void MainWindow::showBookmarks() {
  const QVector<Bookmark>& bookmarks = document_->work().bookmarks;
  panels_.bookmarks->show(bookmarks);
  std::vector<double> times;
  for (const Bookmark& bookmark : bookmarks) times.push_back(bookmark.t);
  panels_.timeline->strip()->setBookmarks(std::move(times));
}

void MainWindow::showHidden(const QSet<QString>& before, const QSet<QString>& after) {
  if (!session_) return;
  for (int i = 0; i < static_cast<int>(session_->outline().objects.size()); ++i)
    if (before.contains(nameOf(i)) != after.contains(nameOf(i)))
      tree_model_->setVisible(i, !after.contains(nameOf(i)));
}

/// The switches, and with them the viewport, as the document has them.
void MainWindow::showView() {
  const ViewOptions view = document_->work().view;
  for (const ViewSwitch& each : kViewSwitches) {
    const QSignalBlocker quiet((*actions_)[each.id]);
    (*actions_)[each.id]->setChecked(view.*each.member);
  }
  const QSignalBlocker quiet(opacity_);
  opacity_->setValue(static_cast<int>(std::lround(100.0 * view.human_opacity)));
  opacity_->setEnabled(view.transparent);
  viewport_->setOptions(view);
}

/// What the user has switched becomes an edit.
void MainWindow::applyOptions() {
  ViewOptions view = document_->work().view;
  QString text = tr("opacity of people");
  for (const ViewSwitch& each : kViewSwitches) {
    const bool on = (*actions_)[each.id]->isChecked();
    if (view.*each.member == on) continue;
    const QString what = (*actions_)[each.id]->text().remove(QLatin1Char('&'));
    text = on ? tr("view: %1 on").arg(what) : tr("view: %1 off").arg(what);
    view.*each.member = on;
  }
  view.human_opacity = opacity_->value() / 100.0;
  document_->edit(
      text, [&](Work& work) { work.view = view; }, text);
  if (!opacity_->isSliderDown()) document_->endStep();
}

/// Another document is there; its session comes with setSession().
void MainWindow::showDocument() {
  kept_selection_.clear();
  fresh_document_ = true;
  showView();
  showBookmarks();
  panels_.recordings->showChoice(document_->work().recordings, document_->work().recording);
  if (!kept_.recovered) return;
  kept_.autosave->write();
  if (QFileInfo::exists(kept_.autosave->file())) kept_.recovered->remove();
  kept_.recovered.reset();
}

void MainWindow::attachDocument() {
  const Work& work = document_->work();
  showHidden({}, work.hidden);
  if (document_->viewpoint().camera) viewport_->setCameraView(*document_->viewpoint().camera);
  kept_selection_.restore(*selection_, session_->outline());
  const bool fresh = std::exchange(fresh_document_, false);
  if (fresh && !document_->viewpoint().layout.isEmpty()) docks_->restore(document_->viewpoint().layout);
  const QStringList unknown = follower_.unknownNames(work);
  if (!fresh || unknown.isEmpty()) return;
  QString names = unknown.mid(0, kNamesInMessage).join(QLatin1Char('\n'));
  if (unknown.size() > kNamesInMessage) names += QStringLiteral("\n…");
  showProblem(tr("Project"),
              tr("The project has settings for %n names that the scene does not have. They have "
                 "no effect:\n%1",
                 nullptr, unknown.size())
                  .arg(names));
}

void MainWindow::showTitle() {
  const Work& work = document_->work();
  QString name = QFileInfo(document_->file()).completeBaseName();
  if (name.isEmpty() && session_) name = QString::fromStdString(session_->outline().title);
  if (!work.recording.isEmpty()) {
    const QString recording = QFileInfo(work.recording).fileName();
    name = name.isEmpty() ? recording : tr("%1, %2").arg(name, recording);
  }
  const QStringList posed = work.posed.keys();
  if (session_ && !posed.isEmpty())
    name = tr("%1, %2 posed by hand").arg(name, posed.join(QStringLiteral(", ")));
  setWindowTitle(name.isEmpty() ? tr("Abstand") : tr("%1[*] – Abstand").arg(name));
  setWindowModified(document_->modified() && !name.isEmpty());
}

void MainWindow::keepAutosaves(const QString& folder) {
  kept_.autosave = new Autosave(*document_, folder, this);
  connect(kept_.autosave, &Autosave::aboutToWrite, commands_.projects, &ProjectCommands::aboutToSave);
  connect(kept_.autosave, &Autosave::failed, this, [this](const QString& problem) {
    showProblem(tr("Autosave"), tr("Work is not kept for the case of a crash:\n%1").arg(problem));
  });
  std::optional<LeftOver> left = offerRecovery(folder, this);
  if (!left) return;
  kept_.recovered = std::make_unique<LeftOver>(std::move(*left));
  const ProjectFile content = kept_.recovered->content;
  if (!commands_.projects->recover(content.project, content.saved_as)) kept_.recovered.reset();
}

}  // namespace abstand::ui
