// Box of grid cells. Internal to the engine.
#pragma once

#include "core/math/transform.hpp"

namespace abstand::field {

/// Voxels, blocks or tiles with first <= v < first + size. Index order: x fastest, then y, then z.
struct VoxelBox {
  Vector3i first, size;

  std::size_t count() const { return std::size_t(size.x()) * size.y() * size.z(); }
  bool contains(const Vector3i& v) const {
    return (v.array() >= first.array()).all() && (v.array() < (first + size).array()).all();
  }
  std::size_t index(const Vector3i& v) const {
    const Vector3i at = v - first;
    return (std::size_t(at.z()) * size.y() + at.y()) * size.x() + at.x();
  }
  Vector3i place(std::size_t index) const {
    const auto nx = static_cast<std::size_t>(size.x()), ny = static_cast<std::size_t>(size.y());
    return first + Vector3i(static_cast<int>(index % nx), static_cast<int>(index / nx % ny),
                            static_cast<int>(index / (nx * ny)));
  }
  VoxelBox clippedTo(const VoxelBox& other) const {
    const Vector3i lower = first.cwiseMax(other.first);
    const Vector3i upper = (first + size).cwiseMin(other.first + other.size);
    return {lower, (upper - lower).cwiseMax(0)};
  }
  /// Calls fn in the order of index().
  template <class Fn>
  void forEach(Fn&& fn) const {
    for (int k = 0; k < size.z(); ++k)
      for (int j = 0; j < size.y(); ++j)
        for (int i = 0; i < size.x(); ++i) fn(Vector3i(first + Vector3i(i, j, k)));
  }
};

}  // namespace abstand::field
