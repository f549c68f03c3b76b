// Bounding spheres of the parts of a body as a structure of arrays.
#pragma once

#include <cstddef>

namespace abstand::kernels {

/// Up to kMax spheres in the body's frame (m), padded to eight lanes. Unused ones have the radius -infinity.
struct SphereGroup {
  static constexpr std::size_t kMax = 8;
  float x[kMax], y[kMax], z[kMax], radius[kMax];
};

}  // namespace abstand::kernels
