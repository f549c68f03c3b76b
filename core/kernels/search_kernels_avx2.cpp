// The searches for machines with AVX2; this file alone is compiled for them. Without -mfma: a fused operation
// rounds once where others round twice, and every machine gives the same bits.
#include "core/kernels/search_kernels.inl"

namespace abstand::kernels {
extern const SearchKernels kAvx2Kernels{nearest, nearestOutside, contacts, contactSearch,
                                        support, extreme,        meeting,  "avx2"};
}  // namespace abstand::kernels
