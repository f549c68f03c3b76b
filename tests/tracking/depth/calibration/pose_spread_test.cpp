// Accuracy of camera poses: closed forms.
#include "tracking/depth/calibration/pose_spread.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/math/random.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/tracking/depth/calibration/pose_errors.hpp"

namespace abstand::testing {
namespace pose_spread_test {

constexpr double kRounding = 1e-12;

tracking::Matrix6d randomCovariance(std::uint64_t seed) {
  Random random(seed, 0);
  tracking::Matrix6d root;
  for (int i = 0; i < 36; ++i) root(i / 6, i % 6) = random.between(-1.0, 1.0);
  return root * root.transpose();
}

double largest(const Matrix3d& covariance) {
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance).eigenvalues()[2];
}

TEST(PoseSpread, CovarianceOfPointIsThatOfItsSteps) {
  const tracking::Matrix6d covariance = randomCovariance(3);
  const Eigen::SelfAdjointEigenSolver<tracking::Matrix6d> axes(covariance);
  const Transform X = randomPose(4, 2.0);
  const Vector3d pivot(0.3, -0.4, 1.0), d(0.5, 1.2, -0.7);
  constexpr double kSmall = 1e-5;
  Matrix3d sum = Matrix3d::Zero();
  for (int k = 0; k < 6; ++k) {
    const tracking::Vector6d step = kSmall * std::sqrt(axes.eigenvalues()[k]) * axes.eigenvectors().col(k);
    const Transform moved = tracking::movedAbout(pivot, X, step);
    const Vector3d off = (moved * (X.inverse() * (pivot + d)) - (pivot + d)) / kSmall;
    sum += off * off.transpose();
  }
  // Rotations are linear to kSmall.
  EXPECT_LT((sum - tracking::covarianceAt(covariance, d)).norm(), 1e-3 * sum.norm());
}

TEST(PoseSpread, IsWorstAxisOfMeanOverAllDirectionsAndOfCamera) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const Vector3d& to_camera : {Vector3d(0.1, 0.2, 0.3), Vector3d(3.0, 1.0, -2.0)}) {
      const tracking::Matrix6d covariance = randomCovariance(seed);
      const double reach = std::max(1.0, to_camera.norm());
      Matrix3d mean = Matrix3d::Zero();
      // The poles of a sphere have the second moments of all of it.
      for (int k = 0; k < 6; ++k)
        mean += tracking::covarianceAt(covariance, (k % 2 ? -reach : reach) * Vector3d::Unit(k / 2)) / 6.0;
      const double of_camera = largest(tracking::covarianceAt(covariance, to_camera));
      EXPECT_NEAR(tracking::spreadWithin(covariance, to_camera),
                  std::sqrt(std::max(largest(mean), of_camera)), kRounding);
    }
}

// A rotation by 1 mrad about a point moves a camera that is 4 m away by 4 mm, unless its axis is through the
// camera; then other points 4 m away are moved by 4 sqrt(2/3) mm, in two axes.
TEST(PoseSpread, GrowsWithLeverArmOfCamera) {
  tracking::Matrix6d covariance = tracking::Matrix6d::Zero();
  covariance(5, 5) = 1e-6;
  EXPECT_NEAR(tracking::spreadWithin(covariance, {4.0, 0.0, 0.0}), 4e-3, kRounding);
  EXPECT_NEAR(tracking::spreadWithin(covariance, {0.0, 0.0, 4.0}), 4e-3 * std::sqrt(1.0 / 3.0), kRounding);
  EXPECT_NEAR(tracking::spreadWithin(covariance, {0.0, 0.0, 0.4}), 1e-3 * std::sqrt(1.0 / 3.0), kRounding);
}

TEST(PoseSpread, StepsRotateAboutPivot) {
  const Transform X = randomPose(3, 2.0);
  const Vector3d pivot(0.3, -0.4, 1.0);
  tracking::Vector6d step;
  step << 0.0, 0.0, 0.0, 0.1, -0.2, 0.3;
  const Transform moved = tracking::movedAbout(pivot, X, step);
  EXPECT_LT((moved * (X.inverse() * pivot) - pivot).norm(), 1e-12);
  EXPECT_NEAR(angleBetween(moved, X), step.norm(), 1e-12);
  step << 0.1, 0.2, 0.3, 0.0, 0.0, 0.0;
  EXPECT_LT((tracking::movedAbout(pivot, X, step).translation() - X.translation() - step.head<3>()).norm(),
            1e-12);
}

}  // namespace pose_spread_test
}  // namespace abstand::testing
