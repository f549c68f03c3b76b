// Voxel grid shared by the voxelmap and the distance fields.
#include "core/field/grid.hpp"

#include <cmath>
#include <sstream>

#include "core/base/error.hpp"

namespace abstand::field {

VoxelGrid makeGrid(const geometry::Bounds& box, double voxel_size, int outer_layers) {
  // An extent within this relative error of a multiple of the voxel size counts as that multiple.
  constexpr double kStepRounding = 1e-9;
  const Vector3d steps = (box.extent() / voxel_size).array() + kStepRounding;
  const Vector3d counts = steps.array().floor() + 1.0 + 2.0 * outer_layers;
  if (!(counts.prod() <= kMaxVoxels)) {
    std::ostringstream message;
    message << "a voxel size of " << voxel_size << " m makes " << counts.x() << " x " << counts.y() << " x "
            << counts.z() << " voxels of a body of " << box.extent().x() << " x " << box.extent().y() << " x "
            << box.extent().z() << " m; at most " << kMaxVoxels << " are made, so a voxel size of "
            << voxel_size * std::cbrt(counts.prod() / kMaxVoxels) * 1.05
            << " m or fewer outer layers would do";
    throw UsageError(message.str());
  }
  VoxelGrid grid;
  grid.voxel_size = voxel_size;
  grid.size = counts.cast<int>();
  grid.first_centre = box.centre() - 0.5 * voxel_size * (grid.size - Vector3i::Ones()).cast<double>();
  return grid;
}

}  // namespace abstand::field
