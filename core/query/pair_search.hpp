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
/// m; by so much a distance up to kFarFrom may exceed the smallest.
inline constexpr double kNearEnough = 1e-5;
/// m; points that have left each other by so much between two queries are a bad start.
inline constexpr double kJump = 0.01;

/// Tolerance (m) on the reported distance.
inline double allowed(double distance, const PairOptions& options) {
  return distance > kFarFrom ? std::max(options.far_share * distance, kNearEnough) : kNearEnough;
}

/// P gives the points, F the field; everything is in F's axes. What is remembered is tried first, then P's
/// points are searched in F's field, then, where the bodies may touch, the other way round. Lives within one
/// call of queryPair(); no allocation, no throw.
class PairSearch {
 public:
  /// All must outlive this object.
  PairSearch(const structure::HapticStructure& P, const Transform& X_WP, const structure::HapticStructure& F,
             const Transform& X_WF, const PairOptions& options, PartAxes& part_axes)
      : P_(P),
        F_(F),
        X_WP_(X_WP),
        X_WF_(X_WF),
        X_FP_(X_WF.inverse() * X_WP),
        options_(options),
        part_axes_(part_axes) {}

  /// Where the nearest points were may be where they are: proven when no points can be much nearer.
  bool remember(const PairCache& memory, bool from_a);
  /// The nearest shell point, then the nearest points on the exact surfaces about it.
  void search(PairCache& memory, kernels::PairScratch& scratch);
  /// True when the bodies may touch, as far as is proven, or P may have swallowed a piece of F.
  bool mayTouch() const;
  /// What a search of F's points in P's field finds: a tip of F may lie between P's points, and a whole piece
  /// of it inside of P.
  void searchReversed(kernels::PairScratch& scratch);
  void keep(PairCache& memory, bool from_a) const;

  /// The penalty force, when the searches have summed it on their way. `from_a`: P is A.
  std::optional<PenaltyForce> penalty(bool from_a) const;
  const Witness& witness() const { return witness_; }
  /// The true distance is never below it.
  double certified() const { return certified_; }

 private:
  Vector3d normalAt(std::uint32_t point) const { return X_FP_.linear() * P_.tree.normalAt(point); }
  bool refineLocally();
  bool trySupportPoints(const Vector3d& n_P, const Vector3d& n_F);
  bool tryPartSupportPoints();
  void take(const structure::ExtremePoint& of_points, const structure::ExtremePoint& of_field);
  kernels::NearestPoint nearestPoint(const kernels::NearestLimits& limits, kernels::PairScratch& scratch);
  double searchDeeper(kernels::PairScratch& scratch);
  double searchPoints(bool apart, kernels::PairScratch& scratch);
  bool isUniqueMinimum(const PairCache& memory) const;
  void findRunnerUp(PairCache& memory, kernels::PairScratch& scratch) const;

  void certify(double lower_bound) { certified_ = std::max(certified_, lower_bound); }
  /// No shell point is nearer than this; so no surface point by more than the covering radius.
  void searched(double of_points) {
    of_points_ = of_points;
    certify(of_points - P_.shell.covering_radius);
  }
  double separation(const Vector3d& n);
  bool isKnown() const;
  bool isProven();
  bool provenByHulls(const Vector3d& n);
  bool haveParts() const { return P_.parts.size() > 1 || F_.parts.size() > 1; }
  bool provenByParts();
  bool partsApart(const Vector3d& n, FacingParts::Parts& between);

  const structure::HapticStructure& P_;
  const structure::HapticStructure& F_;
  const Transform& X_WP_;
  const Transform& X_WF_;
  const Transform X_FP_;
  const PairOptions& options_;
  PartAxes& part_axes_;
  Witness witness_;
  double certified_{-kInfinity};
  double motion_{kInfinity};      ///< m, since the last search
  double of_points_{-kInfinity};  ///< m, at least, of each of P's shell points
  std::uint32_t hint_points_{geometry::kNoHint}, hint_field_{geometry::kNoHint};  ///< of the last query
  double found_{-kInfinity};                ///< the best of all points, as far as the last search could tell
  std::uint32_t idle_{0};                   ///< as in PairCache
  bool asked_{false};                       ///< what the hulls prove
  bool by_parts_{false};                    ///< the hulls of their parts told last
  bool separated_{false};                   ///< a plane parts the hulls
  bool hulls_{false};                       ///< the witness is about as near as the hulls
  bool remembered_{false};                  ///< it is the one of the last query
  bool summing_{false};                     ///< forces are likely to be wanted
  std::optional<kernels::ContactSum> sum_;  ///< of P's points in F's field
  std::optional<kernels::ContactSum> other_sum_;  ///< of F's points in P's
  bool settled_{false};                           ///< the witness is a nearest pair of its neighbourhood
};

/// The part of queryPair() that tells the distance. True when the shells' points may touch and it did not
/// come by the penalty force: then forces are still zero and `depth` is that of the witness.
bool queryDistance(const structure::HapticStructure& a, const Transform& X_WA,
                   const structure::HapticStructure& b, const Transform& X_WB, const PairOptions& options,
                   PairMemory& memory, kernels::PairScratch& scratch, PairResult& result) noexcept;
/// The rest.
void addPenalty(const structure::HapticStructure& a, const Transform& X_WA,
                const structure::HapticStructure& b, const Transform& X_WB, const PairOptions& options,
                kernels::PairScratch& scratch, PairResult& result) noexcept;

}  // namespace abstand::query
