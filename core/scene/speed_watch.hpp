// Detects objects that exceed their declared speed bound.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/base/id.hpp"

namespace abstand::scene {

/// A stretch of poses in which an object broke the bound on its speed.
struct SpeedBreach {
  ObjectId object;
  double t;      ///< s, of the first pose that broke it
  double speed;  ///< m/s, the highest of the stretch, of the farthest point
  double bound;  ///< m/s
};

/// Lists the first stretches and counts all. Allocates when it is made only. One thread.
class SpeedWatch {
 public:
  static constexpr std::size_t kMaxListed = 100;
  /// Speeds up to this factor above the bound are within it, for rounding; who relies on a bound adds it.
  static constexpr double kTolerance = 1.0 + 1e-9;

  SpeedWatch() { listed_.reserve(kMaxListed); }

  /// What is known of one object.
  struct State {
    bool broken{false};  ///< at its last pose
    std::size_t entry{kMaxListed};
  };

  /// True when the bound is broken. A step of `way` m (a bound, of the farthest point) in `dt` > 0 s.
  bool add(ObjectId object, double t, double way, double dt, double bound, State& state) {
    const bool broken = way > bound * dt * kTolerance;
    if (broken && !state.broken) {
      ++count_;
      state.entry = listed_.size();
      if (state.entry < kMaxListed) listed_.push_back({object, t, 0.0, bound});
    }
    if (broken && state.entry < kMaxListed)
      listed_[state.entry].speed = std::max(listed_[state.entry].speed, way / dt);
    state.broken = broken;
    return broken;
  }

  const std::vector<SpeedBreach>& listed() const { return listed_; }
  long count() const { return count_; }  ///< stretches

 private:
  std::vector<SpeedBreach> listed_;
  long count_{0};
};

}  // namespace abstand::scene
