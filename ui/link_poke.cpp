// Links of robots that react are poked in the 3D view, or by a key.
#include "ui/link_poke.hpp"

#include <QAction>
#include <algorithm>

#include "ui/document/document.hpp"
#include "ui/document/session_follower.hpp"
#include "ui/model/inspected_subject.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/session_port.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

LinkPoke::LinkPoke(const Sources& sources, const QAction* push, QObject* parent)
    : QObject(parent), my_{sources} {
  connect(&my_.viewport, &Viewport::bodyPoked, this, &LinkPoke::begin);
  connect(&my_.viewport, &Viewport::pokeMoved, this, &LinkPoke::move);
  connect(&my_.viewport, &Viewport::pokeEnded, this, &LinkPoke::end);
  connect(push, &QAction::triggered, this, &LinkPoke::push);
  renew_.setInterval(kRenewMs);
  connect(&renew_, &QTimer::timeout, this, &LinkPoke::send);
  push_end_.setInterval(kPushMs);
  push_end_.setSingleShot(true);
  connect(&push_end_, &QTimer::timeout, this, &LinkPoke::end);
}

void LinkPoke::open(SessionPort* session) {
  held_.reset();
  renew_.stop();
  push_end_.stop();
  session_ = session;
}

/// Why a poke of this body at `p_W` has no effect; empty: it has one.
QString LinkPoke::whyNot(int object, const Vector3d& p_W) const {
  const view::SceneOutline& outline = session_->outline();
  const std::string& group = outline.objects[static_cast<std::size_t>(object)].group;
  const int card = robotOf(outline, group);
  if (card < 0) return tr("Only links of robots can be poked");
  const QString name = QString::fromStdString(group);
  const auto at = std::find(outline.reacting.begin(), outline.reacting.end(), group);
  if (at == outline.reacting.end())
    return tr("%1 cannot react to a poke: the scene file gives it no reaction").arg(name);
  if (!outline.cannot_react.empty())
    return tr("%1 cannot react to a poke: %2").arg(name, QString::fromStdString(outline.cannot_react));
  if (my_.moment.robots.empty()) return tr("%1 does not react to a poke: React is off").arg(name);
  if (isByHand(my_.moment, card)) return tr("%1 does not react to a poke: it is posed by hand").arg(name);
  const view::RobotCard& robot = outline.robots[static_cast<std::size_t>(card)];
  const auto joints = my_.moment.joint_positions.begin() + robot.first_joint;
  const Vector3d p_B = my_.moment.objects[static_cast<std::size_t>(object)].X_WB.inverse() * p_W;
  // Asked for where it is: whether joints move this body at all.
  if (!session_->reach(object, p_B, p_W, {joints, joints + robot.joints}))
    return tr("No joint moves this link");
  return whyRobotDoesNotYield(static_cast<int>(at - outline.reacting.begin()));
}

/// `robot`: index of SceneOutline::reacting.
QString LinkPoke::whyRobotDoesNotYield(int robot) const {
  const auto r = static_cast<std::size_t>(robot);
  const QString name = QString::fromStdString(session_->outline().reacting[r]);
  if (!my_.follower.reaction(my_.document.work(), robot).torque)
    return tr("%1 does not yield to a poke: its law Torque is off (panel Laws)").arg(name);
  if (!my_.moment.torques_on) return tr("%1 does not yield to a poke: reaction torques are off").arg(name);
  if (my_.moment.robots[r].state == safety::StopState::kEmergencyStop)
    return tr("%1 does not yield to a poke: its brakes are engaged").arg(name);
  return {};
}

bool LinkPoke::begin(int object, const Vector3d& p_W) {
  end();
  if (!session_) return false;
  my_.selection.setObjects({object});
  const QString problem = whyNot(object, p_W);
  if (!problem.isEmpty()) {
    Q_EMIT said(problem);
    return false;
  }
  held_ = Held{object, my_.moment.objects[static_cast<std::size_t>(object)].X_WB.inverse() * p_W, p_W};
  if (!my_.moment.playing) Q_EMIT said(tr("Poke: press Play to see the robot yield"));
  renew_.start();
  send();
  return true;
}

void LinkPoke::move(const Vector3d& target_W) {
  if (!held_) return;
  held_->target_W = target_W;
  send();
}

void LinkPoke::send() {
  if (held_ && session_) session_->poke(held_->object, held_->p_B, held_->target_W);
}

void LinkPoke::end() {
  renew_.stop();
  push_end_.stop();
  if (held_ && session_) session_->endPoke();
  held_.reset();
}

void LinkPoke::push() {
  const std::vector<int>& objects = my_.selection.objects();
  if (!session_ || objects.size() != 1) return Q_EMIT said(tr("Select one link of a robot first"));
  const Vector3d p_W = my_.moment.objects[static_cast<std::size_t>(objects[0])].p_WCom;
  if (!begin(objects[0], p_W)) return;
  move(p_W - kPush * my_.viewport.fromScreen(Vector3d::UnitZ()));
  push_end_.start();
}

}  // namespace abstand::ui
