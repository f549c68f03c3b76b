// Edits of the document that name bodies, pairs and robots of the scene.
#include "ui/scene_edits.hpp"

#include <algorithm>

#include "core/view/snapshot.hpp"
#include "ui/document/document.hpp"
#include "ui/document/session_follower.hpp"
#include "ui/model/scene_tree_model.hpp"
#include "ui/panels/group_panel.hpp"
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/joint_editor.hpp"
#include "ui/panels/pair_matrix.hpp"
#include "ui/panels/placement_editor.hpp"
#include "ui/panels/reaction_panel.hpp"

namespace abstand::ui {

SceneEdits::SceneEdits(const Sources& sources, const PanelSet& panels, QObject* parent)
    : QObject(parent), my_{sources} {
  connect(&my_.tree, &SceneTreeModel::visibilityEdited, this, &SceneEdits::showObjects);
  connect(panels.matrix, &PairMatrix::checkWanted, this, &SceneEdits::checkPair);
  connectGroups(panels);
  connectJoints(panels);
  connectReactions(panels);
  connectPlaces(panels);
}

QString SceneEdits::nameOf(int object) const {
  return QString::fromStdString(outline_->objects[static_cast<std::size_t>(object)].name);
}

void SceneEdits::showObjects(const std::vector<int>& objects, bool visible) {
  const QString what = objects.size() == 1 ? nameOf(objects.front())
                                           : tr("%n objects", nullptr, static_cast<int>(objects.size()));
  my_.document.edit(visible ? tr("show %1").arg(what) : tr("hide %1").arg(what), [&](Work& work) {
    for (const int object : objects)
      if (visible)
        work.hidden.remove(nameOf(object));
      else
        work.hidden.insert(nameOf(object));
  });
}

void SceneEdits::connectGroups(const PanelSet& panels) {
  const auto group_name = [this](int group) {
    return QString::fromStdString(outline_->pair_groups[static_cast<std::size_t>(group)]);
  };
  connect(panels.groups, &GroupPanel::stateWanted, this, [=, this](int group, view::PairGroupState state) {
    const QString what = state == view::PairGroupState::kRunning  ? tr("run pair group %1")
                         : state == view::PairGroupState::kPaused ? tr("pause pair group %1")
                                                                  : tr("stop pair group %1");
    my_.document.edit(what.arg(group_name(group)), [&](Work& work) {
      if (state == view::PairGroupState::kRunning)
        work.groups.remove(group_name(group));
      else
        work.groups[group_name(group)] = state;
    });
  });
  connect(panels.groups, &GroupPanel::addWanted, this,
          [=, this](int group, int pair) { movePair(pair, group_name(group)); });
  connect(panels.groups, &GroupPanel::removeWanted, this, [this](int pair) { movePair(pair, QString()); });
}

void SceneEdits::movePair(int pair, const QString& group) {
  if (fixed_) return Q_EMIT said(tr("The server decides which pairs are checked"));
  const auto [a, b] = outline_->pairs[static_cast<std::size_t>(pair)];
  const QPair<QString, QString> names(nameOf(a), nameOf(b));
  const QString what = group.isEmpty() ? tr("remove %1 – %2 from its group") : tr("add %1 – %2 to a group");
  my_.document.edit(what.arg(names.first, names.second), [&](Work& work) { work.moved[names] = group; });
}

/// A pair of the scene leaves its group or comes back; one that the scene leaves out is added, which opens
/// the scene anew.
void SceneEdits::checkPair(int a, int b, bool checked) {
  if (fixed_) return Q_EMIT said(tr("The server decides which pairs are checked"));
  const Work& present = my_.document.work();
  const QPair<QString, QString> names(nameOf(a), nameOf(b));
  const auto& pairs = outline_->pairs;
  const auto at = std::find(pairs.begin(), pairs.end(), std::make_pair(a, b));
  const bool is_added = present.added.contains(names);
  if (at != pairs.end() && !is_added && checked && !present.moved.contains(names)) {
    Q_EMIT said(tr("The group of this pair does not run: see the panel Groups"));
    return;
  }
  const QString text = checked ? tr("check %1 – %2") : tr("do not check %1 – %2");
  my_.document.edit(text.arg(names.first, names.second), [&](Work& work) {
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

void SceneEdits::connectJoints(const PanelSet& panels) {
  const JointEditor* joints = panels.inspector->joints();
  connect(joints, &JointEditor::edited, this, &SceneEdits::poseJoint);
  connect(joints, &JointEditor::released, &my_.document, &Document::endStep);
  connect(joints, &JointEditor::followWanted, this, [this](int robot) {
    const QString name = QString::fromStdString(outline_->robots[static_cast<std::size_t>(robot)].name);
    my_.document.edit(tr("let %1 follow its motion").arg(name), [&](Work& work) { work.posed.remove(name); });
  });
}

void SceneEdits::connectReactions(const PanelSet& panels) {
  const ReactionPanel* laws = panels.reactions;
  connect(laws, &ReactionPanel::edited, this,
          [this](const QString& robot, const control::ReactionChange& change, const QString& what,
                 const QString& merge_key) {
            my_.document.edit(
                tr("laws of %1: %2").arg(robot, what),
                [&](Work& work) {
                  if (change.empty())
                    work.reactions.remove(robot);
                  else
                    work.reactions[robot] = change;
                },
                merge_key);
          });
  connect(laws, &ReactionPanel::released, &my_.document, &Document::endStep);
}

void SceneEdits::connectPlaces(const PanelSet& panels) {
  const PlacementEditor* editor = panels.inspector->placement();
  const auto places = [editor](Work& work) -> QMap<QString, Placement>& {
    return editor->kind() == PlacementEditor::Kind::kThing ? work.things : work.placed;
  };
  connect(editor, &PlacementEditor::edited, this, [=, this](const Placement& placement, int axis) {
    if (fixed_) return Q_EMIT said(tr("The server decides where everything stands"));
    my_.document.edit(
        tr("place %1").arg(editor->name()), [&](Work& work) { places(work)[editor->name()] = placement; },
        QStringLiteral("place/%1/%2").arg(editor->name()).arg(axis));
  });
  connect(editor, &PlacementEditor::resetWanted, this, [=, this] {
    my_.document.edit(tr("place %1 as in the scene").arg(editor->name()),
                      [&](Work& work) { places(work).remove(editor->name()); });
  });
}

/// The other joints stay where they are shown.
void SceneEdits::poseJoint(int robot, int joint, double value) {
  const view::RobotCard& card = outline_->robots[static_cast<std::size_t>(robot)];
  const QString name = QString::fromStdString(card.name);
  QVector<double> joints = my_.follower.posed(my_.document.work(), robot);
  if (joints.isEmpty())
    for (int k = 0; k < card.joints; ++k)
      joints.push_back(my_.moment.joint_positions[static_cast<std::size_t>(card.first_joint + k)]);
  joints[joint] = value;
  my_.document.edit(
      tr("pose %1 by hand").arg(name), [&](Work& work) { work.posed[name] = joints; },
      QStringLiteral("pose/%1/%2").arg(name).arg(joint));
}

}  // namespace abstand::ui
