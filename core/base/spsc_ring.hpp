// Lock-free ring buffer between two threads; the writer counts lost samples.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <vector>

namespace abstand {

/// One writer, one reader, N slots (a power of two).
template <class T, std::size_t N>
class SpscRing {
  static_assert(std::has_single_bit(N), "N is a power of two");

 public:
  /// False if the ring is full: the caller counts the loss.
  bool push(const T& value) {
    const auto head = head_.load(std::memory_order_relaxed);
    if (head - tail_.load(std::memory_order_acquire) == N) return false;
    data_[head & (N - 1)] = value;
    head_.store(head + 1, std::memory_order_release);
    return true;
  }

  /// Appends all available values to `out`; returns their number.
  std::size_t drainInto(std::vector<T>& out) {
    const auto tail = tail_.load(std::memory_order_relaxed);
    const auto head = head_.load(std::memory_order_acquire);
    for (auto i = tail; i != head; ++i) out.push_back(data_[i & (N - 1)]);
    tail_.store(head, std::memory_order_release);
    return head - tail;
  }

 private:
  std::array<T, N> data_{};
  alignas(64) std::atomic<std::size_t> head_{0};
  alignas(64) std::atomic<std::size_t> tail_{0};
};

}  // namespace abstand
