// Inverse kinematics of a session's robots, for the window.
#pragma once

#include "app/session/session.hpp"
#include "ui/model/session_port.hpp"

namespace abstand::studio {

/// Copies of the robots' mechanisms: usable while the session runs on its own thread. Constant.
class RobotReach {
 public:
  RobotReach() = default;
  explicit RobotReach(const session::Session& session);

  /// See SessionPort::reach().
  std::optional<ui::Reached> reach(int object, const Vector3d& p_B, const Vector3d& p_W,
                                   std::vector<double> joints) const;

 private:
  struct Robot {
    mechanism::Mechanism mechanism;
    Transform X_WB;
  };
  struct Link {
    std::size_t robot;
    int frame;
    Transform X_FL;
  };
  std::vector<Robot> robots_;
  std::map<int, Link> links_;  // by object; those that joints move
};

}  // namespace abstand::studio
