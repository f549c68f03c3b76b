// Voxel grid shared by the voxelmap and the distance fields.
#pragma once

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::field {

/// Cubes with edge `voxel_size`; voxel (0,0,0) is centred at `first_centre`. Body frame, metres.
struct VoxelGrid {
  Vector3d first_centre{Vector3d::Zero()};
  double voxel_size{0.0};
  Vector3i size{Vector3i::Zero()};

  Vector3d centre(int i, int j, int k) const { return first_centre + voxel_size * Vector3d(i, j, k); }
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * size.y() + j) * size.x() + i;
  }
  std::size_t cells() const { return std::size_t(size.x()) * size.y() * size.z(); }
  /// The voxel that contains p; may be outside of the grid.
  Vector3i voxelOf(const Vector3d& p) const {
    return ((p - first_centre) / voxel_size).array().round().cast<int>();
  }
  bool contains(const Vector3i& v) const {
    return (v.array() >= 0).all() && (v.array() < size.array()).all();
  }
  template <class Archive>
  void archive(Archive& ar) {
    ar(first_centre, voxel_size, size);
  }
};

/// Diagonal of a cube, in edges.
inline constexpr double kCubeDiagonal = 1.7320508075688774;

/// Limit for one grid: some 2,000 voxels along each axis. Stored memory is proportional to the surface, plus
/// a few bytes for each block of 8^3 voxels.
inline constexpr double kMaxVoxels = 8e9;

/// The thesis's grid: floor(extent / s) + 1 voxels about the centre of `box`, plus `outer_layers` on every
/// side. A sphere of 0.05 m at 5 mm with 20 layers: 61 x 61 x 61 [thesis 5.3]. Throws UsageError for more
/// than kMaxVoxels voxels; the message gives the smallest possible voxel size.
VoxelGrid makeGrid(const geometry::Bounds& box, double voxel_size, int outer_layers);

}  // namespace abstand::field
