// Batch queries of a fixed set of pairs.
#include "core/query/pair_set.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/query/between_points.hpp"
#include "core/query/pair_search.hpp"
#include "core/query/parts_apart.hpp"
#include "core/query/separation.hpp"

namespace abstand::query {
namespace {

// Share of the coordinates; the balls are transformed in double.
constexpr double kAxisRounding = 1e-12;
// In spacings: a point is nearer than this to bodies that overlap by 0.1 mm.
constexpr double kBetweenPoints = 0.4;
// Frank-Wolfe steps towards the nearest points of two hulls; if these do not separate them, the pair backs
// off.
constexpr int kAxisSteps = 10;
constexpr std::uint32_t kHullBackoff = 16, kMaxHullBackoff = 64, kPartsBackoff = 4, kMaxPartsBackoff = 16;
// Cosine of the largest angle between axes that count as the same.
constexpr double kSameAxis = 0.98;

}  // namespace

PairSet::PairSet(std::vector<const structure::HapticStructure*> structures, std::vector<Bodies> pairs)
    : structures_(std::move(structures)),
      pairs_(std::move(pairs)),
      spheres_(structures_.size()),
      axes_(pairs_.size()),
      memories_(pairs_.size()) {
  ABSTAND_CHECK(!pairs_.empty());
  for (const Bodies& pair : pairs_) ABSTAND_CHECK(std::max(pair.a, pair.b) < structures_.size());
  touches_.reserve(pairs_.size());
}

void PairSet::distances(std::span<const Transform> X_WB, const PairOptions& options,
                        std::span<PairResult> results) {
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Bodies& pair = pairs_[i];
    queryPair({*structures_[pair.a], X_WB[pair.a]}, {*structures_[pair.b], X_WB[pair.b]}, options,
              {memories_[i], scratch_}, results[i]);
  }
}

std::span<const PairSet::Touch> PairSet::contacts(std::span<const Transform> X_WB,
                                                  const PairOptions& options) {
  updateSpheres(X_WB);
  touches_.clear();
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Bodies& pair = pairs_[i];
    if (spheresApart(pair, options.margin) || provenApart(i, X_WB, options.margin)) continue;
    if (findAxis(i, X_WB, options.margin) || partsApart(i, X_WB, options.margin)) continue;
    const structure::HapticStructure &a = *structures_[pair.a], &b = *structures_[pair.b];
    const Transform &X_WA = X_WB[pair.a], &X_WB_b = X_WB[pair.b];
    const double between = kBetweenPoints * std::max(a.shell.spacing, b.shell.spacing);
    PenaltyForce penalty = penaltyForce({a, X_WA}, {b, X_WB_b}, options, scratch_, between);
    if (penalty.contacts == 0)
      penalty.depth =
          depthBetweenPoints({a, X_WA}, penalty.near_a, {b, X_WB_b}, penalty.near_b, options.margin);
    if (penalty.depth > 0.0) touches_.push_back({static_cast<std::uint32_t>(i), penalty});
  }
  return touches_;
}

const PairSet::Nearest& PairSet::nearest(std::span<const Transform> X_WB, const PairOptions& options) {
  updateSpheres(X_WB);
  const std::uint32_t first = nearest_.pair;
  // Forces are computed for the nearest pair only.
  const auto query = [&](std::size_t i, PairResult& result) {
    const Bodies& pair = pairs_[i];
    const bool touches =
        queryDistance({*structures_[pair.a], X_WB[pair.a]}, {*structures_[pair.b], X_WB[pair.b]}, options,
                      {memories_[i], scratch_}, result);
    const Vector3d between = result.witness_a - result.witness_b;
    if (result.distance > 0.0) storeAxis(i, X_WB, between / between.norm());
    return touches;
  };
  bool touching = query(first, nearest_.result);
  PairResult result;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const double min_distance = nearest_.result.distance;
    if (i == first || spheresApart(pairs_[i], min_distance) || provenApart(i, X_WB, min_distance) ||
        partsApart(i, X_WB, min_distance))
      continue;
    const bool touches = query(i, result);
    if (!(result.distance < nearest_.result.distance)) continue;
    nearest_ = {static_cast<std::uint32_t>(i), result};
    touching = touches;
  }
  if (touching) {
    const Bodies& pair = pairs_[nearest_.pair];
    addPenalty({*structures_[pair.a], X_WB[pair.a]}, {*structures_[pair.b], X_WB[pair.b]}, options, scratch_,
               nearest_.result);
  }
  return nearest_;
}

void PairSet::Backoff::failed(std::uint32_t min, std::uint32_t max) {
  remaining = next = std::clamp(2 * next, min, max);
}

