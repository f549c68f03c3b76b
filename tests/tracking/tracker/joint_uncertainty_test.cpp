// The ellipsoid of a joint becomes the ball of its largest axis where the fit is doubtful.
#include "tracking/tracker/joint_uncertainty.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "humanmodel/joint_covariance.hpp"

namespace abstand::tracking {
namespace joint_uncertainty_test {

constexpr double kRounding = 1e-12;  // m^2

DepthMisfit misfit(double explained, double residual) {
  return {.cost = 0.0, .explained = explained, .residual = residual};
}

TEST(FitDoubt, IsZeroForAGoodFitAndOneForABadOne) {
  EXPECT_EQ(doubtOf(misfit(1.0, 0.009)), 0.0);
  EXPECT_EQ(doubtOf(misfit(0.9, 0.009)), 1.0) << "much is unexplained";
  EXPECT_EQ(doubtOf(misfit(1.0, 0.015)), 1.0) << "the explained points are off";
  EXPECT_EQ(doubtOfExplained(0.9), 1.0);
  EXPECT_EQ(doubtOfExplained(1.0), 0.0);
}

TEST(FitDoubt, GrowsWithTheMisfit) {
  double last = 0.0;
  for (double residual = 0.009; residual < 0.015; residual += 2e-4) {
    const double doubt = doubtOf(misfit(0.96, residual));
    EXPECT_GE(doubt, std::max(last, doubtOfExplained(0.96)));
    EXPECT_LE(doubt, 1.0);
    last = doubt;
  }
}

TEST(FitDoubt, RoundsAnEllipsoidWithoutMakingItLargerThanItsBall) {
  std::mt19937_64 random{3};
  std::normal_distribution<double> normal{0.0, 0.05};
  for (int i = 0; i < 50; ++i) {
    Matrix3d root;
    for (int k = 0; k < 9; ++k) root(k / 3, k % 3) = normal(random);
    const Matrix3d covariance = root * root.transpose();
    const double largest = humanmodel::worstDeviation(covariance);
    for (const double doubt : {0.0, 0.3, 1.0}) {
      const Matrix3d round = rounded(covariance, doubt);
      EXPECT_NEAR(humanmodel::worstDeviation(round), largest, kRounding / largest);
      const Eigen::SelfAdjointEigenSolver<Matrix3d> added(round - covariance, Eigen::EigenvaluesOnly);
      EXPECT_GE(added.eigenvalues()[0], -kRounding) << "it holds the ellipsoid";
      const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(round, Eigen::EigenvaluesOnly);
      EXPECT_GE(axes.eigenvalues()[0], doubt * largest * largest - kRounding);
    }
    EXPECT_EQ(rounded(covariance, 0.0), covariance);
  }
}

TEST(TrackedCovariances, TouchCountsLessWhereAHandExplainsPointsThatNothingElseExplains) {
  constexpr double kShareLeft = 0.3;  // of the standard deviation; 0.7 are refuted (joint_uncertainty.cpp)
  constexpr double kSlope = 0.5;      // at 2.5 points, halfway from 1 to 4
  const BodyRig rig = makeRig(humanmodel::makeHuman({}));
  BodySolver problem(rig);
  problem.begin(RigPose{});
  BodySolver::Vector weight;
  weight.setOnes();
  problem.addPrior(RigPose{}, weight);
  problem.step(1e-3, 0.1);
  std::array<double, kRigSegments> visible, gap, support;
  visible.fill(1.0);
  const auto varianceOfHand = [&](double gap_of_all, double support_of_all) {
    gap.fill(gap_of_all);
    support.fill(support_of_all);
    const JointCovariances covariance = trackedCovariances(
        rig, problem, {.residual = 0.01, .doubt = 0.0, .visible = visible, .gap = gap, .support = support});
    return Matrix3d(covariance[static_cast<std::size_t>(humanmodel::Joint::kHandLeft)]);
  };
  const Matrix3d free = varianceOfHand(kInfinity, 0.0);
  const Matrix3d touch = varianceOfHand(0.0, 0.0) - free;
  EXPECT_GT(touch.trace(), 0.0);
  EXPECT_TRUE((varianceOfHand(0.0, 4.0) - free).isApprox(kShareLeft * kShareLeft * touch, 1e-9));
  EXPECT_TRUE((varianceOfHand(0.0, 99.0) - free).isApprox(kShareLeft * kShareLeft * touch, 1e-9));
  const double half = 1.0 - kSlope * (1.0 - kShareLeft);
  EXPECT_TRUE((varianceOfHand(0.0, 2.5) - free).isApprox(half * half * touch, 1e-9));
  EXPECT_TRUE(varianceOfHand(kInfinity, 4.0).isApprox(free, 1e-9)) << "nothing to refute";
}

}  // namespace joint_uncertainty_test
}  // namespace abstand::tracking
