// Search kernels for AVX2; only this file is compiled with -mavx2. Without -mfma: a fused operation rounds
// once instead of twice, and all CPUs must give the same bits.
#include "core/kernels/search_kernels.inl"

namespace abstand::kernels {
extern const SearchKernels kAvx2Kernels{nearest, nearestOutside, contacts, contactSearch,
                                        support, extreme,        meeting,  "avx2"};
}  // namespace abstand::kernels
