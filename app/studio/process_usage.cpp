#include "app/studio/process_usage.hpp"

#include <malloc.h>
#include <unistd.h>
#include <ctime>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace abstand::studio {

std::map<std::string, double> processorTimes() {
  std::map<std::string, double> times;
  std::error_code gone;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", gone)) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm"), name);
    double nanoseconds = 0.0;
    if (!(std::ifstream(task.path() / "schedstat") >> nanoseconds)) continue;
    if (task.path().filename() == std::to_string(::getpid())) name = "gui";
    name.resize(name.find_last_not_of("-0123456789") + 1);
    times[name] += 1e-9 * nanoseconds;
  }
  return times;
}

double ownProcessorTime() {
  timespec t{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double processAge() {
  // Field 22 of /proc/self/stat, proc(5); the second field is in brackets and may contain blanks.
  constexpr int kFieldsBeforeStart = 19;
  std::string line;
  std::getline(std::ifstream("/proc/self/stat"), line);
  std::istringstream fields(line.substr(std::min(line.size(), line.rfind(')') + 1)));
  std::string field;
  for (int i = 0; i < kFieldsBeforeStart; ++i) fields >> field;
  double start_ticks = 0.0, uptime = 0.0;
  if (!(fields >> start_ticks) || !(std::ifstream("/proc/uptime") >> uptime)) return 0.0;
  return uptime - start_ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

double residentMegabytes() {
  double size = 0.0, resident = 0.0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return 1e-6 * resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

double allocatedMegabytes() {
  const struct mallinfo2 heap = ::mallinfo2();
  return 1e-6 * static_cast<double>(heap.uordblks + heap.hblkhd);
}

}  // namespace abstand::studio
