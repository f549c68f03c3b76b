// Pair query: steps that search the shell points.
#include "core/query/pair_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/kernels/search_kernels.hpp"

namespace abstand::query {
namespace {

// Shell points are transformed in float: error below 0.2 um for bodies within some metres.
constexpr double kFloatRounding = 1e-6;
// Relative tolerance of the search: a tighter bound than needed stays useful after the bodies have moved.
constexpr double kSearchTolerance = 0.0025;
// Relative error of the smallest distance found by a search beyond kRelativeFrom, where the field is coarse.
constexpr double kFarFieldError = 0.005;
// In spacings: a shell point this near to the witness and not nearer to the other body converges to the same
// minimum.
constexpr double kSameStart = 2.0;
// Share of the distance: a witness this close to the proven bound is not improved further.
constexpr double kAcceptedExcess = 0.002;
// m; kMaxSearchMotion: largest motion between two searches for which the runner-up search pays off.
// kRunnerUpRange: range beyond the witness distance in which it looks for the runner-up.
constexpr double kMaxSearchMotion = 0.001, kRunnerUpRange = 0.004;
// In spacings: largest depth that a local search can gain from a point.
constexpr double kMaxDepthGain = 0.1;
// The same for bodies that barely touch: where edges cross, both may lie between points.
constexpr double kMaxCrossingGain = 0.5;
// Spacings; points this close to the witness converge to the same minimum.
constexpr double kSameMinimumRadius = 6.0;
// Share of the tolerance: a point whose estimate is nearer by more than this gets a local search.
constexpr double kRefineShare = 0.25;
// Queries without hull test after the hulls of near bodies were found to overlap.
constexpr std::uint32_t kHullTestCooldown = 8;

}  // namespace

void PairSearch::search(PairCache& memory, kernels::PairScratch& scratch) {
  summing_ = memory.touching;
  found_ = kInfinity;
  const double lower_bound = searchPoints(witness_.distance > kTouching, scratch) - kFloatRounding;
  memory.X_FP = X_FP_;
  memory.searched = lower_bound;
  const double loss = witness_.distance > kRelativeFrom ? kFarFieldError * witness_.distance : 0.0;
  memory.found = found_ = std::min(found_, witness_.distance - loss);
  setShellBound(lower_bound);
  isProven();
  memory.runner_up_distance = -kInfinity;
  if (motion_ < kMaxSearchMotion && certified_ > 0.0 && witness_.distance < kRelativeFrom)
    findRunnerUp(memory, scratch);
}

bool PairSearch::mayTouch() const {
  if (certified_ <= 0.0) return true;
  if (F_.body.pieces.empty() || hull_test_ == HullTest::kSeparated) return false;
  const Transform X_PF = X_FP_.inverse();
  return std::any_of(F_.body.pieces.begin(), F_.body.pieces.end(), [&](const Vector3d& piece) {
    const Vector3d p = X_PF * piece;
    return (p - P_.body.bounding_sphere.centre).norm() < P_.body.bounding_sphere.radius &&
           P_.body.surface->inside(p);
  });
}

void PairSearch::searchReversed(kernels::PairScratch& scratch) {
  PartAxes none;
  PairSearch other(F_, P_, options_, none);
  // The forces are those of P's points, if there are any.
  other.summing_ = sum_ && sum_->contacts == 0;
  other.hint_field_ = hint_points_;
  other.witness_.distance = witness_.distance;
  const double lower_bound = other.searchDeeper(scratch) - kFloatRounding - F_.body.shell.covering_radius;
  // Each search bounds the depth of its own points only.
  certified_ = std::min(certified_, lower_bound);
  other_sum_ = other.sum_;
  const Witness& found = other.witness_;
  if (!(found.distance < witness_.distance)) return;
  witness_.on_points = X_FP_ * found.on_field;
  witness_.on_field = X_FP_ * found.on_points;
  witness_.hint_points = found.hint_field;
  witness_.hint_field = found.hint_points;
  witness_.distance = found.distance;
  isProven();
}

std::optional<PenaltyForce> PairSearch::penalty(bool from_a) const {
  if (sum_ && sum_->contacts > 0) return penaltyOf(*sum_, P_, F_, X_FP_, options_.stiffness, from_a);
  if (!other_sum_) return {};
  return penaltyOf(*other_sum_, F_, P_, P_.X_WB.inverse() * F_.X_WB, options_.stiffness, !from_a);
}

void PairSearch::store(PairCache& memory, bool from_a) const {
  memory.apart = witness_.distance > kTouching;
  memory.distance = witness_.distance;
  memory.hulls = hulls_;
  memory.by_parts = by_parts_;
  const bool overlapping =
      hull_test_ == HullTest::kOverlap && !by_parts_ && witness_.distance < kRelativeFrom;
  memory.hull_test_cooldown = overlapping               ? kHullTestCooldown
                              : hull_test_cooldown_ > 0 ? hull_test_cooldown_ - 1
                                                        : 0;
  if (state_ != WitnessState::kTransported && memory.apart) {
    const Vector3d n = (witness_.on_points - witness_.on_field) / witness_.distance;
    const Vector3d n_P = X_FP_.linear().transpose() * n;
    memory.n_a = from_a ? n_P : -n;
    memory.n_b = from_a ? n : -n_P;
  }
  const Vector3d on_points = X_FP_.inverse() * witness_.on_points;
  memory.on_a = from_a ? on_points : witness_.on_field;
  memory.on_b = from_a ? witness_.on_field : on_points;
  memory.hint_a = from_a ? witness_.hint_points : witness_.hint_field;
  memory.hint_b = from_a ? witness_.hint_field : witness_.hint_points;
}

/// Also sums forces if they are needed, as both searches visit the same points.
kernels::NearestPoint PairSearch::nearestPoint(const kernels::NearestLimits& limits,
                                               kernels::PairScratch& scratch) {
  const field::NearField* near = structure::nearField(F_.body);
  if (summing_ && near) {
    const auto margin = static_cast<float>(options_.margin);
    // Visits every point that limits.start would not exclude.
    const float start =
        std::isfinite(limits.start) ? limits.start + static_cast<float>(near->errorBound()) : margin;
    const kernels::ContactLimits contacts{margin, std::max(margin, start), options_.law == ForceLaw::kVolume};
    const kernels::ContactSearch found = kernels::searchKernels().contactSearch(
        P_.body.treeView(X_FP_), F_.body.fieldView(), contacts, scratch);
    sum_ = found.sum;
    if (found.nearest.point != kernels::kNoPoint || std::isfinite(limits.start)) return found.nearest;
  }
  return kernels::searchKernels().nearest(P_.body.treeView(X_FP_), F_.body.fieldView(), limits, scratch);
}

/// Local search from the deepest shell point, if it seems deeper than the witness or nearly as deep. Returns
/// the same as searchPoints().
double PairSearch::searchDeeper(kernels::PairScratch& scratch) {
  const kernels::NearestLimits limits{static_cast<float>(witness_.distance),
                                      static_cast<float>(kRelativeFrom),
                                      static_cast<float>(kSearchTolerance)};
  const kernels::NearestPoint nearest = nearestPoint(limits, scratch);
  const double spacing = P_.body.shell.spacing;
  if (nearest.point != kernels::kNoPoint &&
      static_cast<double>(nearest.estimate) <
          witness_.distance + (witness_.distance > -spacing ? kMaxCrossingGain : kMaxDepthGain) * spacing)
    witness_ = refineWitness(
        P_.body, F_.body, X_FP_,
        {X_FP_ * P_.body.tree.at(nearest.point), normalAt(nearest.point), spacing, hint_field_});
  return static_cast<double>(nearest.lower_bound);
}

/// Improves the witness from the best shell point; `apart`: known to be apart. Returns the proven lower bound
/// (m) for all shell points.
double PairSearch::searchPoints(bool apart, kernels::PairScratch& scratch) {
  const kernels::NearestLimits limits{
      apart ? static_cast<float>(witness_.distance) : std::numeric_limits<float>::infinity(),
      static_cast<float>(kRelativeFrom), static_cast<float>(kSearchTolerance)};
  const kernels::NearestPoint nearest = nearestPoint(limits, scratch);
  const auto lower_bound = static_cast<double>(nearest.lower_bound);
  if (nearest.point == kernels::kNoPoint) return lower_bound;
  const Vector3d start = X_FP_ * P_.body.tree.at(nearest.point);
  const double spacing = P_.body.shell.spacing;
  // The point leads to the same witness, or cannot lead to a nearer one.
  const bool same_start = (start - witness_.on_points).norm() < kSameStart * spacing;
  if (state_ == WitnessState::kSettled && witness_.distance > kTouching &&
      static_cast<double>(nearest.estimate) > witness_.distance + (same_start ? 0.0 : spacing))
    return lower_bound;
  const bool far = apart && lower_bound > kRelativeFrom;
  if (far && witness_.distance - lower_bound <= kAcceptedExcess * witness_.distance) {
    found_ = lower_bound;
    return lower_bound;
  }
  Witness found;
  if (far)
    found = footWitness(*F_.body.surface, start, witness_.hint_field,
                        (1.0 + kAcceptedExcess) * static_cast<double>(nearest.estimate));
  // If the point's foot is not nearer than the witness, a local search from it may be; within one percent the
  // foot is near enough.
  const bool refine =
      options_.far_share < kColdFarShare &&
      static_cast<double>(nearest.estimate) < (1.0 - kRefineShare * options_.far_share) * witness_.distance;
  if (!far || (refine && !(found.distance < witness_.distance)))
    found = refineWitness(P_.body, F_.body, X_FP_, {start, normalAt(nearest.point), spacing, hint_field_});
  if (!apart || found.distance < witness_.distance) witness_ = found;
  return lower_bound;
}

/// The witness points, moved with the bodies, are still the nearest if the runner-up was farther away by more
/// than the bodies have moved.
bool PairSearch::isUniqueMinimum(const PairCache& memory) const {
  return certified_ > 0.0 && witness_.distance <= memory.runner_up_distance - motion_ &&
         (X_FP_ * memory.witness_on_points - witness_.on_points).norm() <
             0.5 * kSameMinimumRadius * P_.body.shell.spacing;
}

void PairSearch::findRunnerUp(PairCache& memory, kernels::PairScratch& scratch) const {
  const Vector3f centre = witness_.on_points.cast<float>();
  const kernels::Ball ball{{centre.x(), centre.y(), centre.z()},
                           static_cast<float>(kSameMinimumRadius * P_.body.shell.spacing)};
  const auto max_distance = static_cast<float>(witness_.distance + kRunnerUpRange);
  memory.witness_on_points = X_FP_.inverse() * witness_.on_points;
  memory.runner_up_distance = static_cast<double>(kernels::searchKernels().nearestOutside(
      P_.body.treeView(X_FP_), F_.body.fieldView(), ball, max_distance, scratch));
}

}  // namespace abstand::query
