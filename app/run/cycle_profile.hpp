// How much of a slow cycle is our work, and how much the machine's.
#pragma once

#include "core/scene/cycle_statistics.hpp"

namespace abstand::run {

/// On a shared machine a cycle is late when somebody else has the core. Two measurements tell that apart: the
/// processor time of the cycle, which does not go on while others run, and an empty loop that watches the
/// clock for as long as the cycle worked and does nothing: what it is late by, the machine is. A virtual
/// machine counts as processor time also what its host takes from it; the empty loop's own processor time
/// shows how much that is. One thread.
class CycleProfile {
 public:
  /// `period` (s): longer ones are overruns.
  explicit CycleProfile(double period) : work_(period), empty_(period), empty_work_(period) {}

  void begin();
  /// After the cycle, which took `seconds` by the wall clock; then the empty loop.
  void end(double seconds);

  const scene::CycleStatistics& work() const { return work_; }             ///< processor time
  const scene::CycleStatistics& empty() const { return empty_; }           ///< wall time of the empty loops
  const scene::CycleStatistics& emptyWork() const { return empty_work_; }  ///< their processor time

 private:
  scene::CycleStatistics work_, empty_, empty_work_;
  double begun_{0.0};
};

}  // namespace abstand::run
