// How the inspector and the pair matrix follow the selection and edit the document.
#include <QDockWidget>
#include <QStatusBar>
#include <algorithm>

#include "ui/dock_set.hpp"
#include "ui/document/document.hpp"
#include "ui/main_window.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/joint_editor.hpp"
#include "ui/panels/pair_matrix.hpp"
#include "ui/panels/person_editor.hpp"
#include "ui/panels/robot_panel.hpp"

namespace abstand::ui {

void MainWindow::connectInspector() {
  InspectorPanel* panel = panels_.inspector;
  connect(selection_, &Selection::changed, this, [this, panel] {
    panel->setSubject(selection_->objects(), selection_->pair());
    panel->refresh(snapshot_);
  });
  connect(docks_->inspector, &QDockWidget::visibilityChanged, this, [this, panel](bool visible) {
    panel->setInFront(visible);
    panel->refresh(snapshot_);
  });
  connect(panel->joints(), &JointEditor::edited, this, &MainWindow::poseJoint);
  connect(panel->joints(), &JointEditor::released, document_, &Document::endStep);
  connect(panel->joints(), &JointEditor::followWanted, this, [this](int robot) {
    const QString name =
        QString::fromStdString(session_->outline().robots[static_cast<std::size_t>(robot)].name);
    document_->edit(tr("let %1 follow its motion").arg(name), [&](Work& work) { work.posed.remove(name); });
  });
  connect(panel->person(), &PersonEditor::wanted, this, &MainWindow::personRequested);

  connect(panels_.robots, &RobotPanel::pairPicked, this, [this](int pair) {
    const auto [a, b] = session_->outline().pairs[static_cast<std::size_t>(pair)];
    selection_->setPair(pair, a, b);
  });
  connect(docks_->matrix, &QDockWidget::visibilityChanged, this, [this](bool visible) {
    panels_.matrix->setInFront(visible);
    panels_.matrix->refresh(snapshot_);
  });
  connect(panels_.matrix, &PairMatrix::checkWanted, this, &MainWindow::checkPair);
}

/// A pair of the scene leaves its group or comes back; one that the scene leaves out is added, which opens
/// the scene anew.
void MainWindow::checkPair(int a, int b, bool checked) {
  const QPair<QString, QString> names(nameOf(a), nameOf(b));
  const auto& pairs = session_->outline().pairs;
  const auto at = std::find(pairs.begin(), pairs.end(), std::make_pair(a, b));
  const bool is_added = document_->work().added.contains(names);
  if (at != pairs.end() && !is_added && checked && !document_->work().moved.contains(names)) {
    statusBar()->showMessage(tr("The group of this pair does not run: see the panel Groups"), 4000);
    return;
  }
  const QString text = checked ? tr("check %1 – %2") : tr("do not check %1 – %2");
  document_->edit(text.arg(names.first, names.second), [&](Work& work) {
    if (at == pairs.end())
      work.added.insert(names);
    else if (is_added)
      work.added.remove(names);
    else if (checked)
      work.moved.remove(names);
    else
      work.moved[names] = QString();
  });
}

/// The other joints stay where they are shown.
void MainWindow::poseJoint(int robot, int joint, double value) {
  const view::RobotCard& card = session_->outline().robots[static_cast<std::size_t>(robot)];
  const QString name = QString::fromStdString(card.name);
  QVector<double> joints = follower_.posed(document_->work(), robot);
  if (joints.isEmpty())
    for (int k = 0; k < card.joints; ++k)
      joints.push_back(snapshot_.joint_positions[static_cast<std::size_t>(card.first_joint + k)]);
  joints[joint] = value;
  document_->edit(
      tr("pose %1 by hand").arg(name), [&](Work& work) { work.posed[name] = joints; },
      QStringLiteral("pose/%1/%2").arg(name).arg(joint));
}

}  // namespace abstand::ui
