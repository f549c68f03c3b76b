#include "core/control/effective_mass.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::control {

EffectiveMass::EffectiveMass(int dof)
    : mass_{Eigen::MatrixXd::Identity(dof, dof), Eigen::MatrixXd::Identity(dof, dof)},
      solved_(static_cast<std::size_t>(dof)) {}

bool EffectiveMass::factorize(const Eigen::Ref<const Eigen::MatrixXd>& M) noexcept {
  known_ = M.rows() == mass_.M.rows() && M.cols() == mass_.M.cols() && M.allFinite();
  if (!known_) return false;
  mass_.M = M;
  return known_ = mechanism::factor(mass_) < 0;
}

double EffectiveMass::mass(std::span<const double> row) noexcept {
  if (!known_) return kNaN;
  ABSTAND_CHECK(row.size() == solved_.size());
  std::copy(row.begin(), row.end(), solved_.begin());
  return 1.0 / mechanism::mobilityOf(mass_, solved_);
}

}  // namespace abstand::control
