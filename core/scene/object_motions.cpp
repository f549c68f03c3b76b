#include "core/scene/object_motions.hpp"

namespace abstand::scene {

void ObjectMotions::addObject(const geometry::EnclosingSphere& sphere_B) {
  histories_.emplace_back();
  bounds_.emplace_back(sphere_B);
}

bool ObjectMotions::update(ObjectId id, Object& object, const Transform& X_WB, double t) {
  auto& history = histories_[id.index()];
  const double dt = t - object.t;
  const bool moved = object.X_WB.matrix() != X_WB.matrix();
  const double step = moved ? bounds_[id.index()].moveTo(X_WB) : 0.0;
  if (!history.started() || dt <= -kMinTimeStep) {
    ++object.interruptions;
    history.start();
    object.velocity = object.mean_velocity = Twist{};
  } else if (dt >= kMinTimeStep) {
    const Vector3d displacement = X_WB * object.spec.structure->com - object.p_WCom();
    const Vector3d rotation = rotationBetween(object.X_WB.linear(), X_WB.linear());
    history.add(dt, displacement, rotation);
    object.velocity = {displacement / dt, rotation / dt};
    object.mean_velocity = history.mean();
    if (speed_watch_.add(id, t, step, dt, object.max_speed, object.speed_state)) ++object.interruptions;
  } else if (moved) {
    ++object.interruptions;
  }
  return moved;
}

}  // namespace abstand::scene
