// Contacts between the points of the pointshells.
#include "core/query/between_points.hpp"

#include <algorithm>

#include "core/kernels/search_kernels.hpp"
#include "core/query/witness.hpp"

namespace abstand::query {
namespace {

double distanceFrom(const PlacedBody& P, std::uint32_t near, const PlacedBody& F, double margin) {
  if (near == kernels::kNoPoint) return kInfinity;
  const Transform X_FP = F.X_WB.inverse() * P.X_WB;
  const Vector3d start = X_FP * P.body.tree.at(near);
  // A local search that starts outside stays outside.
  if (margin <= 0.0 && !F.body.surface->inside(start)) return kInfinity;
  const Vector3d normal = X_FP.linear() * P.body.tree.normalAt(near);
  return refineWitness(P.body, F.body, X_FP, {start, normal, P.body.shell.spacing, geometry::kNoHint})
      .distance;
}

}  // namespace

double depthBetweenPoints(const PlacedBody& a, std::uint32_t near_a, const PlacedBody& b,
                          std::uint32_t near_b, double margin) noexcept {
  const double smallest = std::min(distanceFrom(a, near_a, b, margin), distanceFrom(b, near_b, a, margin));
  return std::max(0.0, margin - smallest);
}

}  // namespace abstand::query
