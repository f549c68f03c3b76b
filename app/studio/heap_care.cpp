#include "app/studio/heap_care.hpp"

#include <malloc.h>

#include <algorithm>
#include <thread>

namespace abstand::studio {

void limitArenas() {
#ifdef M_ARENA_MAX
  ::mallopt(M_ARENA_MAX, std::max(2, static_cast<int>(std::thread::hardware_concurrency())));
#endif
}

void releaseFreeHeap() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

}  // namespace abstand::studio
