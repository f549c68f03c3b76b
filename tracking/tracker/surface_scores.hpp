// Misfits of many points to surfaces of the rig.
#pragma once

#include <cstdint>

#include "tracking/tracker/body_view.hpp"
#include "tracking/tracker/fit_surface.hpp"

namespace abstand::tracking {

/// The points that are scored, and a term (m) for each, added to its misfit; null: none.
struct ScoredPoints {
  const SeenPoints& points;
  float normal_weight;  ///< m
  const float* extra{nullptr};
};

/// Misfit of every point to the segment: |d| plus `normal_weight` times (1 - n . normal of the point), plus
/// the extra term. Lowers `best` (m) to it.
void scoreOf(const FitSurface& s, const Transform& X_WS, const ScoredPoints& of, float* best);
/// The same, and where it is lower, `segment` becomes `index`.
void assignOf(const FitSurface& s, const Transform& X_WS, const ScoredPoints& of, std::int32_t index,
              float* best, std::int32_t* segment);

}  // namespace abstand::tracking
