// Threads that leave the processor to the others.
#pragma once

#include <sys/prctl.h>
#include <sys/resource.h>

namespace abstand {

/// Names the calling thread (at most 15 characters) and lowers its priority: the loop and the window go
/// first, and it gets about a tenth of their share where they want all cores. Threads that it starts inherit
/// this.
inline void beBackgroundThread(const char* name) {
  constexpr int kNice = 10;
  ::prctl(PR_SET_NAME, name);
  ::setpriority(PRIO_PROCESS, 0, kNice);  // on Linux: of this thread alone
}

}  // namespace abstand
