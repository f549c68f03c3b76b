// A loop spread over threads, for building (never for the cycle).
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace abstand {

/// Hears of every call that parallelFor is about to make, on the thread that makes it. What it throws ends
/// the loop like an exception of the call.
class LoopWatch {
 public:
  virtual ~LoopWatch() = default;
  /// Call number `index` of `count`; from several threads at once.
  virtual void next(std::size_t index, std::size_t count) = 0;
};
/// The watch of the loops that this thread starts, or null. A loop hands it on to the threads that it starts,
/// so that loops within its calls are watched too.
inline thread_local LoopWatch* loop_watch = nullptr;

/// Calls fn(0) ... fn(count - 1), each once, on up to `threads` threads (0: as many as the machine has). The
/// calls run in no fixed order, so the result is independent of the number of threads when each call writes
/// only what belongs to its index. The first exception is thrown again here once all threads have ended.
template <class Fn>
void parallelFor(int threads, std::size_t count, Fn&& fn) {
  const std::size_t wanted = threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  const std::size_t workers = std::min(wanted, count);
  std::atomic<std::size_t> next{0};
  std::exception_ptr error;
  std::mutex error_mutex;
  LoopWatch* const watch = loop_watch;
  const auto work = [&] {
    try {
      loop_watch = watch;
      for (std::size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) {
        if (watch) watch->next(i, count);
        fn(i);
      }
    } catch (...) {
      next.store(count, std::memory_order_relaxed);
      const std::scoped_lock lock(error_mutex);
      if (!error) error = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t w = 1; w < workers; ++w) others.emplace_back(work);
    work();
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace abstand
