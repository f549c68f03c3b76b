// Separates the program's own cycle time from delays caused by the machine.
#pragma once

#include "core/scene/cycle_statistics.hpp"

namespace abstand::run {

/// On a shared machine a cycle may be late because another process uses the core. Two measurements
/// distinguish this: the CPU time of the cycle, which excludes other processes, and an empty loop that polls
/// the clock for as long as the cycle worked: its delay is caused by the machine. A virtual machine also
/// counts time taken by its host as CPU time; the CPU time of the empty loop shows how much. One thread.
class CycleProfile {
 public:
  /// `period` (s): longer cycles are overruns.
  explicit CycleProfile(double period) : work_(period), empty_(period), empty_work_(period) {}

  void begin();
  /// Call after the cycle, which took `seconds` of wall time; runs the empty loop.
  void end(double seconds);

  const scene::CycleStatistics& work() const { return work_; }             ///< CPU time
  const scene::CycleStatistics& empty() const { return empty_; }           ///< wall time of the empty loops
  const scene::CycleStatistics& emptyWork() const { return empty_work_; }  ///< CPU time of the empty loops

 private:
  scene::CycleStatistics work_, empty_, empty_work_;
  double begun_{0.0};
};

}  // namespace abstand::run
