// Handles Ctrl-C during long calls that have released the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "core/structure/build_progress.hpp"

namespace abstand::python {

/// Created on the caller's thread. poll() may be called on any thread without the GIL; on the caller's thread
/// it acquires the GIL ten times a second and throws exceptions of Python's signal handlers.
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

/// Calls `work(monitor)` on a separate thread without the GIL; the caller does not hold it either, and
/// meanwhile checks Python's signals. An exception of a handler cancels the build of the monitor and is
/// rethrown here.
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
