#include "ui/thing_drag.hpp"

#include <cmath>

#include "core/math/roll_pitch_yaw.hpp"
#include "ui/document/document.hpp"
#include "ui/model/groups.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/session_port.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

ThingDrag::ThingDrag(const Sources& sources, QObject* parent) : QObject(parent), my_{sources} {
  connect(&my_.selection, &Selection::changed, this, &ThingDrag::showHandles);
  connect(&my_.viewport, &Viewport::handleGrabbed, this, &ThingDrag::grab);
  connect(&my_.viewport, &Viewport::handlePulled, this, &ThingDrag::pull);
  connect(&my_.viewport, &Viewport::handleReleased, this, &ThingDrag::release);
}

void ThingDrag::open(const SessionPort* session) {
  session_ = session;
  held_.reset();
  showHandles();
}

void ThingDrag::showHandles() {
  const std::vector<int>& objects = my_.selection.objects();
  const bool one = session_ && objects.size() == 1 && objects[0] >= 0 &&
                   static_cast<std::size_t>(objects[0]) < session_->outline().objects.size();
  const bool thing = one && isThing(session_->outline().objects[static_cast<std::size_t>(objects[0])]);
  my_.viewport.setHandles(thing ? objects[0] : -1);
}

void ThingDrag::grab(int object, const Vector3d& centre_W) {
  const auto i = static_cast<std::size_t>(object);
  const QString name = QString::fromStdString(session_->outline().objects[i].name);
  const Transform& X_WB = my_.moment.objects[i].X_WB;
  const auto& things = my_.document.work().things;
  const Placement now{X_WB.translation(), neatRollPitchYaw(X_WB.linear())};
  held_ = {name, things.value(name, now), centre_W};
}

void ThingDrag::pull(const Vector3d& shift, double turn) {
  if (!held_) return;
  Placement to = held_->from;
  const Vector3d lever = to.xyz - held_->centre_W;
  to.xyz = held_->centre_W + shift + Eigen::AngleAxisd(turn, Vector3d::UnitZ()) * lever;
  to.rpy.z() = std::remainder(to.rpy.z() + turn, 2.0 * kPi);
  my_.document.edit(
      tr("move %1").arg(held_->name), [&](Work& work) { work.things[held_->name] = to; },
      QStringLiteral("handle/%1").arg(held_->name));
}

void ThingDrag::step(int object, const Vector3d& direction_W) {
  Eigen::Index axis = 0;
  direction_W.cwiseAbs().maxCoeff(&axis);
  Vector3d shift = Vector3d::Zero();
  shift[axis] = std::copysign(kStep, direction_W[axis]);
  grab(object, my_.moment.objects[static_cast<std::size_t>(object)].X_WB.translation());
  pull(shift, 0.0);
  release();
}

void ThingDrag::release() {
  held_.reset();
  my_.document.endStep();
}

}  // namespace abstand::ui
