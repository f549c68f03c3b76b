#include "core/base/interrupt.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>

namespace abstand {
namespace {

constexpr int kInterruptedCode = 130;

// timeout(1) and some terminal wrappers signal the process and its process group, so the signal arrives twice
// at once. Only a signal later than this counts as the second.
constexpr std::int64_t kSameSignalNs = 250'000'000;

// Time of the first signal (ns); 0 before it.
std::atomic<std::int64_t> first{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

extern "C" void onInterrupt(int) {
  struct timespec now {};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  const std::int64_t time = now.tv_sec * std::int64_t{1'000'000'000} + now.tv_nsec;
  std::int64_t before = 0;
  if (!first.compare_exchange_strong(before, time) && time - before > kSameSignalNs)
    ::_exit(kInterruptedCode);
}

}  // namespace

void catchInterrupts() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old {};
    if (::sigaction(number, nullptr, &old) == 0 && old.sa_handler == SIG_IGN && number == SIGHUP) continue;
    struct sigaction action {};
    action.sa_handler = onInterrupt;
    ::sigemptyset(&action.sa_mask);
    ::sigaction(number, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interruptRequested() noexcept { return first.load(std::memory_order_relaxed) != 0; }

}  // namespace abstand
