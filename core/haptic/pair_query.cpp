#include "core/haptic/pair_query.hpp"

#include <algorithm>

#include "core/haptic/parts_apart.hpp"
#include "core/haptic/penalty_force.hpp"
#include "core/haptic/search_kernels.hpp"
#include "core/haptic/separation.hpp"
#include "core/haptic/witness.hpp"

namespace abstand {
namespace {

// Shell points are moved between the frames in float: below 0.2 um for bodies within some metres.
constexpr double kFloatRounding = 1e-6;
// Beyond this distance the smallest may be less than the answer by this part of the answer, which is then
// within a hundredth of the smallest; the bound says so.
constexpr double kFarFrom = 0.1;  // m
constexpr double kFarPart = 0.0099;
// Of what is allowed: the surface between the points may be nearer than they are.
constexpr double kPointsPart = 0.75;
// A search goes on to this part, so that what it proved is still worth something when the bodies have moved.
constexpr double kSearchPart = 0.0025;
// Of the distance: so much nearer points a search beyond may have missed, as the field there is coarse.
constexpr double kFoundPart = 0.005;
// Nearer, by this. m.
constexpr double kNearEnough = 1e-5;
// Of the radii: what separationAlong loses at most by not looking closely, and some staleness.
constexpr double kHullLoss = 0.05;
// Spacings: a shell point this near to the witness, and no nearer to the other body, leads to it again.
constexpr double kSamePlace = 2.0;
// m; points nearer to each other give no direction.
constexpr double kTouching = 1e-6;
// Of the distance: by so much at most it exceeds that of the hulls where it is worth to look at them first.
constexpr double kHullPart = 0.03;
// Of the distance: a witness so near to what is proven is not worth to improve.
constexpr double kStayPart = 0.002;
// m; bodies that move by no more from one search to the next are worth to look at a second time, for points
// that are farther away than the nearest by this.
constexpr double kSlow = 0.001, kRivalry = 0.004;
// Spacings: by so much at most the walk from a point finds a deeper one.
constexpr double kDeeper = 0.1;
// The same where the bodies hardly touch: where edges cross, both may lie between points.
constexpr double kCrossing = 0.5;
// Spacings; nearer to the witness points are no rivals, as the way to them leads downhill.
constexpr double kHome = 6.0;
// m; points that have left each other by so much between two queries are a bad start.
constexpr double kJump = 0.01;
// A line found anew gains little after that.
constexpr int kRounds = 3;

/// By so much (m) a distance may exceed the smallest.
double allowed(double distance) { return distance > kFarFrom ? kFarPart * distance : kNearEnough; }

/// One query: P gives the points, F the field.
class Query {
 public:
  Query(const HapticStructure& P, const Transform& X_WP, const HapticStructure& F, const Transform& X_WF,
        PartLines& part_lines)
      : P_(P), F_(F), X_WP_(X_WP), X_WF_(X_WF), X_FP_(X_WF.inverse() * X_WP), part_lines_(part_lines) {}

  /// Where the nearest points were may be where they are: proven when no points can be much nearer.
  bool remember(const PairMemory& memory, bool from_a) {
    hint_points_ = from_a ? memory.hint_a : memory.hint_b;
    hint_field_ = from_a ? memory.hint_b : memory.hint_a;
    if (!memory.apart) return false;
    motion_ = mostMotion(P_.bounding_sphere, memory.X_FP, X_FP_);
    searched(memory.searched - motion_);
    found_ = memory.found - motion_;
    witness_.on_points = X_FP_ * (from_a ? memory.on_a : memory.on_b);
    witness_.on_field = from_a ? memory.on_b : memory.on_a;
    witness_.hint_points = from_a ? memory.hint_a : memory.hint_b;
    witness_.hint_field = from_a ? memory.hint_b : memory.hint_a;
    witness_.distance = (witness_.on_points - witness_.on_field).norm();
    hulls_ = memory.hulls;
    if (!(witness_.distance > kTouching)) return false;
    if (isKnown()) return remembered_ = true;
    by_parts_ = memory.by_parts;
    if (by_parts_ && witness_.distance > kFarFrom && provenByParts()) return remembered_ = true;
    const Vector3d n_P = from_a ? memory.n_a : -memory.n_b, n_F = from_a ? memory.n_b : -memory.n_a;
    const bool jumped = std::abs(witness_.distance - memory.distance) > kJump;
    if (jumped && turned(n_P, n_F)) return true;
    if (walked()) return true;
    // Farther away a search is the shorter way.
    if (witness_.distance > kFarFrom) {
      if (!jumped && memory.hulls && turned(n_P, n_F)) return true;
      if (partsTurned()) return true;
      if (witness_.distance > kFarFrom) return false;
    }
    slideWitness(*P_.surface, *F_.surface, X_FP_, witness_);
    if (isProven()) return true;
    approachWitness(*P_.surface, *F_.surface, X_FP_, witness_);
    settled_ = true;
    return isProven() || isAlone(memory);
  }

