// Log of a stop machine: its last state changes with their causes, without allocation.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "core/safety/stop_reason.hpp"

namespace abstand::safety {

enum class StopState : std::uint8_t { kRunning, kSlowing, kProtectiveStop, kEmergencyStop, kWaitingForReset };
inline constexpr std::size_t kStopStates = 5;
std::string_view stateName(StopState state);

/// One change of state.
struct StopEntry {
  double t{0.0};  ///< s
  StopState from{StopState::kRunning}, to{StopState::kRunning};
  StopCause cause;     ///< cause of the highest response; when the state gets lower: the cause that ended
  double lasted{0.0};  ///< s, duration of `from`
};

/// Ring buffer of the last kKept entries. One thread.
class StopLog {
 public:
  static constexpr std::size_t kKept = 256;

  void add(const StopEntry& entry) noexcept { ring_[count_++ % kKept] = entry; }
  std::size_t count() const { return count_; }  ///< total number, including overwritten entries
  std::size_t kept() const { return count_ < kKept ? count_ : kKept; }
  /// Entry i of the kept ones, oldest first.
  const StopEntry& entry(std::size_t i) const { return ring_[(count_ - kept() + i) % kKept]; }

 private:
  std::array<StopEntry, kKept> ring_{};
  std::size_t count_{0};
};

/// Names for the indices in entries; empty functions give numbers.
struct StopNames {
  std::function<std::string(int pair)> pair;
  std::function<std::string(int joint)> joint;
};

/// One line: `12.345 s: running -> protective stop, distance 0.043 m, limit 0.05 m, pair link5 - hand, after
/// 3.2 s`, and when it ends `14.5 s: protective stop -> running, the cause is gone, the robot goes on by
/// itself after 2.1 s; the reason was distance, pair link5 - hand`. Allocates; not for the cycle.
std::string describe(const StopEntry& entry, const StopNames& names = {});

}  // namespace abstand::safety
