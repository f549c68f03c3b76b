#include "core/haptic/pair_query.hpp"

#include <algorithm>

#include "core/haptic/search_kernels.hpp"
#include "core/haptic/separation.hpp"
#include "core/haptic/witness.hpp"

namespace abstand {
namespace {

// Shell points are moved between the frames in float: below 0.2 um for bodies within some metres.
constexpr double kFloatRounding = 1e-6;
// Beyond this distance the answer may exceed the smallest distance by this part of it; the bound says so.
constexpr double kFarFrom = 0.1;  // m
constexpr double kFarPart = 0.01;
// A search goes on to this part, so that what it proved is still worth something when the bodies have moved.
constexpr double kSearchPart = 0.0025;
// Nearer, by this. m.
constexpr double kNearEnough = 1e-5;
// Of the radii: what separationAlong loses at most by not looking closely, and some staleness.
constexpr double kHullLoss = 0.05;
// Spacings: a shell point this near to the witness, and no nearer to the other body, leads to it again.
constexpr double kSamePlace = 2.0;
// m; of a plane between bodies within a million metres.
constexpr double kPlaneRounding = 1e-8;
// m; points nearer to each other give no direction.
constexpr double kTouching = 1e-6;

/// One query: P gives the points, F the field.
class Query {
 public:
  Query(const HapticStructure& P, const Transform& X_WP, const HapticStructure& F, const Transform& X_WF)
      : P_(P), F_(F), X_WP_(X_WP), X_WF_(X_WF), X_FP_(X_WF.inverse() * X_WP) {}

  /// Where the nearest points were may be where they are: proven when no points can be much nearer.
  bool remember(const PairMemory& memory, bool from_a) {
    if (!memory.apart) return false;
    searched(memory.searched - mostMotion(P_.bounding_sphere, memory.X_FP, X_FP_));
    witness_.on_points = X_FP_ * (from_a ? memory.on_a : memory.on_b);
    witness_.on_field = from_a ? memory.on_b : memory.on_a;
    witness_.hint_points = from_a ? memory.hint_a : memory.hint_b;
    witness_.hint_field = from_a ? memory.hint_b : memory.hint_a;
    witness_.distance = (witness_.on_points - witness_.on_field).norm();
    if (isProven()) return true;
    // Farther away a search is the shorter way.
    if (witness_.distance > kFarFrom) return false;
    approachWitness(*P_.surface, *F_.surface, X_FP_, witness_);
    settled_ = true;
    return isProven();
  }

  /// The nearest shell point, then the nearest points on the exact surfaces about it.
  void search(PairMemory& memory, PairScratch& scratch) {
    const double lower_bound = searchPoints(witness_.distance > kTouching, scratch) - kFloatRounding;
    memory.X_FP = X_FP_;
    memory.searched = lower_bound;
    searched(lower_bound);
    isProven();
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
    Query other(F_, X_WF_, P_, X_WP_);
    const double lower_bound = other.searchPoints(false, scratch) - kFloatRounding - F_.shell.covering_radius;
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
    const Vector3d on_points = X_FP_.inverse() * witness_.on_points;
    memory.on_a = from_a ? on_points : witness_.on_field;
    memory.on_b = from_a ? witness_.on_field : on_points;
    memory.hint_a = from_a ? witness_.hint_points : witness_.hint_field;
    memory.hint_b = from_a ? witness_.hint_field : witness_.hint_points;
  }

  ContactSum contacts(const PairOptions& options, PairScratch& scratch) const {
    return searchKernels().contacts(P_.treeView(X_FP_), F_.fieldView(),
                                    {static_cast<float>(options.margin), options.law == ForceLaw::kVolume},
                                    scratch);
  }

  const Witness& witness() const { return witness_; }
  const Transform& X_FP() const { return X_FP_; }
  /// The true distance is never below it.
  double certified() const { return certified_; }

