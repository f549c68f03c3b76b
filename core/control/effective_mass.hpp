// Effective mass of a mechanism along a direction.
#pragma once

#include <span>
#include <vector>

#include "core/mechanism/mass_matrix.hpp"

namespace abstand::control {

/// m = 1 / (J M^-1 J^T) for a row J = d(distance)/dq [Khatib 1987, A unified approach for motion and force
/// control]. Factorises the mass matrix once for each cycle. One thread; no allocation after construction.
class EffectiveMass {
 public:
  explicit EffectiveMass(int dof);

  /// Factorises M: dof x dof, kg m^2 or kg, symmetric; only its lower half is read. False if its size
  /// differs, or if it is not finite or not positive definite: then mass() returns NaN.
  bool factorize(const Eigen::Ref<const Eigen::MatrixXd>& M) noexcept;
  bool known() const { return known_; }
  /// kg; infinite for a zero row: the mechanism cannot move in that direction.
  double mass(std::span<const double> row) noexcept;

 private:
  mechanism::MassMatrix mass_;
  std::vector<double> solved_;
  bool known_{false};
};

}  // namespace abstand::control
