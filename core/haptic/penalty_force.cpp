// Penalty force and torque of two bodies whose margins overlap.
#include "core/haptic/penalty_force.hpp"

#include <utility>

namespace abstand {
namespace {

/// Of P's points in F's field; the force is on P, near_a of P.
PenaltyForce sumOver(const HapticStructure& P, const Transform& X_WP, const HapticStructure& F,
                     const Transform& X_WF, const PairOptions& options, PairScratch& scratch, double watch) {
  const Transform X_FP = X_WF.inverse() * X_WP;
  const ContactLimits limits{static_cast<float>(options.margin), static_cast<float>(options.margin + watch),
                             options.law == ForceLaw::kVolume};
  const ContactSum sum = searchKernels().contacts(P.treeView(X_FP), F.fieldView(), limits, scratch);
  if (sum.contacts == 0) return {.near_a = sum.nearest};
  const Vector3d force = options.stiffness * Vector3d(sum.force[0], sum.force[1], sum.force[2]);
  const Vector3d moment = options.stiffness * Vector3d(sum.moment[0], sum.moment[1], sum.moment[2]);
  return {X_WF.linear() * force, X_WF.linear() * (moment - (X_FP * P.com).cross(force)),
          -(X_WF.linear() * (moment - F.com.cross(force))), sum.contacts, static_cast<double>(sum.depth)};
}

}  // namespace

PenaltyForce penaltyForce(const HapticStructure& a, const Transform& X_WA, const HapticStructure& b,
                          const Transform& X_WB, const PairOptions& options, PairScratch& scratch,
                          double watch) noexcept {
  const bool from_a = pointsFromA(a, b);
  PenaltyForce none;
  for (const bool a_gives : {from_a, !from_a}) {
    PenaltyForce sum = a_gives ? sumOver(a, X_WA, b, X_WB, options, scratch, watch)
                               : sumOver(b, X_WB, a, X_WA, options, scratch, watch);
    if (sum.contacts == 0) {
      (a_gives ? none.near_a : none.near_b) = sum.near_a;
      continue;
    }
    if (!a_gives) {
      sum.force_a = -sum.force_a;
      std::swap(sum.torque_a, sum.torque_b);
    }
    return sum;
  }
  return none;
}

}  // namespace abstand
