// Ellipsoids of joint errors: closed forms, and laws on random ones.
#include "humanmodel/joint_covariance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <vector>

#include "core/math/random.hpp"
#include "humanmodel/part_uncertainty.hpp"
#include "humanmodel/poser.hpp"

namespace abstand::humanmodel {
namespace joint_covariance_test {

constexpr double kRounding = 1e-12;   // of numbers near 1
constexpr double kFactorized = 1e-9;  // the same after factorising matrices of a condition of 1e4
constexpr int kCases = 500;

Matrix3d diagonal(double x, double y, double z) { return Vector3d(x, y, z).asDiagonal(); }

/// Standard deviations (m) from 0.01 to 1 along random axes.
Matrix3d randomCovariance(Random& random) {
  const Matrix3d R = random.rotation();
  const auto squared = [&] { return std::pow(10.0, random.between(-4.0, 0.0)); };
  const double x = squared(), y = squared();
  return R * diagonal(x, y, squared()) * R.transpose();
}

double leastEigenvalue(const Matrix3d& m) {
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(m).eigenvalues()[0];
}

/// Standard normal, by the polar method (Marsaglia).
Vector3d normal(Random& random) {
  Vector3d out;
  for (double& v : out) {
    double a = 0.0, s = 0.0;
    do {
      a = random.between(-1.0, 1.0);
      const double b = random.between(-1.0, 1.0);
      s = a * a + b * b;
    } while (s >= 1.0 || s == 0.0);
    v = a * std::sqrt(-2.0 * std::log(s) / s);
  }
  return out;
}

TEST(JointCovariance, ReachAndRadiusOfAnAlignedEllipsoid) {
  const Matrix3d C = diagonal(0.04, 0.01, 0.0025);
  EXPECT_NEAR(reachAlong(C, Vector3d::UnitX()), kSpreadQuantile * 0.2, kRounding);
  EXPECT_NEAR(reachAlong(C, Vector3d::UnitZ()), kSpreadQuantile * 0.05, kRounding);
  EXPECT_NEAR(radiusToward(C, Vector3d::UnitX()), kSpreadQuantile * 0.2, kFactorized);
  // Between the axes the surface is nearer than the tangent plane.
  const Vector3d d = Vector3d(1.0, 1.0, 0.0).normalized();
  EXPECT_NEAR(reachAlong(C, d), kSpreadQuantile * std::sqrt(0.5 * (0.04 + 0.01)), kRounding);
  EXPECT_NEAR(radiusToward(C, d), kSpreadQuantile / std::sqrt(0.5 * (25.0 + 100.0)), kFactorized);
  EXPECT_EQ(worstDeviation(C), 0.2);
  EXPECT_EQ(radiusToward(diagonal(0.01, 0.01, kInfinity), d), kInfinity);
}

TEST(JointCovariance, EllipsoidHolds99PercentOfNormalErrors) {
  constexpr int kErrors = 40000;
  // Three standard deviations of the share.
  constexpr double kSampling = 3.0 * 0.0005;
  // Median of the chi distribution with three degrees of freedom; the figure of docs/tracking-uncertainty.md.
  constexpr double kMedianRatio = kSpreadQuantile / 1.5382, kMedianSampling = 0.03;
  Random random(1, 0);
  const Matrix3d C = randomCovariance(random);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(C);
  int within = 0;
  std::vector<double> ratio;
  for (int i = 0; i < kErrors; ++i) {
    const Vector3d e = axes.eigenvectors() * axes.eigenvalues().cwiseSqrt().cwiseProduct(normal(random));
    ratio.push_back(radiusToward(C, e.normalized()) / e.norm());
    within += ratio.back() >= 1.0;
  }
  EXPECT_NEAR(static_cast<double>(within) / kErrors, 0.99, kSampling);
  std::nth_element(ratio.begin(), ratio.begin() + kErrors / 2, ratio.end());
  EXPECT_NEAR(ratio[kErrors / 2], kMedianRatio, kMedianSampling);
}

TEST(JointCovariance, EnclosingOneEnclosesBoth) {
  for (std::uint64_t i = 0; i < kCases; ++i) {
    Random random(2, i);
    const Matrix3d a = randomCovariance(random), b = randomCovariance(random);
    const Matrix3d c = enclosingCovariance(a, b);
    const double tolerance = kFactorized * c.trace();
    EXPECT_GE(leastEigenvalue(c - a), -tolerance);
    EXPECT_GE(leastEigenvalue(c - b), -tolerance);
  }
  const Matrix3d small = diagonal(0.01, 0.02, 0.03), large = 2.0 * small;
  EXPECT_TRUE(enclosingCovariance(small, large).isApprox(large, kFactorized)) << "not larger than needed";
  EXPECT_TRUE(enclosingCovariance(large, small).isApprox(large, kFactorized));
  EXPECT_EQ(enclosingCovariance(small, diagonal(kInfinity, 1.0, 1.0))(1, 1), kInfinity);
}

TEST(JointCovariance, SumEnclosesEverySumOfTwoPoints) {
  for (std::uint64_t i = 0; i < kCases; ++i) {
    Random random(3, i);
    const Vector3d offset = random.inCube(1.0);
    const Matrix3d a = randomCovariance(random), b = randomCovariance(random),
                   line = offset * offset.transpose();
    for (int k = 0; k < 10; ++k) {
      // The support function of a Minkowski sum is the sum of the support functions.
      const Vector3d d = random.direction();
      EXPECT_GE(reachAlong(sumEnclosing(a, b), d) + kFactorized, reachAlong(a, d) + reachAlong(b, d));
      EXPECT_GE(reachAlong(sumEnclosing(a, line), d) + kFactorized,
                reachAlong(a, d) + kSpreadQuantile * std::abs(offset.dot(d)));
    }
  }
  const Matrix3d a = diagonal(0.04, 0.04, 0.04), b = diagonal(0.09, 0.09, 0.09), none = Matrix3d::Zero();
  EXPECT_NEAR(worstDeviation(sumEnclosing(a, b)), 0.2 + 0.3, kFactorized) << "not larger than needed";
  EXPECT_EQ(sumEnclosing(a, none), a);
  const Vector3d offset(0.3, 0.0, 0.4);
  EXPECT_GE(reachAlong(sumWithOffset(a, offset), offset.normalized()) + kFactorized,
            reachAlong(a, offset.normalized()) + offset.norm());
  EXPECT_EQ(sumWithOffset(a, Vector3d::Zero()), a);
  EXPECT_EQ(sumEnclosing(none, b), b);
  EXPECT_EQ(sumEnclosing(a, diagonal(kInfinity, 1.0, 1.0))(2, 2), kInfinity);
}

TEST(JointCovariance, SpreadAloneHoldsInAllDirections) {
  SkeletonFrame frame;
  frame.spread[0] = 0.3;
  EXPECT_TRUE(covarianceOf(frame, Joint::kPelvis).isApprox(diagonal(0.09, 0.09, 0.09), kRounding));
  setCovariance(frame, Joint::kPelvis, diagonal(0.04, 0.01, 0.0025));
  EXPECT_EQ(frame.spread[0], 0.2);
  EXPECT_EQ(covarianceOf(frame, Joint::kPelvis), diagonal(0.04, 0.01, 0.0025));
  frame.spread[0] = 0.3;  // changed by something that does not know the covariance
  EXPECT_TRUE(covarianceOf(frame, Joint::kPelvis).isApprox(diagonal(0.09, 0.09, 0.09), kRounding));
  frame.spread[0] = 0.2;
  frame.covariance[0](1, 1) = -0.01;
  EXPECT_TRUE(covarianceOf(frame, Joint::kPelvis).isApprox(diagonal(0.04, 0.04, 0.04), kRounding));
  frame.covariance[0](1, 1) = kNaN;
  EXPECT_TRUE(covarianceOf(frame, Joint::kPelvis).isApprox(diagonal(0.04, 0.04, 0.04), kRounding));
  setCovariance(frame, Joint::kPelvis, diagonal(kInfinity, 1.0, 1.0));
  EXPECT_EQ(frame.spread[0], kInfinity);
  EXPECT_EQ(covarianceOf(frame, Joint::kPelvis)(2, 2), kInfinity);
}

TEST(JointCovariance, IndependentErrorsAdd) {
  SkeletonFrame frame;
  setCovariance(frame, Joint::kNeck, diagonal(0.04, 0.01, 0.0025));
  addSpread(frame, Joint::kNeck, 0.1);
  EXPECT_TRUE(covarianceOf(frame, Joint::kNeck).isApprox(diagonal(0.05, 0.02, 0.0125), kRounding));
  addRadius(frame, Joint::kNeck, 0.5);
  EXPECT_GE(reachAlong(covarianceOf(frame, Joint::kNeck), Vector3d::UnitX()) + kFactorized,
            kSpreadQuantile * std::sqrt(0.05) + 0.5);
}

/// A forearm whose wrist is uncertain along x and whose elbow is uncertain along y.
TEST(PartCovariance, EnclosesThoseOfTheJoints) {
  const HumanModel model = makeHuman({});
  SkeletonFrame frame = model.rest;
  setCovariance(frame, Joint::kWristLeft, diagonal(0.01, 0.0001, 0.0001));
  setCovariance(frame, Joint::kElbowLeft, diagonal(0.0001, 0.0025, 0.0001));
  HumanPose pose;
  Poser(model).pose(frame, pose);
  const auto forearm = index(BodyPart::kForearmLeft), thigh = index(BodyPart::kThighLeft);
  EXPECT_EQ(pose.spread[forearm], 0.1);
  EXPECT_TRUE(pose.covariance[thigh].isZero(0.0));
  const Matrix3d& C = pose.covariance[forearm];
  for (const Joint j : {Joint::kWristLeft, Joint::kElbowLeft})
    EXPECT_GE(leastEigenvalue(C - covarianceOf(frame, j)), -kFactorized);
  // The elbow's 0.05 across and the wrist's 0.1, which turns the forearm: its surface moves along it, too.
  EXPECT_GE(reachAlong(C, Vector3d::UnitZ()), kSpreadQuantile * 0.01);
  EXPECT_LT(reachAlong(C, Vector3d::UnitZ()), 0.5 * kSpreadQuantile * 0.1);
  EXPECT_LT(reachAlong(C, Vector3d::UnitY()), 0.6 * kSpreadQuantile * 0.1);
  const auto hand = index(BodyPart::kHandLeft);
  EXPECT_GE(leastEigenvalue(pose.covariance[hand] - C), -kFactorized) << "the hand hangs on the forearm";
}

}  // namespace joint_covariance_test
}  // namespace abstand::humanmodel
