// The searches for any machine.
#include "core/haptic/search_kernels.inl"

namespace abstand {
extern const SearchKernels kPortableKernels{nearest, contacts, support, "portable"};
}  // namespace abstand
