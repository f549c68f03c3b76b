// Links of robots are pulled in the 3D view, or moved by keys.
#include "ui/link_drag.hpp"

#include "ui/document/document.hpp"
#include "ui/document/session_follower.hpp"
#include "ui/model/groups.hpp"
#include "ui/model/inspected_subject.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/session_port.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

namespace {
using Id = ActionId;
constexpr double kOutOfReach = 1e-3;  // m, from the pointer, from which on it is said
}  // namespace

LinkDrag::LinkDrag(const Sources& sources, const Actions& actions, QObject* parent)
    : QObject(parent), my_{sources} {
  connect(&my_.viewport, &Viewport::bodyGrabbed, this, &LinkDrag::grab);
  connect(&my_.viewport, &Viewport::bodyPulled, this, &LinkDrag::pull);
  connect(&my_.viewport, &Viewport::bodyReleased, this, &LinkDrag::release);
  connectKeys(actions);
}

void LinkDrag::connectKeys(const Actions& actions) {
  const std::pair<Id, Vector3d> keys[] = {
      {Id::kLinkLeft, -Vector3d::UnitX()},  {Id::kLinkRight, Vector3d::UnitX()},
      {Id::kLinkUp, -Vector3d::UnitY()},    {Id::kLinkDown, Vector3d::UnitY()},
      {Id::kLinkNearer, Vector3d::UnitZ()}, {Id::kLinkFarther, -Vector3d::UnitZ()}};
  for (const auto& [id, direction] : keys)
    connect(actions[id], &QAction::triggered, this, [this, d = direction] { move(d); });
}

void LinkDrag::open(const SessionPort* session) {
  session_ = session;
  held_.reset();
  my_.viewport.hidePull();
}

std::optional<LinkDrag::Held> LinkDrag::hold(int object, const Vector3d& p_W) {
  if (!session_) return {};
  const view::SceneOutline& outline = session_->outline();
  const auto i = static_cast<std::size_t>(object);
  const int robot = robotOf(outline, outline.objects[i].group);
  if (robot < 0) {
    Q_EMIT said(isThing(outline.objects[i]) ? tr("A thing is moved by its handles, once it is selected")
                                            : tr("Only links of robots can be moved"));
    return {};
  }
  Held held{object, robot, my_.moment.objects[i].X_WB.inverse() * p_W, {}};
  const QVector<double> posed = my_.follower.posed(my_.document.work(), robot);
  held.joints.assign(posed.begin(), posed.end());
  const view::RobotCard& card = outline.robots[static_cast<std::size_t>(robot)];
  if (posed.isEmpty())
    for (int k = 0; k < card.joints; ++k)
      held.joints.push_back(my_.moment.joint_positions[static_cast<std::size_t>(card.first_joint + k)]);
  // Asked for where it is: whether joints move this body at all.
  if (!session_->reach(object, held.p_B, p_W, held.joints)) {
    Q_EMIT said(tr("No joint moves this link"));
    return {};
  }
  return held;
}

void LinkDrag::grab(int object, const Vector3d& p_W) {
  my_.selection.setObjects({object});
  held_ = hold(object, p_W);
}

void LinkDrag::pull(const Vector3d& p_W) {
  if (held_) pose(*held_, p_W, QStringLiteral("pull/%1").arg(held_->robot));
}

void LinkDrag::release() {
  held_.reset();
  my_.viewport.hidePull();
  my_.document.endStep();
}

void LinkDrag::move(const Vector3d& on_screen) {
  const std::vector<int>& objects = my_.selection.objects();
  if (!session_ || objects.size() != 1)
    return Q_EMIT said(tr("Select one link of a robot, or one thing, first"));
  const Vector3d direction_W = my_.viewport.fromScreen(on_screen);
  if (isThing(session_->outline().objects[static_cast<std::size_t>(objects[0])]))
    return Q_EMIT thingWanted(objects[0], direction_W);
  const Vector3d p_W = my_.moment.objects[static_cast<std::size_t>(objects[0])].p_WCom;
  std::optional<Held> held = hold(objects[0], p_W);
  if (!held) return;
  pose(*held, p_W + kStep * direction_W, QString());
  my_.viewport.hidePull();
}

void LinkDrag::pose(Held& held, const Vector3d& p_W, const QString& merge_key) {
  const std::optional<Reached> reached = session_->reach(held.object, held.p_B, p_W, held.joints);
  if (!reached) return;
  held.joints = reached->joints;
  const view::RobotCard& card = session_->outline().robots[static_cast<std::size_t>(held.robot)];
  const QString name = QString::fromStdString(card.name);
  const QVector<double> joints(held.joints.begin(), held.joints.end());
  my_.document.edit(
      tr("move a link of %1").arg(name), [&](Work& work) { work.posed[name] = joints; }, merge_key);
  if (reached->distance > kOutOfReach) {
    my_.viewport.showPull(my_.moment.objects[static_cast<std::size_t>(held.object)].X_WB * held.p_B, p_W);
    Q_EMIT said(tr("Out of reach by %1: a joint limit or the length of the arm")
                    .arg(lengthText(reached->distance, 0)));
  } else {
    my_.viewport.hidePull();
  }
}

}  // namespace abstand::ui
