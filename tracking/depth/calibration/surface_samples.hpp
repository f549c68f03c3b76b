// Points spread over known surfaces, to be looked for in depth images.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/surface.hpp"

namespace abstand::tracking {

struct SurfaceSample {
  Vector3d p, normal;  ///< m; unit, outwards; of body `body`, in its frame
  std::size_t body{0};
};

/// `count` points, the same number on the same area whichever body it belongs to. The same for the same seed.
std::vector<SurfaceSample> sampleSurfaces(std::span<const geometry::Surface* const> bodies, std::size_t count,
                                          std::uint64_t seed);

}  // namespace abstand::tracking
