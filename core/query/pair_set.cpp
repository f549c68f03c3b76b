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
constexpr std::uint32_t kSettledQueries = 16, kMaxIdle = 64, kPartsIdle = 4, kMaxPartsIdle = 16;
// Cosine of the largest angle between axes that count as the same.
constexpr double kSameLine = 0.98;

}  // namespace

PairSet::PairSet(std::vector<const structure::HapticStructure*> structures, std::vector<Bodies> pairs)
    : structures_(std::move(structures)),
      pairs_(std::move(pairs)),
      balls_(structures_.size()),
      lines_(pairs_.size()),
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
  place(X_WB);
  touches_.clear();
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Bodies& pair = pairs_[i];
    if (ballsApart(pair, options.margin) || knownApart(i, X_WB, options.margin)) continue;
    if (seekLine(i, X_WB, options.margin) || partsApart(i, X_WB, options.margin)) continue;
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
  place(X_WB);
  const std::uint32_t first = nearest_.pair;
  // Forces are computed for the nearest pair only.
  const auto query = [&](std::size_t i, PairResult& result) {
    const Bodies& pair = pairs_[i];
    const bool touches =
        queryDistance({*structures_[pair.a], X_WB[pair.a]}, {*structures_[pair.b], X_WB[pair.b]}, options,
                      {memories_[i], scratch_}, result);
    const Vector3d between = result.witness_a - result.witness_b;
    if (result.distance > 0.0) keepLine(i, X_WB, between / between.norm());
    return touches;
  };
  bool touching = query(first, nearest_.result);
  PairResult result;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const double least = nearest_.result.distance;
    if (i == first || ballsApart(pairs_[i], least) || knownApart(i, X_WB, least) ||
        partsApart(i, X_WB, least))
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

void PairSet::Backoff::failed(std::uint32_t least, std::uint32_t most) {
  left = next = std::clamp(2 * next, least, most);
}

void PairSet::place(std::span<const Transform> X_WB) {
  for (std::size_t i = 0; i < structures_.size(); ++i) {
    const geometry::EnclosingSphere& sphere = structures_[i]->bounding_sphere;
    const Vector3d centre = X_WB[i] * sphere.centre;
    balls_[i] = {centre, sphere.radius + kAxisRounding * (sphere.radius + centre.lpNorm<1>())};
  }
}

bool PairSet::ballsApart(const Bodies& pair, double by) const {
  const Ball &a = balls_[pair.a], &b = balls_[pair.b];
  const double reach = a.radius + b.radius + by;
  return reach < 0.0 || (a.centre - b.centre).squaredNorm() > reach * reach;
}

bool PairSet::knownApart(std::size_t i, std::span<const Transform> X_WB, double by) {
  const Bodies& pair = pairs_[i];
  Lines& lines = lines_[i];
  const auto apart = [&](const Vector3d& n) {
    return separationAlong(n, {*structures_[pair.a], X_WB[pair.a]}, {*structures_[pair.b], X_WB[pair.b]},
                           false) > by + kPlaneRounding;
  };
  const auto known = [&](const Line& line) {
    return !line.in_a.isZero() &&
           (apart(X_WB[pair.a].linear() * line.in_a) || apart(X_WB[pair.b].linear() * line.in_b));
  };
  if (known(lines.last)) return true;
  if (!known(lines.before)) return false;
  std::swap(lines.last, lines.before);
  return true;
}

bool PairSet::partsApart(std::size_t i, std::span<const Transform> X_WB, double by) {
  const Bodies& pair = pairs_[i];
  const structure::HapticStructure &a = *structures_[pair.a], &b = *structures_[pair.b];
  if (a.parts.size() == 1 && b.parts.size() == 1) return false;
  Lines& lines = lines_[i];
  if (lines.parts.waits()) return false;
  const Transform X_BA = X_WB[pair.b].inverse() * X_WB[pair.a];
  const Vector3d between_balls = X_BA * a.bounding_sphere.centre - b.bounding_sphere.centre;
  const Vector3d n = lines.last.in_b.isZero() ? between_balls.normalized() : lines.last.in_b;
  FacingParts::Parts between;
  if (FacingParts(a, b, X_BA, by, false, lines.of_parts).apart(n, between)) {
    lines.parts = {};
    return true;
  }
  lines.parts.failed(kPartsIdle, kMaxPartsIdle);
  return false;
}

// Frank-Wolfe iteration on the Minkowski difference of the two hulls (Frank, Wolfe 1956): from pair to pair
// of support points, always to the nearest point of the segment. Gilbert, Johnson, Keerthi 1988 keep more
// vertices.
bool PairSet::seekLine(std::size_t i, std::span<const Transform> X_WB, double by) {
  Lines& lines = lines_[i];
  if (lines.hulls.waits()) return false;
  const Bodies& pair = pairs_[i];
  const structure::HapticStructure &a = *structures_[pair.a], &b = *structures_[pair.b];
  const Transform &X_WA = X_WB[pair.a], &X_WB_b = X_WB[pair.b];
  Vector3d v = balls_[pair.a].centre - balls_[pair.b].centre;
  for (int step = 0; step < kAxisSteps && v.squaredNorm() > 0.0; ++step) {
    const Vector3d n = v.normalized();
    const Vector3d w = X_WA * a.support.extreme(X_WA.linear().transpose() * -n).point -
                       X_WB_b * b.support.extreme(X_WB_b.linear().transpose() * n).point;
    if (n.dot(w) > by && separationAlong(n, {a, X_WA}, {b, X_WB_b}, false) > by + kPlaneRounding) {
      keepLine(i, X_WB, n);
      return true;
    }
    const Vector3d way = w - v;
    const double t = way.squaredNorm() > 0.0 ? std::clamp(-v.dot(way) / way.squaredNorm(), 0.0, 1.0) : 0.0;
    if (step == 0)
      v = w;
    else
      v += t * way;
  }
  lines.hulls.failed(kSettledQueries, kMaxIdle);
  return false;
}

void PairSet::keepLine(std::size_t i, std::span<const Transform> X_WB, const Vector3d& n) {
  Lines& lines = lines_[i];
  const Line line{X_WB[pairs_[i].a].linear().transpose() * n, X_WB[pairs_[i].b].linear().transpose() * n};
  if (line.in_a.dot(lines.last.in_a) < kSameLine) lines.before = lines.last;
  lines.last = line;
  lines.hulls = {};
}

}  // namespace abstand::query
