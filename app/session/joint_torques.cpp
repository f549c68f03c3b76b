#include "app/session/joint_torques.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::session {

JointTorques::JointTorques(const MechanismDriver& driver)
    : driver_(driver),
      tree_(mechanism::makeRigidTree(driver.mechanism())),
      gravity_B_(driver.X_WB().linear().transpose() * mechanism::kGravity) {
  if (driver.motion()) motion_.emplace(*driver.motion());
  weighs_ = std::any_of(tree_.bodies.begin(), tree_.bodies.end(),
                        [](const mechanism::TreeBody& body) { return body.mass > 0.0; });
  for (auto* v : {&q_, &qd_, &qdd_, &efforts_}) v->assign(static_cast<std::size_t>(driver.dof()), 0.0);
}

void JointTorques::update(std::span<const double> qd, std::span<const double> qdd,
                          std::span<view::TorqueParts> out) {
  ABSTAND_CHECK(out.size() == efforts_.size());
  if (!weighs_) {
    for (view::TorqueParts& joint : out) joint.gravity = joint.motion = kNaN;
    return;
  }
  mechanism::gravityEfforts(tree_, driver_.q(), gravity_B_, state_, efforts_);
  for (std::size_t i = 0; i < out.size(); ++i) out[i].gravity = -efforts_[i];
  mechanism::inverseDynamics(tree_, {driver_.q(), qd, qdd}, {Vector3d::Zero(), {}}, state_, efforts_);
  for (std::size_t i = 0; i < out.size(); ++i) out[i].motion = -efforts_[i];
}

void JointTorques::updateRecorded(double t, std::span<view::TorqueParts> out) {
  if (motion_) motion_->at(t, q_, qd_, qdd_);
  update(qd_, qdd_, out);
}

void JointTorques::updateAtRest(std::span<view::TorqueParts> out) {
  std::fill(qd_.begin(), qd_.end(), 0.0);
  std::fill(qdd_.begin(), qdd_.end(), 0.0);
  update(qd_, qdd_, out);
}

}  // namespace abstand::session
