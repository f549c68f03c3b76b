#include "humanmodel/joint_covariance.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "humanmodel/part_uncertainty.hpp"

namespace abstand::humanmodel {
namespace {

/// Share by which the largest standard deviation may differ from the spread: rounding in files.
constexpr double kSameSpread = 1e-6;
/// Share of the trace that is added to matrices before they are factorised: flat ellipsoids are allowed.
constexpr double kFlat = 1e-12;

Matrix3d isotropic(double variance) { return Vector3d::Constant(variance).asDiagonal(); }

}  // namespace

double worstDeviation(const Matrix3d& covariance) {
  if (!covariance.allFinite()) return kInfinity;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, axes.eigenvalues()[2]));
}

Matrix3d covarianceOf(const SkeletonFrame& frame, Joint joint) {
  const auto j = static_cast<std::size_t>(joint);
  const Matrix3d& stated = frame.covariance[j];
  const double spread = frame.spread[j];
  if (stated.isZero(0.0) || !stated.allFinite() || stated != stated.transpose())
    return isotropic(spread * spread);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(stated, Eigen::EigenvaluesOnly);
  const double least = axes.eigenvalues()[0], largest = axes.eigenvalues()[2];
  const bool is_valid = least >= -kFlat * largest && largest > 0.0 &&
                        std::abs(std::sqrt(largest) - spread) <= kSameSpread * spread;
  return is_valid ? stated : isotropic(spread * spread);
}

void setCovariance(SkeletonFrame& frame, Joint joint, const Matrix3d& covariance) {
  const auto j = static_cast<std::size_t>(joint);
  frame.spread[j] = worstDeviation(covariance);
  if (frame.covariance.isStated()) frame.covariance[j] = Matrix3d::Zero();
  if (std::isfinite(frame.spread[j])) frame.covariance[j] = 0.5 * (covariance + covariance.transpose());
}

void addSpread(SkeletonFrame& frame, Joint joint, double sigma) {
  if (sigma == 0.0) return;
  setCovariance(frame, joint, covarianceOf(frame, joint) + isotropic(sigma * sigma));
}

Matrix3d sumEnclosing(const Matrix3d& a, const Matrix3d& b) {
  if (!a.allFinite() || !b.allFinite()) return isotropic(kInfinity);
  const double of_a = a.trace(), of_b = b.trace();
  if (!(of_a > 0.0)) return b;
  if (!(of_b > 0.0)) return a;
  const double k = std::sqrt(of_a / of_b);
  return (1.0 + 1.0 / k) * a + (1.0 + k) * b;
}

Matrix3d sumWithOffset(const Matrix3d& a, const Vector3d& offset) {
  const Vector3d d = offset / kSpreadQuantile;
  return sumEnclosing(a, d * d.transpose());
}

void addRadius(SkeletonFrame& frame, Joint joint, double radius) {
  const double spread = radius / kSpreadQuantile;
  if (radius != 0.0)
    setCovariance(frame, joint, sumEnclosing(covarianceOf(frame, joint), isotropic(spread * spread)));
}

Matrix3d enclosingCovariance(const Matrix3d& a, const Matrix3d& b) {
  if (!a.allFinite() || !b.allFinite()) return isotropic(kInfinity);
  if (a == b || b.isZero(0.0)) return a;
  if (a.isZero(0.0)) return b;
  // In axes in which a is the identity, the part of b beyond it is cut off and added.
  const Matrix3d base = a + isotropic(kFlat * (a.trace() + b.trace()));
  const Eigen::LLT<Matrix3d> llt(base);
  const Matrix3d half = llt.matrixL().solve(b);
  const Matrix3d whitened = llt.matrixL().solve(half.transpose());
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(0.5 * (whitened + whitened.transpose()));
  const Vector3d beyond = (axes.eigenvalues().array() - 1.0).max(0.0);
  const Matrix3d root = llt.matrixL() * axes.eigenvectors();
  return base + root * beyond.asDiagonal() * root.transpose();
}

double reachAlong(const Matrix3d& covariance, const Vector3d& d) {
  if (!covariance.allFinite()) return kInfinity;
  return kSpreadQuantile * std::sqrt(std::max(0.0, d.dot(covariance * d)));
}

double radiusToward(const Matrix3d& covariance, const Vector3d& d) {
  if (!covariance.allFinite()) return kInfinity;
  const Matrix3d base = covariance + isotropic(kFlat * covariance.trace());
  const Eigen::LLT<Matrix3d> llt(base);
  if (llt.info() != Eigen::Success) return 0.0;
  return kSpreadQuantile / Vector3d(llt.matrixL().solve(d)).norm();
}

}  // namespace abstand::humanmodel
