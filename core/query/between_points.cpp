// Contacts that the shell's points miss.
#include "core/query/between_points.hpp"

#include <algorithm>

#include "core/kernels/search_kernels.hpp"
#include "core/query/witness.hpp"

namespace abstand::query {
namespace {

double distanceFrom(const structure::HapticStructure& P, const Transform& X_WP, std::uint32_t near,
                    const structure::HapticStructure& F, const Transform& X_WF, double margin) {
  if (near == kernels::kNoPoint) return kInfinity;
  const Transform X_FP = X_WF.inverse() * X_WP;
  const Vector3d start = X_FP * P.tree.at(near);
  // A walk outside never leads inside.
  if (margin <= 0.0 && !F.surface->inside(start)) return kInfinity;
  return refineWitness(*P.surface, *F.surface, structure::nearField(F), X_FP, start,
                       X_FP.linear() * P.tree.normalAt(near), P.shell.spacing, geometry::kNoHint)
      .distance;
}

}  // namespace

double depthBetweenPoints(const structure::HapticStructure& a, const Transform& X_WA, std::uint32_t near_a,
                          const structure::HapticStructure& b, const Transform& X_WB, std::uint32_t near_b,
                          double margin) noexcept {
  const double least = std::min(distanceFrom(a, X_WA, near_a, b, X_WB, margin),
                                distanceFrom(b, X_WB, near_b, a, X_WA, margin));
  return std::max(0.0, margin - least);
}

}  // namespace abstand::query
