// Finds the smallest safe margin of a group of pairs while the recording runs.
#pragma once

#include "core/margin/safe_margin.hpp"

namespace abstand::tune {

/// SafeMargin with data of the decisive frame.
struct MarginNeed {
  double margin{0.0};   ///< m: every larger margin misses no stop; infinite if none suffices
  bool decided{false};  ///< a stop would have been too late with a smaller margin
  double t{0.0};        ///< s, time of that stop command
  /// m, one frame earlier: certified clearance, the engine's bound, and pose uncertainty.
  double clearance{0.0}, bound{0.0}, pose{0.0};
  double sampling{0.0};  ///< m, SafeMargin::sampling
};

/// The nearest of a group of pairs in a frame.
struct NearestPair {
  double clearance{kInfinity}, bound{0.0}, uncertainty{0.0};  ///< m
};

/// Online version for a group of pairs. One thread.
class NeedWatch {
 public:
  explicit NeedWatch(const margin::MarginOptions& options) : watch_(options) {}

  /// `between`, `braking`: m, minimum over the pairs (ClearanceTrack).
  void add(double t, const NearestPair& nearest, double between, double braking);
  const MarginNeed& value() const { return need_; }

 private:
  margin::SafeMarginWatch watch_;
  MarginNeed need_;
  NearestPair before_;
};

}  // namespace abstand::tune
