// Clock of the live loop; replaced in tests.
#pragma once

#include <chrono>
#include <thread>

namespace abstand::loop {

/// Loop thread only.
class LiveClock {
 public:
  virtual ~LiveClock() = default;
  virtual double now() = 0;               ///< s, monotonic
  virtual void sleepUntil(double t) = 0;  ///< s; returns at once when `t` has passed
};

class SteadyLiveClock final : public LiveClock {
 public:
  double now() override {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  void sleepUntil(double t) override {
    const double wait = t - now();
    if (wait > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(wait));
  }
};

}  // namespace abstand::loop
