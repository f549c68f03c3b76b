// Ctrl-C during long calls that have released the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "core/structure/build_progress.hpp"

namespace abstand::python {

/// Made on the thread of the caller. poll() may be called on any thread, without the GIL; on the caller's it
/// takes the GIL ten times a second and throws what Python's handlers of signals raise.
class InterruptCheck {
 public:
  void poll() {
    if (std::this_thread::get_id() != caller_) return;
    const auto now = Clock::now();
    if (now < next_) return;
    next_ = now + kPeriod;
    const pybind11::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr auto kPeriod = std::chrono::milliseconds(100);

  std::thread::id caller_{std::this_thread::get_id()};
  Clock::time_point next_{Clock::now() + kPeriod};
};

/// Calls `work(monitor)` on a thread of its own, without the GIL, which the caller does not hold either; the
/// caller meanwhile asks Python for signals. What a handler raises ends the build that the monitor belongs
/// to, and is thrown here.
template <class Work>
void buildInterruptibly(Work work) {
  std::atomic<bool> cancelled{false};
  structure::BuildMonitor monitor;
  monitor.cancelled = [&cancelled] { return cancelled.load(std::memory_order_relaxed); };
  std::future<void> done = std::async(std::launch::async, [&] { work(monitor); });
  while (done.wait_for(std::chrono::milliseconds(20)) == std::future_status::timeout) {
    const pybind11::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() == 0) continue;
    pybind11::error_already_set raised;
    cancelled = true;
    const pybind11::gil_scoped_release release;
    done.wait();
    throw std::move(raised);
  }
  done.get();
}

}  // namespace abstand::python
