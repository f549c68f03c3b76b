// What this process has used so far.
#pragma once

#include <map>
#include <string>

namespace abstand::studio {

/// Processor time (s) of the living threads of this process, by name; threads of equal names are summed, and
/// a number at the end of a name is left out. The first thread is "gui".
std::map<std::string, double> processorTimes();
/// Processor time (s) of the calling thread.
double ownProcessorTime();
/// Time since the process was started, s, in steps of the kernel's clock ticks (10 ms).
double processAge();
/// Resident memory, MB.
double residentMegabytes();
/// Memory that the process holds of the heap, MB; 0 with an allocator that is not that of the C library.
double allocatedMegabytes();

}  // namespace abstand::studio
