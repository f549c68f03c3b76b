// Distances between voxels of a grid, counted in steps.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::field {

inline constexpr std::int16_t kMaxSteps = std::numeric_limits<std::int16_t>::max();

/// Chessboard distance transform in place: of each voxel the least of steps[w] + `step` times the number of
/// 26-neighbour steps from w, over all voxels w (kMaxSteps: not a source). size: voxels along x, y and z; x
/// runs first. Two sweeps over half of the neighbours each: Rosenfeld, Pfaltz, Distance Functions on Digital
/// Pictures (1968).
void countSteps(const Vector3i& size, int step, std::vector<std::int16_t>& steps);

}  // namespace abstand::field
