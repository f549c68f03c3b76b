// Keeps the memory of a program that opens scenes all day near what it uses.
#pragma once

namespace abstand::studio {

/// For the start of the program, before other threads: threads share as many arenas of the heap as can run at
/// the same time, at least two. With those of the C library, eight a processor, each thread of an opening may
/// leave the free memory of another arena behind. No effect with another C library.
void limitArenas();

/// Gives free memory of the heap back to the system; some milliseconds. Any thread.
void releaseFreeHeap();

}  // namespace abstand::studio
