// Compares one result of the engine with the true distance.
#include "core/verify/bound_judge.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::verify {
namespace {

// Share of all lengths of a pose: rounding error of the brute force in double.
constexpr double kOraclePart = 1e-12;
// Share of a voxel: width of the enclosure of depths.
constexpr double kDepthTolerance = 0.05;

}  // namespace

BoundJudge::BoundJudge(const AdversarialBody& a, const Transform& X_WA, const AdversarialBody& b,
                       const Transform& X_WB) {
  const bool from_a = query::pointsFromA(*a.structures[0], *b.structures[0]);
  const AdversarialBody &P = from_a ? a : b, &F = from_a ? b : a;
  const Transform X_FP = from_a ? Transform(X_WB.inverse() * X_WA) : Transform(X_WA.inverse() * X_WB);
  const auto [min_voxel, voxel] = std::minmax(P.options.voxel_size, F.options.voxel_size);
  voxel_ = voxel;
  size_ = P.radius + F.radius + X_FP.translation().norm();
  rounding_ = kOraclePart * (size_ + X_WA.translation().norm());
  exact_ = exactDistance(P, F, X_FP, kDepthTolerance * min_voxel);
}

BoundAnswer BoundJudge::operator()(const query::PairResult& r) const {
  BoundAnswer answer;
  // The negated form treats NaN as a breach.
  answer.breach = !(r.distance - r.bound <= exact_.upper + rounding_);
  answer.used = r.bound > 0.0 ? (r.distance - exact_.upper) / r.bound : (answer.breach ? kInfinity : 0.0);
  answer.below = std::max(0.0, exact_.lower - r.distance - rounding_) / size_;
  if (std::isfinite(exact_.lower))
    answer.error = std::max({0.0, r.distance - exact_.upper, exact_.lower - r.distance}) / voxel_;
  return answer;
}

}  // namespace abstand::verify
