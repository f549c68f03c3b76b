// Accuracy of a camera pose, and of the points that the camera sees.
#include "tracking/depth/calibration/pose_spread.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace abstand::tracking {

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

double spreadAt(const Matrix6d& covariance, double reach) {
  const double moves = covariance.topLeftCorner<3, 3>().trace();
  const double turns = covariance.bottomRightCorner<3, 3>().trace();
  return std::sqrt((moves + 2.0 / 3.0 * reach * reach * turns) / 3.0);
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
