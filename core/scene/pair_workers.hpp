// Thread pool for the pairs of one cycle.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace abstand::scene {

/// Runs a task for each index of a range on the calling thread and on helper threads that sleep in between.
/// The assignment of indices to threads is not deterministic, so a task may only write data of its index. One
/// owner thread.
class PairWorkers {
 public:
  /// `task(context, index, thread)`; must not throw. `thread`: 0 is the caller, 1 to `helpers` the helpers;
  /// selects the thread's work space.
  using Task = void (*)(void* context, std::size_t index, std::size_t thread);

  /// Throws std::system_error if the system cannot create the threads.
  explicit PairWorkers(int helpers);
  ~PairWorkers();
  PairWorkers(const PairWorkers&) = delete;
  PairWorkers& operator=(const PairWorkers&) = delete;

  /// Returns when the task has run for every index of [0, count), count < 2^32. The caller works too and
  /// waits only for helpers that have taken indices, not for those still waking up. No allocation, no lock.
  void run(std::size_t count, Task task, void* context) noexcept;

 private:
  void workerLoop(std::size_t thread) noexcept;
  void runTasks(std::size_t thread) noexcept;
  void stopAll() noexcept;

  Task task_{nullptr};
  void* context_{nullptr};
  /// Number of indices left (low half) and cycle number (high half), so that a helper that wakes up late
  /// cannot take indices of a later cycle.
  alignas(64) std::atomic<std::uint64_t> ticket_{0};
  alignas(64) std::atomic<std::uint32_t> unfinished_{0};
  alignas(64) std::atomic<std::uint32_t> cycle_{0};
  std::atomic<bool> stop_{false};
  std::vector<std::thread> helpers_;
};

}  // namespace abstand::scene
