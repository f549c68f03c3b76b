// Looks at the results of the loop's cycles.
#pragma once

#include <cstdint>

namespace abstand::serve {

class ServedScene;

/// Called by the loop's thread. Must not allocate, lock, wait or throw.
class CycleObserver {
 public:
  CycleObserver() = default;
  CycleObserver(const CycleObserver&) = delete;
  CycleObserver& operator=(const CycleObserver&) = delete;
  virtual ~CycleObserver() = default;

  /// After each answer, and at least every 50 ms. `now`: s, clock of the server. `cycles`: number of cycles
  /// so far. `scene` shows the last one.
  virtual void look(double now, std::uint64_t cycles, ServedScene& scene) noexcept = 0;
};

}  // namespace abstand::serve
