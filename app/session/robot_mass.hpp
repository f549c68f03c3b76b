// Inertia of a robot for its reaction.
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

  /// True if every dof moves a mass; otherwise the laws use constant masses.
  bool known() const { return known_; }
  /// Mass matrix (kg m^2 or kg, dof x dof) at the joint values `q` (rad, m); 0 x 0 if unknown.
  const Eigen::MatrixXd& at(std::span<const double> q) noexcept;
  /// Effective mass (kg) at the joint values `q` against a push at the point `p_B` of frame `frame` along the
  /// unit vector `n_B`, base axes (mechanism::effectiveMass()). Infinity for the base (-1), and if unknown.
  double effective(std::span<const double> q, int frame, const Vector3d& p_B, const Vector3d& n_B) noexcept;
  /// kg, half of the total moving mass.
  double halfMoving() const { return half_moving_; }

 private:
  mechanism::RigidTree tree_;
  mechanism::TreeState state_;
  mechanism::MassMatrix mass_;
  Eigen::MatrixXd none_;
  std::vector<double> work_;
  std::vector<double> factored_;  ///< joint values of the last mass matrix that was factored
  double half_moving_{0.0};
  bool known_{false};
};

/// Remark for the user about a robot without inertia; empty if there is none.
std::string massRemark(const std::string& name, const mechanism::Mechanism& mechanism,
                       const control::ReactionDescription& reaction);

}  // namespace abstand::session
