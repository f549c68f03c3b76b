// Penalty force and torque of two bodies whose margins overlap.
#include "core/query/penalty_force.hpp"

#include <utility>

namespace abstand::query {
namespace {

/// Sum over P's points in F's field.
PenaltyForce sumOver(const PlacedBody& P, const PlacedBody& F, bool points_of_a, const PairOptions& options,
                     kernels::PairScratch& scratch, double watch) {
  const Transform X_FP = F.X_WB.inverse() * P.X_WB;
  const kernels::ContactLimits limits{static_cast<float>(options.margin),
                                      static_cast<float>(options.margin + watch),
                                      options.law == ForceLaw::kVolume};
  const kernels::ContactSum sum =
      kernels::searchKernels().contacts(P.body.treeView(X_FP), F.body.fieldView(), limits, scratch);
  return penaltyOf(sum, P, F, X_FP, options.stiffness, points_of_a);
}

}  // namespace

PenaltyForce penaltyOf(const kernels::ContactSum& sum, const PlacedBody& P, const PlacedBody& F,
                       const Transform& X_FP, double stiffness, bool points_of_a) noexcept {
  PenaltyForce result;
  (points_of_a ? result.near_a : result.near_b) = sum.nearest;
  if (sum.contacts == 0) return result;
  const Vector3d force = stiffness * Vector3d(sum.force[0], sum.force[1], sum.force[2]);
  const Vector3d moment = stiffness * Vector3d(sum.moment[0], sum.moment[1], sum.moment[2]);
  result.contacts = sum.contacts;
  result.depth = static_cast<double>(sum.depth);
  result.force_a = F.X_WB.linear() * force;
  result.torque_a = F.X_WB.linear() * (moment - (X_FP * P.body.com).cross(force));
  result.torque_b = -(F.X_WB.linear() * (moment - F.body.com.cross(force)));
  if (!points_of_a) {
    result.force_a = -result.force_a;
    std::swap(result.torque_a, result.torque_b);
  }
  return result;
}

PenaltyForce penaltyForce(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
                          kernels::PairScratch& scratch, double watch) noexcept {
  const bool from_a = pointsFromA(a.body, b.body);
  PenaltyForce none;
  for (const bool a_gives : {from_a, !from_a}) {
    const PenaltyForce sum = a_gives ? sumOver(a, b, true, options, scratch, watch)
                                     : sumOver(b, a, false, options, scratch, watch);
    if (sum.contacts > 0) return sum;
    (a_gives ? none.near_a : none.near_b) = a_gives ? sum.near_a : sum.near_b;
  }
  return none;
}

}  // namespace abstand::query
