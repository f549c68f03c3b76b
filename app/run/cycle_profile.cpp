#include "app/run/cycle_profile.hpp"

#include <time.h>

#include <chrono>

namespace abstand::run {
namespace {

double processorTime() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

void CycleProfile::begin() { begun_ = processorTime(); }

void CycleProfile::end(double seconds) {
  const double ended = processorTime(), worked = ended - begun_;
  work_.add(worked);
  // The duration of the work itself, not including delays by other processes, which the empty loop would
  // inherit.
  const double wanted = worked < seconds ? worked : seconds;
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  double passed = 0.0;
  while (passed < wanted) passed = std::chrono::duration<double>(Clock::now() - begin).count();
  empty_.add(passed);
  empty_work_.add(processorTime() - ended);
}

}  // namespace abstand::run
