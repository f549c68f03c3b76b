#include "core/control/effective_mass.hpp"

#include "core/base/error.hpp"

namespace abstand {

EffectiveMass::EffectiveMass(int dof) : factor_(dof), solved_(dof) {}

bool EffectiveMass::take(const Eigen::Ref<const Eigen::MatrixXd>& M) noexcept {
  known_ = M.rows() == solved_.size() && M.cols() == solved_.size() && M.allFinite();
  if (!known_) return false;
  factor_.compute(M);
  return known_ = factor_.info() == Eigen::Success;
}

double EffectiveMass::mass(std::span<const double> row) noexcept {
  if (!known_) return kNaN;
  ABSTAND_CHECK(row.size() == static_cast<std::size_t>(solved_.size()));
  // J M^-1 J^T = |L^-1 J^T|^2.
  solved_ = Eigen::Map<const Eigen::VectorXd>(row.data(), solved_.size());
  factor_.matrixL().solveInPlace(solved_);
  return 1.0 / solved_.squaredNorm();
}

}  // namespace abstand
