// Periodic waiting on the steady clock.
#pragma once

#include <chrono>
#include <thread>

namespace abstand {

/// Absolute deadlines; a late step shifts all later deadlines, so there are no bursts to catch up.
class Pacer {
 public:
  using Clock = std::chrono::steady_clock;
  explicit Pacer(std::chrono::nanoseconds period) : period_{period}, next_{Clock::now() + period} {}

  /// Sleeps until the deadline; false if it had already passed.
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
