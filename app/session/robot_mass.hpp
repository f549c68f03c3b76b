// The inertia of a robot as its reaction needs it.
#pragma once

#include <string>

#include "core/control/reaction_description.hpp"
#include "core/mechanism/mass_matrix.hpp"

namespace abstand::session {

/// The mass matrix of a mechanism. One thread; at() does not allocate or throw.
class RobotMass {
 public:
  explicit RobotMass(const mechanism::Mechanism& mechanism);

  /// Every dof moves a mass. Where not, the laws take constant masses.
  bool known() const { return known_; }
  /// kg m^2 or kg, dof x dof, at the joint values `q` (rad, m); 0 x 0 where it is not known.
  const Eigen::MatrixXd& at(std::span<const double> q) noexcept;

 private:
  mechanism::RigidTree tree_;
  mechanism::TreeState state_;
  mechanism::MassMatrix mass_;
  Eigen::MatrixXd none_;
  bool known_{false};
};

/// What a user should know of a robot without inertia; empty: nothing.
std::string massRemark(const std::string& name, const mechanism::Mechanism& mechanism,
                       const control::ReactionDescription& reaction);

}  // namespace abstand::session
