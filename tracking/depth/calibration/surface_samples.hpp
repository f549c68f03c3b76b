// Uniform samples of known surfaces.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/surface.hpp"

namespace abstand::tracking {

struct SurfaceSample {
  Vector3d p, normal;  ///< m; unit, outward; of body `body`, in its frame
  std::size_t body{0};
};

/// `count` points, uniform in area over all bodies. Deterministic for a seed.
std::vector<SurfaceSample> sampleSurfaces(std::span<const geometry::Surface* const> bodies, std::size_t count,
                                          std::uint64_t seed);

}  // namespace abstand::tracking
