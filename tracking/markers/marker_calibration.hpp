// Whose body the markers are on: its sizes, and where each marker sits.
#pragma once

#include <span>
#include <vector>

#include "tracking/markers/body_sizes.hpp"
#include "tracking/markers/marker_set.hpp"
#include "tracking/markers/marker_solver.hpp"

namespace abstand::tracking {

/// Places of all markers at one moment, world, m; NaN where one is missing.
using MarkerPlaces = std::vector<Vector3d>;

struct MarkerBody {
  SizeVector sizes{sameSizes()};
  BodyRig rig;                     ///< the base, resized
  std::vector<RigMarker> markers;  ///< on it, in the order of those found
};

/// Sizes and places of markers that fit `moments` best, together with a pose for each.
///
/// Least squares over everything at once: the poses are eliminated moment by moment (Schur's complement), so
/// that a longer thigh is found although every single pose could bend to a short one. What the markers leave
/// open is decided by the priors: a stature of the base's +- 10 %, bones +- 5 % beyond it (breadths 8 %), and
/// each marker within its spread of the set's place. As the moments of one movement repeat each other's
/// errors, they count as ten at most against the priors. Weights are bounded: what does not belong is left
/// out.
MarkerBody calibrate(const BodyRig& base, std::span<const FoundMarker> found,
                     std::span<const MarkerPlaces> moments);

/// Segments that carry markers, or from which one hangs that does; all false beyond.
std::array<bool, kRigSegments> shownBy(const BodyRig& rig, std::span<const RigMarker> markers);

/// Freedoms of segments without markers, on them or beyond, are drawn to standing (1/rad^2): a trunk goes on
/// straight, limbs hang.
BodySolver::Vector drawnToRest(const BodyRig& rig, std::span<const RigMarker> markers);

}  // namespace abstand::tracking
