// Statistics of cycle times.
#pragma once

#include <cstdint>
#include <vector>

namespace abstand::scene {

/// Histogram of cycle times in logarithmic bins, each 1 % wider than the one before, from 10 ns to 100 s;
/// other times fall into the outer bins. add() allocates nothing. One thread.
class CycleStatistics {
 public:
  /// `period` (s): longer cycles are overruns; infinity counts none. Throws UsageError unless above 0.
  explicit CycleStatistics(double period);

  /// Adds the time of one cycle (s); NaN and negative values count as 0.
  void add(double seconds);
  void clear();

  /// Quantile of the cycle times (s): not exceeded by the share `share` of all cycles (nearest rank), within
  /// 0.5 % and never outside of the measured range. `share` in [0, 1]. 0 without cycles.
  double quantile(double share) const;
  double median() const { return quantile(0.5); }
  double p99() const { return quantile(0.99); }
  double p999() const { return quantile(0.999); }
  double max() const { return count_ ? max_ : 0.0; }  ///< s, exact
  double min() const { return count_ ? min_ : 0.0; }  ///< s, exact
  double mean() const;                                ///< s
  long count() const { return count_; }
  long overruns() const { return overruns_; }  ///< exact

 private:
  std::vector<std::uint64_t> bins_;
  double period_;
  double min_{0.0}, max_{0.0}, sum_{0.0};
  long count_{0}, overruns_{0};
};

}  // namespace abstand::scene
