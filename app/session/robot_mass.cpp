#include "app/session/robot_mass.hpp"

#include "core/base/number.hpp"

namespace abstand::session {

RobotMass::RobotMass(const mechanism::Mechanism& mechanism) : tree_(mechanism::makeRigidTree(mechanism)) {
  const std::vector<double> q(static_cast<std::size_t>(mechanism.dof), 0.0);
  mechanism::placeBodies(tree_, q, state_);
  mechanism::massMatrix(tree_, state_, mass_);
  known_ = mechanism.dof > 0 && mechanism::factor(mass_) < 0;
}

const Eigen::MatrixXd& RobotMass::at(std::span<const double> q) noexcept {
  if (!known_) return none_;
  mechanism::placeBodies(tree_, q, state_);
  mechanism::massMatrix(tree_, state_, mass_);
  return mass_.M;
}

std::string massRemark(const std::string& name, const mechanism::Mechanism& mechanism,
                       const control::ReactionDescription& reaction) {
  if (!reaction.repulsion || RobotMass(mechanism).known()) return {};
  return name + ": a joint moves no mass in its file, so damping and energy stop take the constant mass of " +
         formatDouble(reaction.repulsion->mass) + " kg (`mass` of `repulsion`)";
}

}  // namespace abstand::session
