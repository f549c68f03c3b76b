#include "app/session/robot_mass.hpp"

#include <algorithm>

#include "core/base/number.hpp"
#include "core/mechanism/effective_mass.hpp"

namespace abstand::session {

RobotMass::RobotMass(const mechanism::Mechanism& mechanism) : tree_(mechanism::makeRigidTree(mechanism)) {
  const std::vector<double> q(static_cast<std::size_t>(mechanism.dof), 0.0);
  mechanism::placeBodies(tree_, q, state_);
  mechanism::massMatrix(tree_, state_, mass_);
  known_ = mechanism.dof > 0 && mechanism::factor(mass_) < 0;
  work_.resize(q.size());
  factored_.reserve(q.size());
  for (const mechanism::TreeBody& body : tree_.bodies) half_moving_ += 0.5 * body.mass;
}

const Eigen::MatrixXd& RobotMass::at(std::span<const double> q) noexcept {
  if (!known_) return none_;
  factored_.clear();
  mechanism::placeBodies(tree_, q, state_);
  mechanism::massMatrix(tree_, state_, mass_);
  return mass_.M;
}

double RobotMass::effective(std::span<const double> q, int frame, const Vector3d& p_B,
                            const Vector3d& n_B) noexcept {
  if (!known_ || frame < 0) return kInfinity;
  // Many points are asked for in the same posture.
  if (!std::equal(q.begin(), q.end(), factored_.begin(), factored_.end())) {
    at(q);
    if (mechanism::factor(mass_) >= 0) return kInfinity;
    factored_.assign(q.begin(), q.end());
  }
  return mechanism::effectiveMass({tree_, state_, mass_}, frame, p_B, n_B, work_);
}

std::string massRemark(const std::string& name, const mechanism::Mechanism& mechanism,
                       const control::ReactionDescription& reaction) {
  if (!reaction.repulsion || RobotMass(mechanism).known()) return {};
  return name + ": a joint moves no mass in its file, so damping and energy stop take the constant mass of " +
         formatDouble(reaction.repulsion->mass) + " kg (`mass` of `repulsion`)";
}

}  // namespace abstand::session
