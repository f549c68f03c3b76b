#include "app/studio/robot_reach.hpp"

#include "core/mechanism/inverse_kinematics.hpp"

namespace abstand::studio {

namespace {

bool isMoved(const mechanism::Mechanism& mechanism, int frame) {
  for (int i = frame; i >= 0; i = mechanism.frames[static_cast<std::size_t>(i)].parent)
    if (mechanism.frames[static_cast<std::size_t>(i)].dof >= 0) return true;
  return false;
}

}  // namespace

RobotReach::RobotReach(const session::Session& session) {
  for (const auto& driver : session.mechanisms()) {
    for (const session::MechanismDriver::Link& link : driver->links())
      if (link.object && !link.loose && isMoved(driver->mechanism(), link.frame))
        links_[static_cast<int>(link.object->index())] = {robots_.size(), link.frame, link.X_FL};
    robots_.push_back({driver->mechanism(), driver->X_WB()});
  }
}

std::optional<ui::Reached> RobotReach::reach(int object, const Vector3d& p_B, const Vector3d& p_W,
                                             std::vector<double> joints) const {
  const auto link = links_.find(object);
  if (link == links_.end()) return {};
  const Robot& robot = robots_[link->second.robot];
  if (joints.size() != static_cast<std::size_t>(robot.mechanism.dof)) return {};
  mechanism::PointReach search(robot.mechanism, link->second.frame);
  const auto result = search.solve(link->second.X_FL * p_B, robot.X_WB.inverse() * p_W, joints);
  if (std::isnan(result.distance)) return {};
  return ui::Reached{std::move(joints), result.distance};
}

}  // namespace abstand::studio
