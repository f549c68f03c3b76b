// The steps of one pair query. Internal to the engine.
#pragma once

#include <algorithm>
#include <optional>

#include "core/query/parts_apart.hpp"
#include "core/query/penalty_force.hpp"
#include "core/query/witness.hpp"

namespace abstand::query {

/// m; below this distance the contact normal is undefined.
inline constexpr double kTouching = 1e-6;
/// m; tolerance of distances up to kRelativeFrom.
inline constexpr double kAbsoluteTolerance = 1e-5;
/// m; witness points that have separated by more than this between two queries are a poor start.
inline constexpr double kJump = 0.01;

/// Tolerance (m) on the reported distance.
inline double tolerance(double distance, const PairOptions& options) {
  return distance > kRelativeFrom ? std::max(options.far_share * distance, kAbsoluteTolerance)
                                  : kAbsoluteTolerance;
}

/// State of the witness of a search; a query passes through these states in this order.
enum class WitnessState : std::uint8_t {
  kNone,         ///< no witness, or the bodies touched in the last query; continues with search()
  kTransported,  ///< witness of the last query, moved with the bodies; may be proven unchanged
  kMoved,        ///< improved along the surfaces by warmStart(); may be proven after each step
  kSettled       ///< local minimum found by convergeWitness(); search() looks for others
};

/// Result of the test for a separating plane of the convex hulls. kSkipped: not tested in this query.
enum class HullTest : std::uint8_t { kSkipped, kOverlap, kSeparated };

/// One pair query: branch and bound over the point-sphere tree of P in the field of F, in F's axes. Order:
/// warm start from the last query (warmStart), P's points in F's field (search), and, if the bodies may
/// touch, F's points in P's field (searchReversed). Lives within one call of queryPair(); no allocation, no
/// throw.
class PairSearch {
 public:
  /// All arguments must outlive this object.
  PairSearch(const PlacedBody& P, const PlacedBody& F, const PairOptions& options, PartAxes& part_axes)
      : P_(P), F_(F), X_FP_(F.X_WB.inverse() * P.X_WB), options_(options), part_axes_(part_axes) {}

  /// Tries to prove or locally refine the last witness points; true if the distance is proven.
  bool warmStart(const PairCache& memory, bool from_a);
  /// Finds the nearest shell point, then the nearest points on the exact surfaces near it.
  void search(PairCache& memory, kernels::PairScratch& scratch);
  /// True if contact is not excluded: the bodies may touch, or P may contain a component of F.
  bool mayTouch() const;
  /// Searches F's points in P's field: a vertex of F may lie between P's points, and a whole component of F
  /// inside P.
  void searchReversed(kernels::PairScratch& scratch);
  void store(PairCache& memory, bool from_a) const;

  /// The penalty force, if the searches have summed it. `from_a`: P is A.
  std::optional<PenaltyForce> penalty(bool from_a) const;
  const Witness& witness() const { return witness_; }
  /// Lower bound (m) of the true distance.
  double certified() const { return certified_; }

 private:
  Vector3d normalAt(std::uint32_t point) const { return X_FP_.linear() * P_.body.tree.normalAt(point); }
  bool refineLocally();
  bool trySupportPoints(const Vector3d& n_P, const Vector3d& n_F);
  bool tryPartSupportPoints();
  void tryPoints(const structure::ExtremePoint& of_points, const structure::ExtremePoint& of_field);
  kernels::NearestPoint nearestPoint(const kernels::NearestLimits& limits, kernels::PairScratch& scratch);
  double searchDeeper(kernels::PairScratch& scratch);
  double searchPoints(bool apart, kernels::PairScratch& scratch);
  bool isUniqueMinimum(const PairCache& memory) const;
  void findRunnerUp(PairCache& memory, kernels::PairScratch& scratch) const;

  void certify(double lower_bound) { certified_ = std::max(certified_, lower_bound); }
  /// Sets the lower bound (m) for all shell points; that for surface points is smaller by the covering
  /// radius.
  void setShellBound(double of_points) {
    of_points_ = of_points;
    certify(of_points - P_.body.shell.covering_radius);
  }
  double separation(const Vector3d& n);
  bool isKnown() const;
  bool isProven();
  bool provenByHulls(const Vector3d& n);
  bool haveParts() const { return P_.body.parts.size() > 1 || F_.body.parts.size() > 1; }
  bool provenByParts();
  bool partsApart(const Vector3d& n, FacingParts::Parts& between);

  const PlacedBody P_, F_;
  const Transform X_FP_;
  const PairOptions& options_;
  PartAxes& part_axes_;
  Witness witness_;
  double certified_{-kInfinity};
  double motion_{kInfinity};      ///< m; motion bound since the last search
  double of_points_{-kInfinity};  ///< m; lower bound for each of P's shell points
  std::uint32_t hint_points_{geometry::kNoHint}, hint_field_{geometry::kNoHint};  ///< from the last query
  double found_{-kInfinity};  ///< m; smallest distance of all points, up to the accuracy of the last search
  std::uint32_t hull_test_cooldown_{0};  ///< as in PairCache
  WitnessState state_{WitnessState::kNone};
  HullTest hull_test_{HullTest::kSkipped};
  bool by_parts_{false};                          ///< the last proof was by the hulls of the parts
  bool hulls_{false};                             ///< the witness distance is close to the separation of the
                                                  ///< hulls
  bool summing_{false};                           ///< forces will probably be needed
  std::optional<kernels::ContactSum> sum_;        ///< of P's points in F's field
  std::optional<kernels::ContactSum> other_sum_;  ///< of F's points in P's field
};

/// The distance part of queryPair(). True if the shell points may touch and the forces were not summed yet:
/// then forces are still zero and `depth` is that of the witness.
bool queryDistance(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
                   const QueryContext& context, PairResult& result) noexcept;
/// The remaining part of queryPair(): forces and contacts.
void addPenalty(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
                kernels::PairScratch& scratch, PairResult& result) noexcept;

}  // namespace abstand::query
