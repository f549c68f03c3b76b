#include "core/scene/pair_workers.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::scene {
namespace {
constexpr std::uint64_t kIndexMask = 0xffffffffu;
}

PairWorkers::PairWorkers(int helpers) {
  try {
    for (int i = 0; i < helpers; ++i)
      helpers_.emplace_back([this, thread = static_cast<std::size_t>(i) + 1] { workerLoop(thread); });
  } catch (...) {
    stopAll();
    throw;
  }
}

PairWorkers::~PairWorkers() { stopAll(); }

void PairWorkers::stopAll() noexcept {
  stop_.store(true, std::memory_order_relaxed);
  cycle_.fetch_add(1, std::memory_order_release);
  cycle_.notify_all();
  for (auto& helper : helpers_) helper.join();
}

void PairWorkers::run(std::size_t count, Task task, void* context) noexcept {
  ABSTAND_CHECK(count <= kIndexMask);
  if (count == 0) return;
  task_ = task;
  context_ = context;
  unfinished_.store(static_cast<std::uint32_t>(count), std::memory_order_relaxed);
  const std::uint32_t cycle = cycle_.load(std::memory_order_relaxed) + 1;
  ticket_.store(std::uint64_t{cycle} << 32 | count, std::memory_order_release);
  cycle_.store(cycle, std::memory_order_release);
  cycle_.notify_all();

  runTasks(0);
  for (auto left = unfinished_.load(std::memory_order_acquire); left != 0;
       left = unfinished_.load(std::memory_order_acquire))
    unfinished_.wait(left, std::memory_order_acquire);
}

void PairWorkers::workerLoop(std::size_t thread) noexcept {
  std::uint32_t seen = 0;
  for (;;) {
    cycle_.wait(seen, std::memory_order_acquire);
    seen = cycle_.load(std::memory_order_acquire);
    if (stop_.load(std::memory_order_relaxed)) return;
    runTasks(thread);
  }
}

void PairWorkers::runTasks(std::size_t thread) noexcept {
  // Large shares first, single pairs at the end, so that all threads finish at the same time.
  const std::uint64_t shares = 2 * (helpers_.size() + 1);
  std::uint64_t ticket = ticket_.load(std::memory_order_acquire);
  while ((ticket & kIndexMask) != 0) {
    const std::uint64_t left = ticket & kIndexMask;
    const std::uint64_t n = std::max<std::uint64_t>(1, left / shares);
    if (!ticket_.compare_exchange_weak(ticket, ticket - n, std::memory_order_acq_rel,
                                       std::memory_order_acquire))
      continue;
    for (std::uint64_t i = left - n; i < left; ++i) task_(context_, i, thread);
    if (unfinished_.fetch_sub(static_cast<std::uint32_t>(n), std::memory_order_acq_rel) == n)
      unfinished_.notify_one();
    ticket = ticket_.load(std::memory_order_acquire);
  }
}

}  // namespace abstand::scene
