// The inertia of a robot as its reaction needs it.
#pragma once

#include <string>
#include <vector>

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
  /// kg, at the joint values `q`, against a push at the point `p_B` of frame `frame` along the unit vector
  /// `n_B`, in the base's axes (mechanism::effectiveMass()). Infinity for the base (-1), and where it is not
  /// known.
  double effective(std::span<const double> q, int frame, const Vector3d& p_B, const Vector3d& n_B) noexcept;
  /// kg, half of all that moves.
  double halfMoving() const { return half_moving_; }

 private:
  mechanism::RigidTree tree_;
  mechanism::TreeState state_;
  mechanism::MassMatrix mass_;
  Eigen::MatrixXd none_;
  std::vector<double> work_;
  double half_moving_{0.0};
  bool known_{false};
};

/// What a user should know of a robot without inertia; empty: nothing.
std::string massRemark(const std::string& name, const mechanism::Mechanism& mechanism,
                       const control::ReactionDescription& reaction);

}  // namespace abstand::session
