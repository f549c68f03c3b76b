// A clock for the live loop that only the loop itself moves, up to a limit that the test sets.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <mutex>

#include "app/loop/live_clock.hpp"

namespace abstand::testing {

/// Time as a test wants it: looking at the clock costs `look` s, so that whatever stands between two looks
/// takes as long; sleeping takes as long as was asked for. Beyond the limit the loop waits for the test.
class ManualTime {
 public:
  explicit ManualTime(double look) : look_(look) {}

  double now() {
    const std::lock_guard lock(mutex_);
    return t_ += look_;
  }
  void sleepUntil(double t) {
    std::unique_lock lock(mutex_);
    t_ = std::max(t_, t);
    waits_ = true;
    changed_.notify_all();
    changed_.wait(lock, [&] { return t_ < limit_; });
    waits_ = false;
  }
  /// Lets the loop run until time `limit` (s), and waits until it has come there. Gives the time.
  double runTo(double limit) {
    std::unique_lock lock(mutex_);
    limit_ = limit;
    changed_.notify_all();
    changed_.wait(lock, [&] { return waits_ && t_ >= limit_; });
    return t_;
  }
  /// No limit any more.
  void release() {
    const std::lock_guard lock(mutex_);
    limit_ = 1e300;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  double t_{0.0}, look_, limit_{0.0};
  bool waits_{false};
};

class ManualClock final : public loop::LiveClock {
 public:
  explicit ManualClock(ManualTime& time) : time_(time) {}
  double now() override { return time_.now(); }
  void sleepUntil(double t) override { time_.sleepUntil(t); }

 private:
  ManualTime& time_;
};

}  // namespace abstand::testing
