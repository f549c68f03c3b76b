// The smallest safe margin of some pairs together, found while the recording runs.
#pragma once

#include "core/margin/safe_margin.hpp"

namespace abstand::tune {

/// SafeMargin with the frame that decides it.
struct MarginNeed {
  double margin{0.0};   ///< m: every margin above it misses no stop; infinite where none would do
  bool decided{false};  ///< some stop would have come too late with a smaller margin
  double t{0.0};        ///< s, when that stop was told
  /// m, one frame before it: certified clearance, the engine's bound, and what is not known of the pose.
  double clearance{0.0}, bound{0.0}, pose{0.0};
  double sampling{0.0};  ///< m, SafeMargin::sampling
};

/// The nearest of some pairs in a frame.
struct NearestPair {
  double clearance{kInfinity}, bound{0.0}, uncertainty{0.0};  ///< m
};

/// One thread.
class NeedWatch {
 public:
  explicit NeedWatch(const margin::MarginOptions& options) : watch_(options) {}

  /// `between`, `braking`: m, the least of the pairs (ClearanceTrack).
  void add(double t, const NearestPair& nearest, double between, double braking);
  const MarginNeed& value() const { return need_; }

 private:
  margin::SafeMarginWatch watch_;
  MarginNeed need_;
  NearestPair before_;
};

}  // namespace abstand::tune
