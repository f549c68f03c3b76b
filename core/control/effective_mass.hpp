// The mass of a mechanism as it is felt along a direction.
#pragma once

#include <span>
#include <vector>

#include "core/mechanism/mass_matrix.hpp"

namespace abstand::control {

/// m = 1 / (J M^-1 J^T) for a row J = d(distance)/dq [Khatib 1987, A unified approach for motion and force
/// control]. Factors a mass matrix once a cycle. One thread; no allocation after it is made.
class EffectiveMass {
 public:
  explicit EffectiveMass(int dof);

  /// M: dof x dof, kg m^2 or kg, symmetric; only its lower half is read. False when it is of another size,
  /// not finite or not positive definite: then mass() gives NaN.
  bool take(const Eigen::Ref<const Eigen::MatrixXd>& M) noexcept;
  bool known() const { return known_; }
  /// kg; infinite for a row of zeros: the mechanism cannot move that way.
  double mass(std::span<const double> row) noexcept;

 private:
  mechanism::MassMatrix mass_;
  std::vector<double> solved_;
  bool known_{false};
};

}  // namespace abstand::control
