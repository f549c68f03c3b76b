#include "tracking/body/joint_spread.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace abstand::tracking {

std::array<double, humanmodel::kJointCount> jointSpreads(const BodyRig& rig, const BodySolver& problem,
                                                         const BodySolver::Matrix& information) {
  std::array<double, humanmodel::kJointCount> spread;
  spread.fill(kInfinity);
  BodySolver::Matrix H = information;
  H.diagonal().array() += 1e-9 * H.diagonal().maxCoeff();
  const Eigen::LLT<BodySolver::Matrix> llt(H);
  if (llt.info() != Eigen::Success) return spread;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const RigSegment s = rig.carrier[j];
    const auto J = problem.jacobian(s, problem.placement()[index(s)] * rig.p_joint[j]);
    const Eigen::Matrix<double, kRigDof, 3> half = llt.matrixL().solve(J.transpose());
    const Matrix3d covariance = half.transpose() * half;
    const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(covariance, Eigen::EigenvaluesOnly);
    spread[j] = std::sqrt(std::max(0.0, axes.eigenvalues()[2]));
  }
  return spread;
}

}  // namespace abstand::tracking
