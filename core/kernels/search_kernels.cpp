// Selects the search kernels for this CPU.
#include "core/kernels/search_kernels.hpp"

#include "core/base/simd.hpp"

namespace abstand::kernels {
namespace {

const SearchKernels& chosen() {
#ifdef ABSTAND_AVX2_KERNELS
  if (usesAvx2()) return kAvx2Kernels;
#endif
  return kPortableKernels;
}

}  // namespace

const SearchKernels& searchKernels() {
  static const SearchKernels& kernels = chosen();
  return kernels;
}

}  // namespace abstand::kernels
