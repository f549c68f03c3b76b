#include "tracking/body/joint_spread.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace abstand::tracking {

JointCovariances jointCovariances(const BodyRig& rig, const BodySolver& problem,
                                  const BodySolver::Matrix& information) {
  JointCovariances covariance;
  covariance.fill(Matrix3d(Vector3d::Constant(kInfinity).asDiagonal()));
  BodySolver::Matrix H = information;
  H.diagonal().array() += 1e-9 * H.diagonal().maxCoeff();
  const Eigen::LLT<BodySolver::Matrix> llt(H);
  if (llt.info() != Eigen::Success) return covariance;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const RigSegment s = rig.carrier[j];
    const auto J = problem.jacobian(s, problem.placement()[index(s)] * rig.p_joint[j]);
    const Eigen::Matrix<double, kRigDof, 3> half = llt.matrixL().solve(J.transpose());
    covariance[j] = half.transpose() * half;
  }
  return covariance;
}

std::array<double, humanmodel::kJointCount> jointSpreads(const BodyRig& rig, const BodySolver& problem,
                                                         const BodySolver::Matrix& information) {
  const auto covariance = jointCovariances(rig, problem, information);
  std::array<double, humanmodel::kJointCount> spread;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    spread[j] = kInfinity;
    if (!covariance[j].allFinite()) continue;
    const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(covariance[j], Eigen::EigenvaluesOnly);
    spread[j] = std::sqrt(std::max(0.0, axes.eigenvalues()[2]));
  }
  return spread;
}

}  // namespace abstand::tracking
