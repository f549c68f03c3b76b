// Parallel loop for building; never used in the cycle.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace abstand {

/// Called before every call of parallelFor, on the thread that makes the call. An exception thrown here ends
/// the loop like an exception of the call.
class LoopWatch {
 public:
  virtual ~LoopWatch() = default;
  /// Before call `index` of `count`. Called from several threads at once.
  virtual void next(std::size_t index, std::size_t count) = 0;
};
/// Watch of the loops that this thread starts, or null. Inherited by the threads of a loop, so that nested
/// loops are watched too.
inline thread_local LoopWatch* loop_watch = nullptr;

/// Calls fn(0) ... fn(count - 1), each once, on up to `threads` threads (0: hardware concurrency), in no
/// fixed order. The result is independent of the number of threads if each call writes only data of its own
/// index. The first exception is rethrown after all threads have ended.
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
