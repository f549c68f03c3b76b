// Search kernels for any CPU.
#include "core/kernels/search_kernels.inl"

namespace abstand::kernels {
extern const SearchKernels kPortableKernels{nearest, nearestOutside, contacts, contactSearch,
                                            support, extreme,        meeting,  "portable"};
}  // namespace abstand::kernels