  /// The nearest shell point, then the nearest points on the exact surfaces about it.
  void search(PairMemory& memory, PairScratch& scratch) {
    found_ = kInfinity;
    const double lower_bound = searchPoints(witness_.distance > kTouching, scratch) - kFloatRounding;
    memory.X_FP = X_FP_;
    memory.searched = lower_bound;
    const double loss = witness_.distance > kFarFrom ? kFoundPart * witness_.distance : 0.0;
    memory.found = found_ = std::min(found_, witness_.distance - loss);
    searched(lower_bound);
    isProven();
    memory.rivals = -kInfinity;
    if (motion_ < kSlow && certified_ > 0.0 && witness_.distance < kFarFrom) seekRivals(memory, scratch);
  }

  /// True when the bodies may touch, as far as is proven, or P may have swallowed a piece of F.
  bool mayTouch() const {
    if (certified_ <= 0.0) return true;
    if (F_.pieces.empty() || separated_) return false;
    const Transform X_PF = X_FP_.inverse();
    return std::any_of(F_.pieces.begin(), F_.pieces.end(), [&](const Vector3d& piece) {
      const Vector3d p = X_PF * piece;
      return (p - P_.bounding_sphere.centre).norm() < P_.bounding_sphere.radius && P_.surface->inside(p);
    });
  }

  /// What a search of F's points in P's field finds: a tip of F may lie between P's points, and a whole piece
  /// of it inside of P.
  void searchOtherWay(PairScratch& scratch) {
    PartLines none;
    Query other(F_, X_WF_, P_, X_WP_, none);
    other.hint_field_ = hint_points_;
    other.witness_.distance = witness_.distance;
    const double lower_bound = other.searchDeeper(scratch) - kFloatRounding - F_.shell.covering_radius;
    // Each search bounds the depth of its own points.
    certified_ = std::min(certified_, lower_bound);
    const Witness& found = other.witness_;
    if (!(found.distance < witness_.distance)) return;
    witness_.on_points = X_FP_ * found.on_field;
    witness_.on_field = X_FP_ * found.on_points;
    witness_.hint_points = found.hint_field;
    witness_.hint_field = found.hint_points;
    witness_.distance = found.distance;
    isProven();
  }

