#include "tracking/tracker/joint_uncertainty.hpp"

#include <algorithm>
#include <cmath>

#include "tracking/body/joint_spread.hpp"

namespace abstand::tracking {
namespace {

constexpr double kDeviationsPerResidual = 3.0;  // times the residual: standard deviation of a point

/// For each joint: constant term, and term for an invisible segment; m.
struct Terms {
  double shape, hidden;
};

Terms termsOf(humanmodel::Joint joint) {
  switch (joint) {
    using enum humanmodel::Joint;
    case kPelvis:
    case kSpine:
    case kThorax:
      return {0.050, 0.0};
    case kNeck:
      return {0.047, 0.0};
    case kHead:
      return {0.027, 0.0};
    case kHeadTop:
      return {0.037, 0.0};
    case kShoulderLeft:
    case kShoulderRight:
      return {0.040, 0.0};
    case kElbowLeft:
    case kElbowRight:
      return {0.032, 0.10};
    case kWristLeft:
    case kWristRight:
      return {0.027, 0.20};
    case kHandLeft:
    case kHandRight:
      return {0.030, 0.20};
    case kHipLeft:
    case kHipRight:
      return {0.030, 0.0};
    case kKneeLeft:
    case kKneeRight:
      return {0.027, 0.20};
    case kAnkleLeft:
    case kAnkleRight:
      return {0.027, 0.10};
    case kToeLeft:
    case kToeRight:
      return {0.038, 0.10};
    case kCount:
      break;
  }
  return {0.0, 0.0};
}

bool isEnd(RigSegment s) {
  using enum RigSegment;
  return s == kHandLeft || s == kHandRight || s == kFootLeft || s == kFootRight;
}

bool isThigh(RigSegment s) { return s == RigSegment::kThighLeft || s == RigSegment::kThighRight; }

}  // namespace

std::array<double, humanmodel::kJointCount> trackedSpreads(const BodyRig& rig, const BodySolver& problem,
                                                           double residual,
                                                           const std::array<double, kRigSegments>& visible) {
  std::array<double, humanmodel::kJointCount> spread = jointSpreads(rig, problem, problem.information());
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const RigSegment s = rig.carrier[j];
    double share = visible[index(s)];
    if (isEnd(s)) share = std::min(share, visible[index(rig[s].parent)]);
    if (isThigh(s)) share = std::max(share, visible[index(s) + 2]);
    const Terms terms = termsOf(static_cast<humanmodel::Joint>(j));
    spread[j] = std::hypot(terms.shape, kDeviationsPerResidual * residual * spread[j], (1.0 - share) * terms.hidden);
  }
  return spread;
}

}  // namespace abstand::tracking
