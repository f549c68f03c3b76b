// The nearest pair of points on two exact surfaces, from a good start. Internal to the engine.
#pragma once

#include "core/structure/haptic_structure.hpp"

namespace abstand::query {

/// Two points, one on each surface, in the frame of the field body F, and their signed distance (negative
/// when `on_points` lies inside F; then |distance| is its depth).
struct Witness {
  Vector3d on_points{Vector3d::Zero()};
  Vector3d on_field{Vector3d::Zero()};
  double distance{0.0};
  std::uint32_t hint_points{geometry::kNoHint};  ///< where on the surfaces they are
  std::uint32_t hint_field{geometry::kNoHint};
};

/// Where refineWitness() starts, in F's frame.
struct WitnessStart {
  Vector3d point;      ///< on P's surface
  Vector3d normal;     ///< of P's surface there, unit, either sign
  double step;         ///< m; of the first step inside
  std::uint32_t hint;  ///< where on F an answer nearby was found
};

/// Local search for the nearest pair of points of P and F, downhill in the exact signed distance to F along
/// P's surface: apart, by alternating projections, which never lengthen the distance; inside, by projected
/// steps against the gradient of F's near field, or of the exact distance where F has none, which is much
/// slower. The distance is exact whatever led to it. No allocation, no throw.
Witness refineWitness(const structure::HapticStructure& P, const structure::HapticStructure& F,
                      const Transform& X_FP, const WitnessStart& start) noexcept;

/// Stays with `start`, outside of F, and finds the point of F's surface that is nearest to it, or one that is
/// no farther than `enough` (m).
Witness footWitness(const geometry::Surface& field, const Vector3d& start, std::uint32_t hint,
                    double enough) noexcept;

/// To the nearest points of the two triangles on which they are; nothing changes where a body has none.
void slideWitness(const geometry::Surface& points, const geometry::Surface& field, const Transform& X_FP,
                  Witness& w) noexcept;

/// One round of projections within the neighbourhoods of two points that are apart (Surface::nearby), which
/// costs little when they have not far to go. False when it gained next to nothing.
bool walkWitness(const geometry::Surface& points, const geometry::Surface& field, const Transform& X_FP,
                 Witness& w) noexcept;

/// The walk from two points that are apart, until a round of projections gains less than 0.1 % of the
/// distance.
void approachWitness(const geometry::Surface& points, const geometry::Surface& field, const Transform& X_FP,
                     Witness& w) noexcept;

}  // namespace abstand::query
