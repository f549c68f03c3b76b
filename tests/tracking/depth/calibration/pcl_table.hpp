// Comparisons of filters of PCL with plain loops, for docs/camera-calibration.md.
#pragma once

namespace abstand::testing {

/// Normals of simulated images: errors, coverage, and times relative to those of RoomView.
void printNormals();

/// Thinned clouds: the same points or not, times relative to those of a hash map, and the poses of
/// generalised ICP with them.
void printVoxelGrids();

}  // namespace abstand::testing