void PairSet::updateSpheres(std::span<const Transform> X_WB) {
  for (std::size_t i = 0; i < structures_.size(); ++i) {
    const geometry::EnclosingSphere& sphere = structures_[i]->bounding_sphere;
    const Vector3d centre = X_WB[i] * sphere.centre;
    spheres_[i] = {centre, sphere.radius + kAxisRounding * (sphere.radius + centre.lpNorm<1>())};
  }
}

bool PairSet::spheresApart(const Bodies& pair, double by) const {
  const BoundingSphere &a = spheres_[pair.a], &b = spheres_[pair.b];
  const double limit = a.radius + b.radius + by;
  return limit < 0.0 || (a.centre - b.centre).squaredNorm() > limit * limit;
}

bool PairSet::provenApart(std::size_t i, std::span<const Transform> X_WB, double by) {
  const Bodies& pair = pairs_[i];
  PairAxes& axes = axes_[i];
  const auto apart = [&](const Vector3d& n) {
    return separationAlong(n, {*structures_[pair.a], X_WB[pair.a]}, {*structures_[pair.b], X_WB[pair.b]},
                           false) > by + kPlaneRounding;
  };
  const auto separates = [&](const SeparatingAxis& axis) {
    return !axis.in_a.isZero() &&
           (apart(X_WB[pair.a].linear() * axis.in_a) || apart(X_WB[pair.b].linear() * axis.in_b));
  };
  if (separates(axes.last)) return true;
  if (!separates(axes.previous)) return false;
  std::swap(axes.last, axes.previous);
  return true;
}

bool PairSet::partsApart(std::size_t i, std::span<const Transform> X_WB, double by) {
  const Bodies& pair = pairs_[i];
  const structure::HapticStructure &a = *structures_[pair.a], &b = *structures_[pair.b];
  if (a.parts.size() == 1 && b.parts.size() == 1) return false;
  PairAxes& axes = axes_[i];
  if (axes.parts_backoff.shouldSkip()) return false;
  const Transform X_BA = X_WB[pair.b].inverse() * X_WB[pair.a];
  const Vector3d between_centres = X_BA * a.bounding_sphere.centre - b.bounding_sphere.centre;
  const Vector3d n = axes.last.in_b.isZero() ? between_centres.normalized() : axes.last.in_b;
  FacingParts::Parts between;
  if (FacingParts(a, b, X_BA, by, false, axes.of_parts).apart(n, between)) {
    axes.parts_backoff = {};
    return true;
  }
  axes.parts_backoff.failed(kPartsBackoff, kMaxPartsBackoff);
  return false;
}

// Frank-Wolfe iteration on the Minkowski difference of the two hulls (Frank, Wolfe 1956): from pair to pair
// of support points, always to the nearest point of the segment. Gilbert, Johnson, Keerthi 1988 keep more
// vertices.
bool PairSet::findAxis(std::size_t i, std::span<const Transform> X_WB, double by) {
  PairAxes& axes = axes_[i];
  if (axes.hull_backoff.shouldSkip()) return false;
  const Bodies& pair = pairs_[i];
  const structure::HapticStructure &a = *structures_[pair.a], &b = *structures_[pair.b];
  const Transform &X_WA = X_WB[pair.a], &X_WB_b = X_WB[pair.b];
  Vector3d v = spheres_[pair.a].centre - spheres_[pair.b].centre;
  for (int step = 0; step < kAxisSteps && v.squaredNorm() > 0.0; ++step) {
    const Vector3d n = v.normalized();
    const Vector3d w = X_WA * a.support.extreme(X_WA.linear().transpose() * -n).point -
                       X_WB_b * b.support.extreme(X_WB_b.linear().transpose() * n).point;
    if (n.dot(w) > by && separationAlong(n, {a, X_WA}, {b, X_WB_b}, false) > by + kPlaneRounding) {
      storeAxis(i, X_WB, n);
      return true;
    }
    const Vector3d direction = w - v;
    const double t = direction.squaredNorm() > 0.0
                         ? std::clamp(-v.dot(direction) / direction.squaredNorm(), 0.0, 1.0)
                         : 0.0;
    if (step == 0)
      v = w;
    else
      v += t * direction;
  }
  axes.hull_backoff.failed(kHullBackoff, kMaxHullBackoff);
  return false;
}

void PairSet::storeAxis(std::size_t i, std::span<const Transform> X_WB, const Vector3d& n) {
  PairAxes& axes = axes_[i];
  const SeparatingAxis axis{X_WB[pairs_[i].a].linear().transpose() * n,
                            X_WB[pairs_[i].b].linear().transpose() * n};
  if (axis.in_a.dot(axes.last.in_a) < kSameAxis) axes.previous = axes.last;
  axes.last = axis;
  axes.hull_backoff = {};
}

}  // namespace abstand::query
