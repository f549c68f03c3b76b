// Spacing of the far field's first grid.
#pragma once

#include "core/field/far_field.hpp"

namespace abstand::field {

/// Spacing (m) for a body with these bounds: a fixed number of voxels, or larger if a grid would need too
/// many vertices.
inline double farSpacing(const geometry::Bounds& body, double voxel_size) {
  constexpr double kVoxels = 3.0, kMaxVertices = 150'000.0;
  double h = kVoxels * voxel_size;
  const auto vertices = [&] { return (body.extent().array() / h + 2.0 * FarField::kMargin + 1.0).prod(); };
  while (vertices() > kMaxVertices) h *= 1.1;
  return h;
}

}  // namespace abstand::field
