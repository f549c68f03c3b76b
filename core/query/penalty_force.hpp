// Penalty force and torque of two bodies whose margins overlap.
#pragma once

#include "core/kernels/search_kernels.hpp"
#include "core/query/pair_query.hpp"

namespace abstand::query {

/// World frame, SI, as in PairResult.
struct PenaltyForce {
  Vector3d force_a{Vector3d::Zero()};   ///< N, on A; on B the opposite
  Vector3d torque_a{Vector3d::Zero()};  ///< N m, on A about A's centre of mass
  Vector3d torque_b{Vector3d::Zero()};  ///< N m, on B about B's centre of mass
  int contacts{0};                      ///< shell points within the margin
  double depth{0.0};                    ///< m, deepest penetration of the margins, >= 0
  /// Without contacts: leaf-order index of the shell point with the smallest estimate, if it is within
  /// `watch`; otherwise kNoPoint.
  std::uint32_t near_a{kernels::kNoPoint}, near_b{kernels::kNoPoint};
};

/// Converts a sum over P's points in F's field. `points_of_a`: P is A, otherwise B.
PenaltyForce penaltyOf(const kernels::ContactSum& sum, const PlacedBody& P, const PlacedBody& F,
                       const Transform& X_FP, double stiffness, bool points_of_a) noexcept;

/// Penalty force summed over the shell points, of the body that gives them (pointsFromA), within the margin
/// of the other: f = k a depth n [volume law], or k depth n [thesis eq. 2.2]. If there are none, over the
/// points of the other body, a vertex of which may lie in between. `watch`: m, beyond the margin. Both
/// structures must outlive the call. No allocation, no lock, no throw; depends on the arguments' values only.
PenaltyForce penaltyForce(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
                          kernels::PairScratch& scratch, double watch = 0.0) noexcept;

}  // namespace abstand::query
