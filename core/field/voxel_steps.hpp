// Chessboard distances between voxels of a grid.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::field {

inline constexpr std::int16_t kMaxSteps = std::numeric_limits<std::int16_t>::max();

/// Chessboard distance transform, in place: each voxel gets the minimum over all voxels w of steps[w] +
/// `step` times the number of 26-neighbour steps from w (kMaxSteps: not a source). size: voxels along x, y
/// and z; x fastest. Two sweeps over half of the neighbours each: Rosenfeld, Pfaltz, Distance Functions on
/// Digital Pictures (1968).
void countSteps(const Vector3i& size, int step, std::vector<std::int16_t>& steps);

}  // namespace abstand::field
