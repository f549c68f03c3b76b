// Ctrl-C during long calls that have released the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <thread>

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

}  // namespace abstand::python
