// One query of a pair, in steps. Internal to the engine.
#pragma once

#include <algorithm>
#include <optional>

#include "core/query/parts_apart.hpp"
#include "core/query/penalty_force.hpp"
#include "core/query/witness.hpp"

namespace abstand::query {

/// m; below this distance the contact normal is undefined.
inline constexpr double kTouching = 1e-6;
/// m; by so much a distance up to kRelativeFrom may exceed the smallest.
inline constexpr double kAbsoluteTolerance = 1e-5;
/// m; points that have left each other by so much between two queries are a bad start.
inline constexpr double kJump = 0.01;

/// Tolerance (m) on the reported distance.
inline double tolerance(double distance, const PairOptions& options) {
  return distance > kRelativeFrom ? std::max(options.far_share * distance, kAbsoluteTolerance)
                                  : kAbsoluteTolerance;
}

/// What the witness of a search is; a query passes through these states from the top.
enum class WitnessState : std::uint8_t {
  kNone,         ///< none is known, or the bodies touched in the last query; goes on with search()
  kTransported,  ///< that of the last query, moved with the bodies; may be proven as it is
  kMoved,        ///< improved along the surfaces by warmStart(); may be proven after each step
  kSettled       ///< a nearest pair of its neighbourhood, by approachWitness(); search() looks for others
};

/// What is known of a plane between the convex hulls. kSkipped: not tested in this query.
enum class HullTest : std::uint8_t { kSkipped, kOverlap, kSeparated };

/// One query of a pair: branch and bound over the point-sphere tree of P in the field of F. Everything is in
/// F's axes. What the last query left is tried first (warmStart), then P's points are searched in F's field,
/// then, where the bodies may touch, F's points in P's field. Lives within one call of queryPair(); no
/// allocation, no throw.
class PairSearch {
 public:
  /// All must outlive this object.
  PairSearch(const PlacedBody& P, const PlacedBody& F, const PairOptions& options, PartAxes& part_axes)
      : P_(P), F_(F), X_FP_(F.X_WB.inverse() * P.X_WB), options_(options), part_axes_(part_axes) {}

  /// Where the nearest points were may be where they are: proven when no points can be much nearer.
  bool warmStart(const PairCache& memory, bool from_a);
  /// The nearest shell point, then the nearest points on the exact surfaces about it.
  void search(PairCache& memory, kernels::PairScratch& scratch);
  /// True when the bodies may touch, as far as is proven, or P may have swallowed a piece of F.
  bool mayTouch() const;
  /// What a search of F's points in P's field finds: a tip of F may lie between P's points, and a whole piece
  /// of it inside of P.
  void searchReversed(kernels::PairScratch& scratch);
  void store(PairCache& memory, bool from_a) const;

  /// The penalty force, when the searches have summed it on their way. `from_a`: P is A.
  std::optional<PenaltyForce> penalty(bool from_a) const;
  const Witness& witness() const { return witness_; }
  /// The true distance is never below it.
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
  /// No shell point is nearer than this; so no surface point by more than the covering radius.
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
  double motion_{kInfinity};      ///< m, since the last search
  double of_points_{-kInfinity};  ///< m, at least, of each of P's shell points
  std::uint32_t hint_points_{geometry::kNoHint}, hint_field_{geometry::kNoHint};  ///< of the last query
  double found_{-kInfinity};  ///< the best of all points, as far as the last search could tell
  std::uint32_t idle_{0};     ///< as in PairCache
  WitnessState state_{WitnessState::kNone};
  HullTest hull_test_{HullTest::kSkipped};
  bool by_parts_{false};                          ///< the hulls of their parts told last
  bool hulls_{false};                             ///< the witness is about as near as the hulls
  bool summing_{false};                           ///< forces are likely to be wanted
  std::optional<kernels::ContactSum> sum_;        ///< of P's points in F's field
  std::optional<kernels::ContactSum> other_sum_;  ///< of F's points in P's
};

/// The part of queryPair() that tells the distance. True when the shells' points may touch and it did not
/// come by the penalty force: then forces are still zero and `depth` is that of the witness.
bool queryDistance(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
                   const QueryContext& context, PairResult& result) noexcept;
/// The rest.
void addPenalty(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
                kernels::PairScratch& scratch, PairResult& result) noexcept;

}  // namespace abstand::query
