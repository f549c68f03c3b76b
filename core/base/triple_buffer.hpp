// Passes the newest value from one thread to another; neither waits.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace abstand {

/// One writer, one reader. The writer fills back() and publishes; the reader takes latest(), which
/// stays valid until its next call. Older values are dropped.
template <class T>
class TripleBuffer {
 public:
  explicit TripleBuffer(const T& initial = T{}) : slots_{initial, initial, initial} {}

  T& back() { return slots_[back_]; }
  void publish() { back_ = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kIndex; }

  /// True if latest() would return a new value.
  bool fresh() const { return (middle_.load(std::memory_order_relaxed) & kFresh) != 0; }
  const T& latest() {
    if (fresh()) front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return slots_[front_];
  }

 private:
  static constexpr std::uint8_t kIndex = 3, kFresh = 4;
  std::array<T, 3> slots_;
  std::atomic<std::uint8_t> middle_{1};
  std::uint8_t back_{0}, front_{2};
};

}  // namespace abstand
