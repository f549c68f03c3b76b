// The searches for machines with AVX2 and FMA; this file alone is compiled for them.
#include "core/haptic/search_kernels.inl"

namespace abstand {
extern const SearchKernels kAvx2Kernels{nearest, nearestOutside, contacts, contactSearch,
                                        support, extreme,        meeting,  "avx2"};
}  // namespace abstand
