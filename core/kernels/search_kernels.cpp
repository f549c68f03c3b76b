// Selects the search kernels for this CPU.
#include "core/kernels/search_kernels.hpp"

#include <cstdlib>
#include <cstring>

namespace abstand::kernels {
namespace {

const SearchKernels& chosen() {
#ifdef ABSTAND_AVX2_KERNELS
  const char* simd = std::getenv("ABSTAND_SIMD");
  const bool off = simd != nullptr && std::strcmp(simd, "off") == 0;
  if (!off && __builtin_cpu_supports("avx2")) return kAvx2Kernels;
#endif
  return kPortableKernels;
}

}  // namespace

const SearchKernels& searchKernels() {
  static const SearchKernels& kernels = chosen();
  return kernels;
}

}  // namespace abstand::kernels
