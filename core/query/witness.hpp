// Local search for the nearest points of two exact surfaces. Internal to the engine.
#pragma once

#include "core/structure/haptic_structure.hpp"

namespace abstand::query {

/// A point on each surface, in the frame of the field body F, and their signed distance (negative if
/// `on_points` is inside F; |distance| is then its depth).
struct Witness {
  Vector3d on_points{Vector3d::Zero()};
  Vector3d on_field{Vector3d::Zero()};
  double distance{0.0};
  std::uint32_t hint_points{geometry::kNoHint};  ///< locations on the surfaces
  std::uint32_t hint_field{geometry::kNoHint};
};

/// Start of refineWitness(), in F's frame.
struct WitnessStart {
  Vector3d point;      ///< on P's surface
  Vector3d normal;     ///< of P's surface there, unit, either sign
  double step;         ///< m; length of the first step inside
  std::uint32_t hint;  ///< location on F of a nearby point
};

/// Local search for the nearest points of P and F, descending in the exact signed distance to F along P's
/// surface: apart, by alternating projections, which never increase the distance; inside, by projected
/// gradient steps in F's near field, or in the exact distance if F has none, which is much slower. The
/// returned distance is exact. No allocation, no throw.
Witness refineWitness(const structure::HapticStructure& P, const structure::HapticStructure& F,
                      const Transform& X_FP, const WitnessStart& start) noexcept;

/// Keeps `start`, which is outside of F, and finds the nearest point of F's surface, or one within
/// `max_distance` (m).
Witness footWitness(const geometry::Surface& field, const Vector3d& start, std::uint32_t hint,
                    double max_distance) noexcept;

/// Moves both points to the nearest points of the two triangles that they lie on; no effect if a body has no
/// triangles.
void slideWitness(const geometry::Surface& points, const geometry::Surface& field, const Transform& X_FP,
                  Witness& w) noexcept;

/// One round of alternating projections within the neighbourhoods of two points that are apart
/// (Surface::nearby); fast if the points are close to the minimum. False if the gain is negligible.
bool projectWitness(const geometry::Surface& points, const geometry::Surface& field, const Transform& X_FP,
                    Witness& w) noexcept;

/// Repeats projectWitness() until a round gains less than 0.1 % of the distance.
void convergeWitness(const geometry::Surface& points, const geometry::Surface& field, const Transform& X_FP,
                     Witness& w) noexcept;

}  // namespace abstand::query
