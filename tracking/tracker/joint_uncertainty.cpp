#include "tracking/tracker/joint_uncertainty.hpp"

#include <algorithm>
#include <cmath>

#include "humanmodel/joint_covariance.hpp"

namespace abstand::tracking {
namespace {

constexpr double kDeviationsPerResidual = 3.0;  // times the residual: standard deviation of a point

// m: a limb nearer than this to something that looks alike may be a part of it; the first is the distance at
// which the term begins, at the second it is whole.
constexpr double kTouchFrom = 0.04, kTouchWhole = 0.0;

// Points that a segment alone explains: from the first on they begin to show that it is not mistaken for what
// it touches or what covers it, from the second on by the shares below of both terms. Without these terms,
// 0.981 of the joints of `sit to stand` were within reach, with these shares 0.99.
constexpr double kLittleSupport = 1.0, kWholeSupport = 4.0;
constexpr double kTouchRefuted = 0.7, kHiddenRefuted = 0.3;

// rad, angle of a thigh to the trunk: below the first, they begin to hide each other; at the second, the
// thigh lies on the trunk. m: error of the hips and of the knee then. The back of a person who bends so is
// round, that of the model is straight.
constexpr double kFoldFrom = 1.05, kFoldWhole = 0.35, kFolded = 0.06;

// Shares of the points: at the first, the doubt begins; at the second, it is whole.
constexpr double kExplainedWell = 0.97, kExplainedBadly = 0.95;
// m, likewise. A skin body close to the model, in full view, has 0.010 to 0.011; the captures of quick
// motions and real people 0.013 to 0.016.
constexpr double kResidualSmall = 0.0100, kResidualLarge = 0.0125;

/// 0 to 1, how much a thigh is folded onto the trunk.
double foldOf(const BodyRig& rig, const RigPlacement& X_WS, RigSegment thigh) {
  const Vector3d up = X_WS[index(RigSegment::kChest)].linear().col(2);
  const Vector3d down = X_WS[index(thigh)].linear() * rig[thigh].along;
  const double angle = std::acos(std::clamp(up.dot(down), -1.0, 1.0));
  return std::clamp((kFoldFrom - angle) / (kFoldFrom - kFoldWhole), 0.0, 1.0);
}

/// Likewise for the joints of a segment: the pelvis and the thighs.
double foldAt(const std::array<double, 2>& fold, RigSegment s) {
  if (s == RigSegment::kThighLeft) return fold[0];
  if (s == RigSegment::kThighRight) return fold[1];
  return s == RigSegment::kPelvis ? std::max(fold[0], fold[1]) : 0.0;
}

/// For each joint: constant terms along the axes of its segment (x forward, y left, z along a limb or the
/// trunk, when standing), the share of them that a good fit leaves, and terms for an invisible segment and
/// for one that touches another; m.
struct Terms {
  double forward, left, along, good{1.0}, hidden{0.0}, touch{0.0};
};

Terms termsOf(humanmodel::Joint joint) {
  switch (joint) {
    using enum humanmodel::Joint;
    case kPelvis:
    case kSpine:
    case kThorax:
      return {0.035, 0.025, 0.050};
    case kNeck:
      return {0.032, 0.022, 0.047, 0.7};
    case kHead:
      return {0.020, 0.014, 0.027, 0.7, 0.10};
    case kHeadTop:
      return {0.037, 0.020, 0.037, 0.7, 0.20};
    case kShoulderLeft:
    case kShoulderRight:
      return {0.040, 0.040, 0.040, 0.6, 0.08};
    case kElbowLeft:
    case kElbowRight:
      return {0.032, 0.032, 0.032, 0.5, 0.12};
    case kWristLeft:
    case kWristRight:
      return {0.027, 0.027, 0.027, 0.9, 0.25, 0.14};
    case kHandLeft:
    case kHandRight:
      return {0.030, 0.030, 0.030, 0.5, 0.15, 0.28};
    case kHipLeft:
    case kHipRight:
      return {0.030, 0.027, 0.030, 0.6, 0.06};
    case kKneeLeft:
    case kKneeRight:
      return {0.032, 0.026, 0.032, 0.75, 0.03};
    case kAnkleLeft:
    case kAnkleRight:
      return {0.036, 0.023, 0.039, 0.6, 0.25, 0.10};
    case kToeLeft:
    case kToeRight:
      return {0.040, 0.040, 0.040, 0.65, 0.15};
    case kCount:
      break;
  }
  return {0.0, 0.0, 0.0};
}

}  // namespace

double doubtOfExplained(double explained) {
  return std::clamp((kExplainedWell - explained) / (kExplainedWell - kExplainedBadly), 0.0, 1.0);
}

double doubtOf(const DepthMisfit& misfit) {
  const double of_residual =
      std::clamp((misfit.residual - kResidualSmall) / (kResidualLarge - kResidualSmall), 0.0, 1.0);
  return std::max(of_residual, doubtOfExplained(misfit.explained));
}

Matrix3d rounded(const Matrix3d& covariance, double doubt) {
  if (doubt <= 0.0 || !covariance.allFinite()) return covariance;
  const double largest = humanmodel::worstDeviation(covariance);
  return (1.0 - doubt) * covariance + Matrix3d(Vector3d::Constant(doubt * largest * largest).asDiagonal());
}

JointCovariances trackedCovariances(const BodyRig& rig, const BodySolver& problem, const FitState& state) {
  JointCovariances covariance = jointCovariances(rig, problem, problem.information());
  const double of_fit = kDeviationsPerResidual * state.residual;
  const double variance = of_fit * of_fit;
  const std::array<double, 2> fold{foldOf(rig, problem.placement(), RigSegment::kThighLeft),
                                   foldOf(rig, problem.placement(), RigSegment::kThighRight)};
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const std::size_t s = index(rig.carrier[j]);
    const double folded = kFolded * foldAt(fold, rig.carrier[j]);
    const double supported =
        std::clamp((state.support[s] - kLittleSupport) / (kWholeSupport - kLittleSupport), 0.0, 1.0);
    const double touch = (1.0 - kTouchRefuted * supported) *
                         std::clamp((kTouchFrom - state.gap[s]) / (kTouchFrom - kTouchWhole), 0.0, 1.0);
    const double covered = 1.0 - state.visible[s];
    const double hidden = (1.0 - kHiddenRefuted * supported) * covered * std::sqrt(covered);
    const Terms terms = termsOf(static_cast<humanmodel::Joint>(j));
    const double all_around = std::hypot(hidden * terms.hidden, touch * terms.touch, folded);
    const double share = terms.good + (1.0 - terms.good) * state.doubt;
    const Vector3d shape = share * Vector3d(terms.forward, terms.left, terms.along);
    const Matrix3d R_WS = problem.placement()[s].linear();
    covariance[j] = variance * covariance[j] + R_WS * shape.cwiseAbs2().asDiagonal() * R_WS.transpose() +
                    Matrix3d(Vector3d::Constant(all_around * all_around).asDiagonal());
  }
  return covariance;
}

}  // namespace abstand::tracking
