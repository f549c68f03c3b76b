// Calibrates body sizes and marker positions of a person.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tracking/markers/body_sizes.hpp"
#include "tracking/markers/marker_set.hpp"
#include "tracking/markers/marker_solver.hpp"

namespace abstand::tracking {

/// Positions of all markers at one time, world, m; NaN if missing.
using MarkerPlaces = std::vector<Vector3d>;

struct MarkerBody {
  SizeVector sizes{sameSizes()};
  BodyRig rig;                     ///< the base, resized
  std::vector<RigMarker> markers;  ///< positions on it, in the order of those found
};

/// Body sizes and marker positions that fit `moments` best, with a pose for each.
///
/// Joint least squares over everything: the poses are eliminated moment by moment (Schur complement), so that
/// a longer thigh is found although every single pose could bend to fit a short one. Priors decide what the
/// markers leave undetermined: stature +- 10 % of the base (of `stature`, m, if known: +- 1 % of that), bones
/// +- 5 % beyond it (breadths 8 %), and each marker within its spread around the set's position. As the
/// moments of one movement have correlated errors, they count as at most ten against the priors. Robust
/// weights exclude outliers.
MarkerBody calibrate(const BodyRig& base, std::span<const FoundMarker> found,
                     std::span<const MarkerPlaces> moments, std::optional<double> stature = std::nullopt);

/// Segments with markers, or with a descendant that has markers.
std::array<bool, kRigSegments> observedSegments(const BodyRig& rig, std::span<const RigMarker> markers);

/// Weights (1/rad^2) that pull dof of segments without markers, on them or beyond, towards standing: the
/// trunk stays straight, limbs hang.
BodySolver::Vector restWeights(const BodyRig& rig, std::span<const RigMarker> markers);

}  // namespace abstand::tracking
