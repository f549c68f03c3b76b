#include "app/session/robot_mass.hpp"

#include "core/base/number.hpp"

namespace abstand {

RobotMass::RobotMass(const Mechanism& mechanism) : tree_(makeRigidTree(mechanism)) {
  const std::vector<double> q(static_cast<std::size_t>(mechanism.dof), 0.0);
  placeBodies(tree_, q, state_);
  massMatrix(tree_, state_, mass_);
  known_ = mechanism.dof > 0 && factor(mass_) < 0;
}

const Eigen::MatrixXd& RobotMass::at(std::span<const double> q) noexcept {
  if (!known_) return none_;
  placeBodies(tree_, q, state_);
  massMatrix(tree_, state_, mass_);
  return mass_.M;
}

std::string massRemark(const std::string& name, const Mechanism& mechanism,
                       const ReactionDescription& reaction) {
  if (!reaction.repulsion || RobotMass(mechanism).known()) return {};
  return name + ": a joint moves no mass in its file, so damping and energy stop take the constant mass of " +
         formatDouble(reaction.repulsion->mass) + " kg (`mass` of `repulsion`)";
}

}  // namespace abstand
