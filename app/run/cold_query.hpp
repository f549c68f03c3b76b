// Cold query of a pair outside of the scene's steps.
#pragma once

#include "core/scene/scene.hpp"

namespace abstand::run {

/// Uses the current poses only, without the scene's warm start; does not change the scene. No allocation, no
/// throw.
inline query::PairResult queryCold(const scene::Scene& scene, const scene::Pair& pair,
                                   kernels::PairScratch& scratch) noexcept {
  const scene::Object& a = scene.object(pair.a);
  const scene::Object& b = scene.object(pair.b);
  query::PairResult result;
  query::queryPair({*a.spec.structure, a.X_WB}, {*b.spec.structure, b.X_WB}, pair.options, scratch, result);
  return result;
}

}  // namespace abstand::run