  void keep(PairMemory& memory, bool from_a) const {
    memory.apart = witness_.distance > kTouching;
    memory.distance = witness_.distance;
    memory.hulls = hulls_;
    memory.by_parts = by_parts_;
    if (!remembered_ && memory.apart) {
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

  const Witness& witness() const { return witness_; }
  /// The true distance is never below it.
  double certified() const { return certified_; }

 private:
  Vector3d normalAt(std::uint32_t point) const { return X_FP_.linear() * P_.tree.normalAt(point); }

  /// From where they were, as long as there is much to gain.
  bool walked() {
    for (int round = 1;; ++round) {
      const bool more = walkWitness(*P_.surface, *F_.surface, X_FP_, witness_) && round < kRounds;
      // What parts prove is looked at once, at the end.
      if (!(by_parts_ && more) && isProven()) return true;
      if (!more) return false;
    }
  }

  /// A body that turns about itself keeps its distance, but by other points: those that reach farthest along
  /// the line on which the nearest were, as it lies in the other body. n_P, n_F: unit vectors from F to P in
  /// the axes of each.
  bool turned(const Vector3d& n_P, const Vector3d& n_F) {
    Vector3d n = X_FP_.linear() * n_P;
    if (separation(n) < separation(n_F)) n = n_F;
    for (int round = 0; round < kRounds; ++round) {
      const double before = witness_.distance;
      take(P_.support.extreme(X_FP_.linear().transpose() * -n), F_.support.extreme(n));
      if (!(witness_.distance > kTouching)) return false;
      if (provenByHulls(X_WF_.linear() * ((witness_.on_points - witness_.on_field) / witness_.distance)))
        return true;
      if (!(witness_.distance < before)) return false;
      n = (witness_.on_points - witness_.on_field) / witness_.distance;
    }
    return false;
  }

  /// The same with the parts of the bodies.
  bool partsTurned() {
    if (!haveParts()) return false;
    for (int round = 0; round < kRounds; ++round) {
      const double before = witness_.distance;
      const Vector3d n = (witness_.on_points - witness_.on_field) / before;
      FacingParts::Parts between;
      if (partsApart(n, between)) return true;
      take(partExtreme(P_, between.of_points, X_FP_.linear().transpose() * -n),
           partExtreme(F_, between.of_field, n));
      if (!(witness_.distance < before)) return false;
    }
    return false;
  }

  /// One of these points of the surfaces or both, when they are nearer.
  void take(const ExtremePoint& of_points, const ExtremePoint& of_field) {
    const Vector3d p = X_FP_ * of_points.point, &q = of_field.point;
    const Vector3d p_0 = witness_.on_points, q_0 = witness_.on_field;
    const double d_p = (p - q_0).norm(), d_q = (p_0 - q).norm(), d = (p - q).norm();
    const double least = std::min({d_p, d_q, d});
    if (!(least < witness_.distance)) return;
    witness_.distance = least;
    const bool other_points = d_q > least, other_field = d_p > least || !other_points;
    if (other_points) {
      witness_.on_points = p;
      witness_.hint_points = of_points.hint;
    }
    if (other_field) {
      witness_.on_field = q;
      witness_.hint_field = of_field.hint;
    }
  }

  /// The walk from the deepest shell point, when it seems deeper than the witness or hardly less. Returns as
  /// searchPoints does.
  double searchDeeper(PairScratch& scratch) {
    const NearestLimits limits{static_cast<float>(witness_.distance), static_cast<float>(kFarFrom),
                               static_cast<float>(kSearchPart)};
    const NearestPoint nearest = searchKernels().nearest(P_.treeView(X_FP_), F_.fieldView(), limits, scratch);
    const double spacing = P_.shell.spacing;
    if (nearest.point != kNoPoint &&
        static_cast<double>(nearest.estimate) <
            witness_.distance + (witness_.distance > -spacing ? kCrossing : kDeeper) * spacing)
      witness_ =
          refineWitness(*P_.surface, *F_.surface, nearField(F_), X_FP_, X_FP_ * P_.tree.at(nearest.point),
                        normalAt(nearest.point), spacing, hint_field_);
    return static_cast<double>(nearest.lower_bound);
  }

  /// Improves the witness by the best shell point; `apart`: from what is known. Returns the least distance
  /// (m) of any shell point that is proven.
  double searchPoints(bool apart, PairScratch& scratch) {
    const NearestLimits limits{
        apart ? static_cast<float>(witness_.distance) : std::numeric_limits<float>::infinity(),
        static_cast<float>(kFarFrom), static_cast<float>(kSearchPart)};
    const NearestPoint nearest = searchKernels().nearest(P_.treeView(X_FP_), F_.fieldView(), limits, scratch);
    const auto lower_bound = static_cast<double>(nearest.lower_bound);
    if (nearest.point == kNoPoint) return lower_bound;
    const Vector3d start = X_FP_ * P_.tree.at(nearest.point);
    const double spacing = P_.shell.spacing;
    // What leads to the witness again, or cannot lead to anything nearer.
    const bool same_place = (start - witness_.on_points).norm() < kSamePlace * spacing;
    if (settled_ && witness_.distance > kTouching &&
        static_cast<double>(nearest.estimate) > witness_.distance + (same_place ? 0.0 : spacing))
      return lower_bound;
    const bool far = apart && lower_bound > kFarFrom;
    if (far && witness_.distance - lower_bound <= kStayPart * witness_.distance) {
      found_ = lower_bound;
      return lower_bound;
    }
    const Witness found = far ? footWitness(*F_.surface, start, witness_.hint_field,
                                            (1.0 + kStayPart) * static_cast<double>(nearest.estimate))
                              : refineWitness(*P_.surface, *F_.surface, nearField(F_), X_FP_, start,
                                              normalAt(nearest.point), spacing, hint_field_);
    if (!apart || found.distance < witness_.distance) witness_ = found;
    return lower_bound;
  }

  /// The nearest points that moved with the bodies are still the nearest, when all others were farther away
  /// by more than what the bodies have moved.
  bool isAlone(const PairMemory& memory) const {
    return certified_ > 0.0 && witness_.distance <= memory.rivals - motion_ &&
           (X_FP_ * memory.home - witness_.on_points).norm() < 0.5 * kHome * P_.shell.spacing;
  }

  void seekRivals(PairMemory& memory, PairScratch& scratch) const {
    const Vector3f home = witness_.on_points.cast<float>();
    const Ball ball{{home.x(), home.y(), home.z()}, static_cast<float>(kHome * P_.shell.spacing)};
    const auto most = static_cast<float>(witness_.distance + kRivalry);
    memory.home = X_FP_.inverse() * witness_.on_points;
    memory.rivals = static_cast<double>(
        searchKernels().nearestOutside(P_.treeView(X_FP_), F_.fieldView(), ball, most, scratch));
  }

  void certify(double lower_bound) { certified_ = std::max(certified_, lower_bound); }

  /// No shell point is nearer than this; so no surface point by more than the covering radius.
  void searched(double of_points) {
    of_points_ = of_points;
    certify(of_points - P_.shell.covering_radius);
  }

  /// Certified, along the unit vector n from F to P in F's axes.
  double separation(const Vector3d& n) {
    const double apart = separationAlong(X_WF_.linear() * n, P_, X_WP_, F_, X_WF_, false);
    certify(apart - kPlaneRounding);
    return apart;
  }

  bool isKnown() const {
    const double may_exceed = allowed(witness_.distance);
    return witness_.distance - certified_ <= may_exceed ||
           witness_.distance - std::max(of_points_, found_) <= kPointsPart * may_exceed;
  }

  /// The distance is within what is allowed of the smallest one of the surfaces, or of the shell's points.
  bool isProven() {
    if (!(witness_.distance > kTouching)) return false;
    const Vector3d n = X_WF_.linear() * ((witness_.on_points - witness_.on_field) / witness_.distance);
    const bool parts_first = by_parts_;
    if (parts_first && provenByParts()) return true;
    return provenByHulls(n) || (!parts_first && provenByParts());
  }

  bool provenByHulls(const Vector3d& n) {
    for (const bool closely : {false, true}) {
      const double separation = separationAlong(n, P_, X_WP_, F_, X_WF_, closely);
      certify(separation - kPlaneRounding);
      separated_ = separated_ || separation > kPlaneRounding;
      hulls_ = witness_.distance - separation <= kHullPart * witness_.distance;
      if (isKnown()) return true;
      // What the first look may have lost.
      if (witness_.distance - separation >
          kHullLoss * (P_.bounding_sphere.radius + F_.bounding_sphere.radius))
        break;
    }
    return false;
  }

  bool haveParts() const { return P_.parts.size() > 1 || F_.parts.size() > 1; }

  bool provenByParts() {
    FacingParts::Parts between;
    return haveParts() &&
           (by_parts_ = partsApart((witness_.on_points - witness_.on_field) / witness_.distance, between));
  }

  bool partsApart(const Vector3d& n, FacingParts::Parts& between) {
    const double by = witness_.distance - allowed(witness_.distance);
    if (!FacingParts(P_, F_, X_FP_, by, witness_.distance <= kFarFrom, part_lines_).apart(n, between))
      return false;
    certify(by);
    return true;
  }

  const HapticStructure& P_;
  const HapticStructure& F_;
  const Transform& X_WP_;
  const Transform& X_WF_;
  const Transform X_FP_;
  PartLines& part_lines_;
  Witness witness_;
  double certified_{-kInfinity};
  double motion_{kInfinity};  ///< m, since the last search
  double of_points_{-kInfinity};
  std::uint32_t hint_points_{kNoHint}, hint_field_{kNoHint};  ///< of the last query
  double found_{-kInfinity};  ///< the best of all points, as far as the last search could tell
  bool by_parts_{false};      ///< the hulls of their parts told last
  bool separated_{false};     ///< a plane parts the hulls
  bool hulls_{false};         ///< the witness is about as near as the hulls
  bool remembered_{false};    ///< it is the one of the last query
  bool settled_{false};       ///< the witness is a nearest pair of its neighbourhood
};

}  // namespace

namespace {

/// Most pairs: the nearest points are still where they were, and the hulls prove it.
bool stayed(const HapticStructure& a, const Transform& X_WA, const HapticStructure& b, const Transform& X_WB,
            double margin, PairMemory& memory, PairResult& result) {
  if (!memory.apart || !memory.hulls) return false;
  const Vector3d on_a = X_WA.linear() * memory.on_a + X_WA.translation(),
                 on_b = X_WB.linear() * memory.on_b + X_WB.translation();
  // Along a vector of any length: the separation times that.
  const Vector3d way = on_a - on_b;
  const double separated = separationAlong(way, a, X_WA, b, X_WB, false);
  const double distance = way.norm();
  if (!(distance > kTouching)) return false;
  const double certified = separated / distance - kPlaneRounding;
  if (distance - certified > allowed(distance) || certified <= margin) return false;
  memory.distance = distance;
  result = {};
  result.distance = distance;
  result.bound = std::max(0.0, distance - certified);
  result.witness_a = on_a;
  result.witness_b = on_b;
  return true;
}

}  // namespace

bool pointsFromA(const HapticStructure& a, const HapticStructure& b) {
  return a.bounding_sphere.radius <= b.bounding_sphere.radius;
}

void queryPair(const HapticStructure& a, const Transform& X_WA, const HapticStructure& b,
               const Transform& X_WB, const PairOptions& options, PairMemory& memory, PairScratch& scratch,
               PairResult& result) noexcept {
  if (stayed(a, X_WA, b, X_WB, options.margin, memory, result)) return;
  const bool from_a = pointsFromA(a, b);
  const HapticStructure& P = from_a ? a : b;
  const HapticStructure& F = from_a ? b : a;
  const Transform& X_WF = from_a ? X_WB : X_WA;
  Query query(P, from_a ? X_WA : X_WB, F, X_WF, memory.part_lines);

  if (!query.remember(memory, from_a)) {
    query.search(memory, scratch);
    if (query.mayTouch()) query.searchOtherWay(scratch);
  }
  query.keep(memory, from_a);
  const Witness& witness = query.witness();
  result.distance = witness.distance;
  result.bound = std::max(0.0, witness.distance - query.certified());
  const Vector3d on_points = X_WF * witness.on_points, on_field = X_WF * witness.on_field;
  result.witness_a = from_a ? on_points : on_field;
  result.witness_b = from_a ? on_field : on_points;

  PenaltyForce penalty;
  if (query.certified() <= options.margin) penalty = penaltyForce(a, X_WA, b, X_WB, options, scratch);
  result.contacts = penalty.contacts;
  result.depth = std::max({penalty.depth, options.margin - witness.distance, 0.0});
  result.force_a = penalty.force_a;
  result.torque_a = penalty.torque_a;
  result.torque_b = penalty.torque_b;
}

void queryPair(const HapticStructure& a, const Transform& X_WA, const HapticStructure& b,
               const Transform& X_WB, const PairOptions& options, PairScratch& scratch,
               PairResult& result) noexcept {
  PairMemory memory;
  queryPair(a, X_WA, b, X_WB, options, memory, scratch, result);
}

}  // namespace abstand
