// Wall time: the one place that knows it.
#pragma once

#include <chrono>
#include <thread>

namespace abstand {

/// Absolute deadlines; a late step moves the grid, so there is no catching up in bursts.
class Pacer {
 public:
  using Clock = std::chrono::steady_clock;
  explicit Pacer(std::chrono::nanoseconds period) : period_{period}, next_{Clock::now() + period} {}

  /// Sleeps until the deadline; false when it had passed already.
  bool wait() {
    const bool late = Clock::now() > next_;
    std::this_thread::sleep_until(next_);
    next_ = late ? Clock::now() + period_ : next_ + period_;
    return !late;
  }

 private:
  std::chrono::nanoseconds period_;
  Clock::time_point next_;
};

}  // namespace abstand
