// Accuracy of a camera pose, and of the points that the camera sees.
#include "tracking/depth/calibration/pose_spread.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

double largestVariance(const Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(covariance, Eigen::EigenvaluesOnly);
  return std::max(0.0, axes.eigenvalues()[2]);
}

}  // namespace

Transform movedAbout(const Vector3d& p_W, const Transform& X_WC, const Vector6d& step) {
  const Vector3d turn = step.tail<3>();
  const double angle = turn.norm();
  Transform X = X_WC;
  if (angle > 0.0) {
    const Eigen::AngleAxisd R(angle, turn / angle);
    X.linear() = Quaterniond(R * X_WC.linear()).normalized().toRotationMatrix();
    X.translation() = p_W + R * (X_WC.translation() - p_W);
  }
  X.translation() += step.head<3>();
  return X;
}

Matrix3d covarianceAt(const Matrix6d& covariance, const Vector3d& d) {
  Eigen::Matrix<double, 3, 6> J;
  for (int k = 0; k < 3; ++k) {
    J.col(k) = Vector3d::Unit(k);
    J.col(3 + k) = Vector3d::Unit(k).cross(d);
  }
  return J * covariance * J.transpose();
}

double spreadWithin(const Matrix6d& covariance, const Vector3d& to_camera) {
  const double reach = std::max(kUsedWithin, to_camera.norm());
  const Matrix3d turns = covariance.bottomRightCorner<3, 3>();
  const Matrix3d around =
      covariance.topLeftCorner<3, 3>() + reach * reach / 3.0 * (turns.trace() * Matrix3d::Identity() - turns);
  return std::sqrt(std::max(largestVariance(around), largestVariance(covarianceAt(covariance, to_camera))));
}

double weakestConstraint(const Matrix6d& mean_JTJ) {
  Matrix6d H = mean_JTJ;
  const double turns = H.bottomRightCorner<3, 3>().trace();
  const double scale = turns > 0.0 ? 1.0 / std::sqrt(turns) : 0.0;
  H.bottomRows<3>() *= scale;
  H.rightCols<3>() *= scale;
  return Eigen::SelfAdjointEigenSolver<Matrix6d>(H, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

}  // namespace abstand::tracking
