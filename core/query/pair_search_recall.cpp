// Pair query: warm start; follows the last witness points and proves their distance.
#include <algorithm>

#include "core/query/pair_search.hpp"
#include "core/query/separation.hpp"

namespace abstand::query {
namespace {

// Share of the tolerance: the surface between the points may be nearer than they are.
constexpr double kPointsShare = 0.75;
// Share of the radii: largest loss of separationAlong without `closely`, and a reserve.
constexpr double kHullLoss = 0.05;
// Share of the distance: up to this excess over the separation of the hulls, the hulls are tested first.
constexpr double kHullShare = 0.03;
// More rounds with a new axis gain little.
constexpr int kRounds = 3;

}  // namespace

bool PairSearch::warmStart(const PairCache& memory, bool from_a) {
  hint_points_ = from_a ? memory.hint_a : memory.hint_b;
  hint_field_ = from_a ? memory.hint_b : memory.hint_a;
  if (!memory.apart) return false;
  motion_ = maxDisplacement(P_.body.bounding_sphere, memory.X_FP, X_FP_);
  setShellBound(memory.searched - motion_);
  found_ = memory.found - motion_;
  witness_.on_points = X_FP_ * (from_a ? memory.on_a : memory.on_b);
  witness_.on_field = from_a ? memory.on_b : memory.on_a;
  witness_.hint_points = from_a ? memory.hint_a : memory.hint_b;
  witness_.hint_field = from_a ? memory.hint_b : memory.hint_a;
  witness_.distance = (witness_.on_points - witness_.on_field).norm();
  hulls_ = memory.hulls;
  if (!(witness_.distance > kTouching)) return false;
  state_ = WitnessState::kTransported;
  if (isKnown()) return true;
  by_parts_ = memory.by_parts;
  if (by_parts_ && witness_.distance > kRelativeFrom && provenByParts()) return true;
  state_ = WitnessState::kMoved;
  const Vector3d n_P = from_a ? memory.n_a : -memory.n_b, n_F = from_a ? memory.n_b : -memory.n_a;
  const bool jumped = std::abs(witness_.distance - memory.distance) > kJump;
  if (jumped && trySupportPoints(n_P, n_F)) return true;
  hull_test_cooldown_ = jumped || witness_.distance > kRelativeFrom ? 0 : memory.hull_test_cooldown;
  if (hull_test_cooldown_ == 0 && refineLocally()) return true;
  // At larger distances a search is faster.
  if (witness_.distance > kRelativeFrom) {
    if (!jumped && memory.hulls && trySupportPoints(n_P, n_F)) return true;
    if (tryPartSupportPoints()) return true;
    if (witness_.distance > kRelativeFrom) return false;
  }
  slideWitness(*P_.body.surface, *F_.body.surface, X_FP_, witness_);
  if (isProven()) return true;
  convergeWitness(*P_.body.surface, *F_.body.surface, X_FP_, witness_);
  state_ = WitnessState::kSettled;
  return isProven() || isUniqueMinimum(memory);
}

/// Refines the last witness points as long as the gain is large.
bool PairSearch::refineLocally() {
  for (int round = 1;; ++round) {
    const bool more = projectWitness(*P_.body.surface, *F_.body.surface, X_FP_, witness_) && round < kRounds;
    // The test by parts runs once, at the end.
    if (!(by_parts_ && more) && isProven()) return true;
    if (!more) return false;
  }
}

/// For a body that rotates about itself: the distance stays but the witness points change. Tries the support
/// points along the last witness line, taken in either body's frame. n_P, n_F: unit vectors from F to P in
/// the axes of each.
bool PairSearch::trySupportPoints(const Vector3d& n_P, const Vector3d& n_F) {
  Vector3d n = X_FP_.linear() * n_P;
  if (separation(n) < separation(n_F)) n = n_F;
  for (int round = 0; round < kRounds; ++round) {
    const double before = witness_.distance;
    tryPoints(P_.body.support.extreme(X_FP_.linear().transpose() * -n), F_.body.support.extreme(n));
    if (!(witness_.distance > kTouching)) return false;
    if (provenByHulls(F_.X_WB.linear() * ((witness_.on_points - witness_.on_field) / witness_.distance)))
      return true;
    if (!(witness_.distance < before)) return false;
    n = (witness_.on_points - witness_.on_field) / witness_.distance;
  }
  return false;
}

/// The same with the parts of the bodies.
bool PairSearch::tryPartSupportPoints() {
  if (!haveParts()) return false;
  for (int round = 0; round < kRounds; ++round) {
    const double before = witness_.distance;
    const Vector3d n = (witness_.on_points - witness_.on_field) / before;
    FacingParts::Parts between;
    if (partsApart(n, between)) return true;
    tryPoints(partExtreme(P_.body, between.of_points, X_FP_.linear().transpose() * -n),
              partExtreme(F_.body, between.of_field, n));
    if (!(witness_.distance < before)) return false;
  }
  return false;
}

/// Replaces one or both witness points by these surface points if that is nearer.
void PairSearch::tryPoints(const structure::ExtremePoint& of_points,
                           const structure::ExtremePoint& of_field) {
  const Vector3d p = X_FP_ * of_points.point, &q = of_field.point;
  const Vector3d p_0 = witness_.on_points, q_0 = witness_.on_field;
  const double d_p = (p - q_0).norm(), d_q = (p_0 - q).norm(), d = (p - q).norm();
  const double smallest = std::min({d_p, d_q, d});
  if (!(smallest < witness_.distance)) return;
  witness_.distance = smallest;
  const bool other_points = d_q > smallest, other_field = d_p > smallest || !other_points;
  if (other_points) {
    witness_.on_points = p;
    witness_.hint_points = of_points.hint;
  }
  if (other_field) {
    witness_.on_field = q;
    witness_.hint_field = of_field.hint;
  }
}

/// Certified separation (m) along the unit vector n from F to P in F's axes.
double PairSearch::separation(const Vector3d& n) {
  const double apart = separationAlong(F_.X_WB.linear() * n, P_, F_, false);
  certify(apart - kPlaneRounding);
  return apart;
}

bool PairSearch::isKnown() const {
  const double may_exceed = tolerance(witness_.distance, options_);
  return witness_.distance - certified_ <= may_exceed ||
         witness_.distance - std::max(of_points_, found_) <= kPointsShare * may_exceed;
}

/// True if the distance is within tolerance of the smallest one of the surfaces, or of the shell points.
bool PairSearch::isProven() {
  if (!(witness_.distance > kTouching)) return false;
  if (hull_test_cooldown_ > 0) return isKnown();
  if (hull_test_ == HullTest::kSkipped) hull_test_ = HullTest::kOverlap;
  const Vector3d n = F_.X_WB.linear() * ((witness_.on_points - witness_.on_field) / witness_.distance);
  const bool parts_first = by_parts_;
  if (parts_first && provenByParts()) return true;
  return provenByHulls(n) || (!parts_first && provenByParts());
}

bool PairSearch::provenByHulls(const Vector3d& n) {
  for (const bool closely : {false, true}) {
    const double separation = separationAlong(n, P_, F_, closely);
    certify(separation - kPlaneRounding);
    if (separation > kPlaneRounding) hull_test_ = HullTest::kSeparated;
    hulls_ = witness_.distance - separation <= kHullShare * witness_.distance;
    if (isKnown()) return true;
    // The loss of the fast test.
    if (witness_.distance - separation >
        kHullLoss * (P_.body.bounding_sphere.radius + F_.body.bounding_sphere.radius))
      break;
  }
  return false;
}

bool PairSearch::provenByParts() {
  FacingParts::Parts between;
  return haveParts() &&
         (by_parts_ = partsApart((witness_.on_points - witness_.on_field) / witness_.distance, between));
}

bool PairSearch::partsApart(const Vector3d& n, FacingParts::Parts& between) {
  const double by = witness_.distance - tolerance(witness_.distance, options_);
  if (!FacingParts(P_.body, F_.body, X_FP_, by, witness_.distance <= kRelativeFrom, part_axes_)
           .apart(n, between))
    return false;
  certify(by);
  return true;
}

}  // namespace abstand::query