 private:
  /// Improves the witness by the best shell point; `apart`: from what is known. Returns the least distance
  /// (m) of any shell point that is proven.
  double searchPoints(bool apart, PairScratch& scratch) {
    const NearestLimits limits{
        apart ? static_cast<float>(witness_.distance) : std::numeric_limits<float>::infinity(),
        static_cast<float>(kFarFrom), static_cast<float>(kSearchPart)};
    const NearestPoint nearest = searchKernels().nearest(P_.treeView(X_FP_), F_.fieldView(), limits, scratch);
    const auto lower_bound = static_cast<double>(nearest.lower_bound);
    if (nearest.point == NearestPoint::kNone) return lower_bound;
    const std::uint32_t i = nearest.point;
    const Vector3d start = X_FP_ * Vector3d(P_.tree.x[i], P_.tree.y[i], P_.tree.z[i]);
    const double spacing = P_.shell.spacing;
    // What leads to the witness again, or cannot lead to anything nearer.
    const bool same_place = (start - witness_.on_points).norm() < kSamePlace * spacing;
    if (settled_ && static_cast<double>(nearest.estimate) > witness_.distance + (same_place ? 0.0 : spacing))
      return lower_bound;
    const bool far = apart && lower_bound > kFarFrom;
    const Witness found =
        far ? footWitness(*P_.surface, *F_.surface, X_FP_, start, witness_.hint_field)
            : refineWitness(*P_.surface, *F_.surface, X_FP_, start, spacing, lower_bound > 0.0 ? 1 : 0);
    if (!apart || found.distance < witness_.distance) witness_ = found;
    return lower_bound;
  }

  void certify(double lower_bound) { certified_ = std::max(certified_, lower_bound); }

  /// No shell point is nearer than this; so no surface point by more than the covering radius.
  void searched(double of_points) {
    of_points_ = of_points;
    certify(of_points - P_.shell.covering_radius);
  }

  /// The distance is within what is allowed of the smallest one of the surfaces, or of the shell's points.
  bool isProven() {
    if (!(witness_.distance > kTouching)) return false;
    const Vector3d n = X_WF_.linear() * ((witness_.on_points - witness_.on_field) / witness_.distance);
    const double enough = witness_.distance > kFarFrom ? kFarPart * witness_.distance : kNearEnough;
    for (const bool closely : {false, true}) {
      const double separation = separationAlong(n, P_, X_WP_, F_, X_WF_, closely);
      certify(separation - kPlaneRounding);
      separated_ = separated_ || separation > kPlaneRounding;
      if (witness_.distance - std::max(certified_, of_points_) <= enough) return true;
      // What the first look may have lost.
      if (witness_.distance - separation >
          kHullLoss * (P_.bounding_sphere.radius + F_.bounding_sphere.radius))
        return false;
    }
    return false;
  }

  const HapticStructure& P_;
  const HapticStructure& F_;
  const Transform& X_WP_;
  const Transform& X_WF_;
  const Transform X_FP_;
  Witness witness_;
  double certified_{-kInfinity};
  double of_points_{-kInfinity};
  bool separated_{false};  ///< a plane parts the hulls
  bool settled_{false};    ///< the witness is a nearest pair of its neighbourhood
};

}  // namespace

bool pointsFromA(const HapticStructure& a, const HapticStructure& b) {
  return a.bounding_sphere.radius <= b.bounding_sphere.radius;
}

void queryPair(const HapticStructure& a, const Transform& X_WA, const HapticStructure& b,
               const Transform& X_WB, const PairOptions& options, PairMemory& memory, PairScratch& scratch,
               PairResult& result) noexcept {
  const bool from_a = pointsFromA(a, b);
  const HapticStructure& P = from_a ? a : b;
  const HapticStructure& F = from_a ? b : a;
  const Transform& X_WF = from_a ? X_WB : X_WA;
  Query query(P, from_a ? X_WA : X_WB, F, X_WF);

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

  // Penalty forces of the shell points within the margins.
  ContactSum sum{};
  if (query.certified() <= options.margin) sum = query.contacts(options, scratch);
  result.contacts = sum.contacts;
  result.depth = static_cast<double>(sum.depth);
  const Vector3d force = options.stiffness * Vector3d(sum.force[0], sum.force[1], sum.force[2]);
  const Vector3d moment = options.stiffness * Vector3d(sum.moment[0], sum.moment[1], sum.moment[2]);
  const Vector3d force_P = X_WF.linear() * force;
  const Vector3d torque_P = X_WF.linear() * (moment - (query.X_FP() * P.com).cross(force));
  const Vector3d torque_F = -(X_WF.linear() * (moment - F.com.cross(force)));
  result.force_a = from_a ? force_P : Vector3d(-force_P);
  result.torque_a = from_a ? torque_P : torque_F;
  result.torque_b = from_a ? torque_F : torque_P;
}

void queryPair(const HapticStructure& a, const Transform& X_WA, const HapticStructure& b,
               const Transform& X_WB, const PairOptions& options, PairScratch& scratch,
               PairResult& result) noexcept {
  PairMemory memory;
  queryPair(a, X_WA, b, X_WB, options, memory, scratch, result);
}

}  // namespace abstand
