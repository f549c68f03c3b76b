#include "core/haptic/grid.hpp"

#include <cmath>

#include "core/base/error.hpp"

namespace abstand {
namespace {

// A body whose extent is a whole number of voxels must not lose one to rounding.
constexpr double kRounding = 1e-9;
constexpr double kMostVoxelsAlong = 30000.0;

}  // namespace

VoxelGrid makeGrid(const Bounds& box, double voxel_size, int outer_layers) {
  VoxelGrid grid;
  grid.voxel_size = voxel_size;
  for (int i = 0; i < 3; ++i) {
    const double inner = std::floor(box.extent()[i] / voxel_size + kRounding) + 1.0;
    if (!(inner + 2.0 * outer_layers < kMostVoxelsAlong))
      throw UsageError("the body is too large for voxels of " + std::to_string(voxel_size) +
                       " m: more than " + std::to_string(static_cast<int>(kMostVoxelsAlong)) +
                       " along one axis");
    grid.size[i] = static_cast<int>(inner) + 2 * outer_layers;
    grid.first_centre[i] = box.centre()[i] - 0.5 * voxel_size * (grid.size[i] - 1);
  }
  return grid;
}

}  // namespace abstand
