// A pair of a scene, queried beside the scene's own steps.
#pragma once

#include "core/scene/scene.hpp"

namespace abstand {

/// From the present poses alone, without what the scene's warm start knows; the scene stays as it is. No
/// allocation, no throw.
inline PairResult queryCold(const Scene& scene, const Pair& pair, PairScratch& scratch) noexcept {
  const Object& a = scene.object(pair.a);
  const Object& b = scene.object(pair.b);
  PairResult result;
  queryPair(*a.spec.structure, a.X_WB, *b.spec.structure, b.X_WB, pair.options, scratch, result);
  return result;
}

}  // namespace abstand
