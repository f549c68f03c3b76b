// Detects objects that exceed their declared speed bound.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/base/id.hpp"

namespace abstand::scene {

/// A stretch of poses in which an object exceeded its speed bound.
struct SpeedBreach {
  ObjectId object;
  double t;      ///< s, of the first pose that exceeded it
  double speed;  ///< m/s, highest in the stretch, of the farthest point
  double bound;  ///< m/s
};

/// Stores the first stretches and counts all. Allocates only at construction. One thread.
class SpeedWatch {
 public:
  static constexpr std::size_t kMaxListed = 100;
  /// Rounding tolerance: speeds up to this factor of the bound are within it. Users of a bound apply it.
  static constexpr double kTolerance = 1.0 + 1e-9;

  SpeedWatch() { listed_.reserve(kMaxListed); }

  /// State of one object.
  struct State {
    bool broken{false};  ///< exceeded at its last pose
    std::size_t entry{kMaxListed};
  };

  /// Adds a step of `displacement` m (upper bound, of the farthest point) in `dt` > 0 s; true if it exceeds
  /// `bound`.
  bool add(ObjectId object, double t, double displacement, double dt, double bound, State& state) {
    const bool broken = displacement > bound * dt * kTolerance;
    if (broken && !state.broken) {
      ++count_;
      state.entry = listed_.size();
      if (state.entry < kMaxListed) listed_.push_back({object, t, 0.0, bound});
    }
    if (broken && state.entry < kMaxListed)
      listed_[state.entry].speed = std::max(listed_[state.entry].speed, displacement / dt);
    state.broken = broken;
    return broken;
  }

  const std::vector<SpeedBreach>& listed() const { return listed_; }
  long count() const { return count_; }  ///< number of stretches

 private:
  std::vector<SpeedBreach> listed_;
  long count_{0};
};

}  // namespace abstand::scene
