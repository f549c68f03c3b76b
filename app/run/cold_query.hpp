// A pair of a scene, queried beside the scene's own steps.
#pragma once

#include "core/scene/scene.hpp"

namespace abstand::run {

/// From the present poses alone, without what the scene's warm start knows; the scene stays as it is. No
/// allocation, no throw.
inline query::PairResult queryCold(const scene::Scene& scene, const scene::Pair& pair,
                                   kernels::PairScratch& scratch) noexcept {
  const scene::Object& a = scene.object(pair.a);
  const scene::Object& b = scene.object(pair.b);
  query::PairResult result;
  query::queryPair({*a.spec.structure, a.X_WB}, {*b.spec.structure, b.X_WB}, pair.options, scratch, result);
  return result;
}

}  // namespace abstand::run
